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
  };

  // Another message is read while fewer bytes, and fewer messages, wait: so one message more may come.
  explicit ClientInbox(std::size_t most_bytes) noexcept : most_bytes_(most_bytes) {}

  void put(std::string_view text, bool binary, std::int64_t sent_after_ns) {
    bytes_ += text.size();
    messages_.push_back({std::string(text), binary, sent_after_ns, false});
  }
  // The oldest; not when it is empty.
  [[nodiscard]] Message take() {
    Message message = std::move(messages_.front());
    messages_.pop_front();
    bytes_ -= message.text.size();
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
    bytes_ = 0;
  }

  [[nodiscard]] bool empty() const noexcept { return messages_.empty(); }
  [[nodiscard]] bool has_room() const noexcept {
    return bytes_ < most_bytes_ && messages_.size() < kMostMessages;
  }

 private:
  static constexpr std::size_t kMostMessages = 32;

  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  std::deque<Message> messages_;
};

}  // namespace gaitway::api
