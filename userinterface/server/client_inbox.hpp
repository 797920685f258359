// What one client has sent and nobody has looked at yet: bounded, since nothing is read from it while there
// is no room.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>

namespace gaitway::api {

class ClientInbox {
 public:
  struct Message {
    std::string text;
    bool binary = false;
    std::int64_t sent_after_ns = 0;  // it was
    bool overtaken = false;          // an urgent one that came after it has been taken already
    bool urgent = false;             // but too many of them had overtaken others
  };

  // Another message is read while fewer bytes wait, and fewer messages that are not urgent: so one message
  // more may come. An emergency may be behind many urgent ones, and be taken once it has been read.
  explicit ClientInbox(std::size_t most_bytes) noexcept : most_bytes_(most_bytes) {}

  void put(std::string_view text, bool binary, std::int64_t sent_after_ns, bool urgent) {
    bytes_ += text.size() + kBytesBeside;
    ordinary_ += urgent ? 0 : 1;
    messages_.push_back({std::string(text), binary, sent_after_ns, false, urgent});
  }
  // The oldest; not when it is empty.
  [[nodiscard]] Message take() {
    Message message = std::move(messages_.front());
    messages_.pop_front();
    bytes_ -= message.text.size() + kBytesBeside;
    ordinary_ -= message.urgent ? 0 : 1;
    return message;
  }
  // All that waits now has been overtaken.
  void overtake() {
    for (Message& message : messages_) {
      message.overtaken = true;
    }
  }
  void clear() {
    messages_.clear();
    bytes_ = ordinary_ = 0;
  }

  [[nodiscard]] bool empty() const noexcept { return messages_.empty(); }
  [[nodiscard]] bool has_room() const noexcept { return bytes_ < most_bytes_ && ordinary_ < kMostOrdinary; }

 private:
  static constexpr std::size_t kMostOrdinary = 32;
  static constexpr std::size_t kBytesBeside = 128;  // a message costs so much beside its text

  std::size_t most_bytes_;
  std::size_t bytes_ = 0, ordinary_ = 0;
  std::deque<Message> messages_;
};

}  // namespace gaitway::api
