// One way to hand the newest value of a topic from its writer to its reader: ours, or a peer's.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace gaitway::peers {

class TopicRival {
 public:
  explicit TopicRival(std::string name) : name_(std::move(name)) {}
  TopicRival(const TopicRival&) = delete;
  TopicRival& operator=(const TopicRival&) = delete;
  virtual ~TopicRival() = default;
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

  // Writes the value and reads it again, `pairs` times; its first word is another one each time. How often
  // the reader had what the writer wrote.
  [[nodiscard]] virtual std::size_t write_and_read(std::size_t pairs) = 0;

 private:
  std::string name_;
};

std::unique_ptr<TopicRival> our_topic(std::size_t bytes);
// One slot and a sequence that is odd while it is written; no second writer is refused, nothing is declared.
std::unique_ptr<TopicRival> seqlock_topic(std::size_t bytes);
// iceoryx with RouDi in this process. Its reader takes a pointer to the chunk and copies nothing. One at a
// time.
std::unique_ptr<TopicRival> iceoryx_topic(std::size_t bytes);

}  // namespace gaitway::peers
