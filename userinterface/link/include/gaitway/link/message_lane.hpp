// Messages that arrive whole, once and in their order within a session: orders one way, answers the other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "gaitway/link/messages.hpp"

namespace gaitway::link {

inline constexpr std::size_t kMostMessageBytes = 1024;
inline constexpr std::uint32_t kLaneMessages = 32;  // under way at a time

// How far a lane has come: `part` parts of message number `message`, and all messages before it.
struct LanePosition {
  std::uint32_t message = 1;
  std::uint8_t part = 0;
  auto operator<=>(const LanePosition&) const = default;  // NOLINT(modernize-use-nullptr): a false alarm
};

// Sends in order, keeps what is not confirmed, and goes back to it when no confirmation comes. Holds
// kLaneMessages messages; does not allocate.
class MessageSender {
 public:
  MessageSender(std::size_t fragment_bytes, std::int64_t resend_after_ns) noexcept
      : fragment_bytes_(fragment_bytes), resend_after_ns_(resend_after_ns) {}

  // The message's number, which is `head` and `body` one behind the other. 0: the lane is full, or the
  // message is too long; nothing has changed.
  std::uint32_t push(Bytes head, Bytes body) noexcept;
  // The next part for the wire, valid until the lane changes. Nothing: all is sent, or the receiver has no
  // room.
  std::optional<Part> next(std::int64_t now_ns) noexcept;
  // What the receiver has, and up to which message it has room. Older news than before, and what was never
  // sent, change nothing.
  void confirm(LanePosition received, std::uint32_t message_limit, std::int64_t now_ns) noexcept;
  // For a new session: all is forgotten, numbers begin at 1.
  void reset() noexcept;

  [[nodiscard]] std::uint32_t confirmed() const noexcept { return confirmed_.message - 1; }  // complete ones
  [[nodiscard]] std::uint64_t resends() const noexcept { return resends_; }

 private:
  struct Message {
    std::array<std::uint8_t, kMostMessageBytes> bytes{};
    std::size_t size = 0;
  };
  [[nodiscard]] Message& at(std::uint32_t number) noexcept { return messages_[number % kLaneMessages]; }
  [[nodiscard]] std::uint8_t parts_of(const Message& message) const noexcept {
    return static_cast<std::uint8_t>(fragments_of(message.size, fragment_bytes_));
  }

  std::size_t fragment_bytes_;
  std::int64_t resend_after_ns_;
  std::array<Message, kLaneMessages> messages_{};
  std::uint32_t end_ = 1;  // number of the next message to be pushed
  std::uint32_t limit_ = 0;
  LanePosition confirmed_, cursor_, furthest_;
  std::int64_t progress_ns_ = 0;  // of the confirmation, or of the first part under way
  std::uint64_t resends_ = 0;
};

static_assert(fragments_of(kMostMessageBytes, 8) <= 255, "parts are counted by a byte");

// Takes parts in order only. Does not allocate.
class MessageReceiver {
 public:
  // The message that this part completes; it is valid until the next call. Parts of messages beyond `limit`,
  // and all but the next one, are left out: they will be sent again.
  std::optional<Bytes> take(const Part& part, std::uint32_t limit) noexcept;
  void reset() noexcept;

  [[nodiscard]] LanePosition position() const noexcept { return next_; }
  [[nodiscard]] std::uint64_t repeated() const noexcept { return repeated_; }  // had come already
  [[nodiscard]] std::uint64_t early() const noexcept { return early_; }        // something before them lacks

 private:
  LanePosition next_;
  std::array<std::uint8_t, kMostMessageBytes> bytes_{};
  std::size_t size_ = 0;
  std::uint64_t repeated_ = 0, early_ = 0;
};

}  // namespace gaitway::link
