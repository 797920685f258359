// Go back to the first part that is not confirmed: on a carrier that keeps the order nothing simpler is
// better.
#include "gaitway/link/message_lane.hpp"

#include <algorithm>
#include <utility>

namespace gaitway::link {

std::uint32_t MessageSender::push(Bytes head, Bytes body) noexcept {
  const std::size_t size = head.size() + body.size();
  if (end_ - confirmed_.message >= kLaneMessages || size > kMostMessageBytes) {
    return 0;
  }
  Message& message = at(end_);
  std::ranges::copy(body, std::ranges::copy(head, message.bytes.begin()).out);
  message.size = size;
  return end_++;
}

std::optional<Part> MessageSender::next(std::int64_t now_ns) noexcept {
  if (confirmed_ < cursor_ && now_ns - progress_ns_ >= resend_after_ns_) {
    cursor_ = confirmed_;
    ++resends_;
  }
  if (cursor_.message == end_ || cursor_.message > limit_) {
    return std::nullopt;
  }
  if (cursor_ == confirmed_) {
    progress_ns_ = now_ns;
  }
  const Message& message = at(cursor_.message);
  const std::size_t offset = cursor_.part * fragment_bytes_;
  const Part part{cursor_.message, cursor_.part, parts_of(message),
                  Bytes(message.bytes).subspan(offset, std::min(fragment_bytes_, message.size - offset))};
  cursor_ = part.part + 1 == part.parts
                ? LanePosition{cursor_.message + 1, 0}
                : LanePosition{cursor_.message, static_cast<std::uint8_t>(cursor_.part + 1)};
  furthest_ = std::max(furthest_, cursor_);
  return part;
}

void MessageSender::confirm(LanePosition received, std::uint32_t message_limit,
                            std::int64_t now_ns) noexcept {
  limit_ = std::max(limit_, message_limit);
  if (received > furthest_ || received <= confirmed_ ||
      (received.part > 0 && received.part >= parts_of(at(received.message)))) {
    return;  // older news, or of what was never sent
  }
  confirmed_ = received;
  cursor_ = std::max(cursor_, confirmed_);
  progress_ns_ = now_ns;
}

void MessageSender::reset() noexcept {
  end_ = 1;
  limit_ = 0;
  confirmed_ = cursor_ = furthest_ = {};
}

std::optional<Bytes> MessageReceiver::take(const Part& part, std::uint32_t limit) noexcept {
  const LanePosition position{part.message, part.part};
  if (position < next_) {
    ++repeated_;
    return std::nullopt;
  }
  if (position > next_ || part.message > limit || size_ + part.payload.size() > bytes_.size()) {
    ++early_;
    return std::nullopt;
  }
  std::ranges::copy(part.payload, bytes_.begin() + static_cast<std::ptrdiff_t>(size_));
  size_ += part.payload.size();
  if (part.part + 1 < part.parts) {
    ++next_.part;
    return std::nullopt;
  }
  next_ = {part.message + 1, 0};
  return Bytes(bytes_).first(std::exchange(size_, 0));
}

void MessageReceiver::reset() noexcept {
  next_ = {};
  size_ = 0;
}

}  // namespace gaitway::link
