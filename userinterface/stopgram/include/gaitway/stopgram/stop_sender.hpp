// A client of stop datagrams: says a stop until the robot has obeyed it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/facts/facts.hpp"
#include "gaitway/stopgram/datagrams.hpp"
#include "gaitway/stopgram/stop_key.hpp"

namespace gaitway::stopgram {

enum class StopState : std::uint8_t { none, asked, heard, obeyed };

// Passive: is told the time, and owns no thread and no socket. Neither allocates nor throws after its
// construction.
class StopSender {
 public:
  static constexpr std::int64_t kRepeat_ns = 10 * facts::kMillisecond_ns;
  static constexpr std::int64_t kGreet_ns = facts::kSecond_ns;  // while nothing is asked

  // `client`: random_identity().
  StopSender(StopKey key, std::uint64_t client) noexcept : key_(std::move(key)), client_(client) {}

  // Is said until it is obeyed. One of the same kind that is not obeyed yet gives way to it.
  void stop(StopKind kind) noexcept;
  // What to send now, until there is nothing; valid until the next call.
  Bytes next(std::int64_t now_ns) noexcept;
  // When next() has something again; may have passed.
  [[nodiscard]] std::int64_t next_due_ns() const noexcept;
  void on_datagram(Bytes datagram, std::int64_t now_ns) noexcept;

  // Of the newest stop of this kind.
  [[nodiscard]] StopState state(StopKind kind) const noexcept {
    return stops_[static_cast<std::size_t>(kind)].state;
  }
  // The desk has answered a greeting: a stop needs no greeting first.
  [[nodiscard]] bool acquainted() const noexcept { return welcome_.has_value(); }
  // For how long questions have had no answer.
  [[nodiscard]] std::int64_t unanswered_ns(std::int64_t now_ns) const noexcept {
    return asked_ns_ ? now_ns - *asked_ns_ : 0;
  }

 private:
  struct Asked {
    std::uint32_t number = 0;
    StopState state = StopState::none;
    std::optional<std::int64_t> said_ns;
    [[nodiscard]] bool open() const noexcept {
      return state == StopState::asked || state == StopState::heard;
    }
  };
  [[nodiscard]] bool any_open() const noexcept;
  [[nodiscard]] std::int64_t greeting_due_ns() const noexcept;

  StopKey key_;
  std::uint64_t client_;
  std::optional<Welcome> welcome_;
  std::uint32_t greeting_ = 1;
  std::optional<std::int64_t> greeted_ns_, asked_ns_;
  std::uint32_t last_number_ = 0;
  std::array<Asked, kStopKinds> stops_{};
  std::array<std::uint8_t, kMostDatagramBytes> datagram_{};
};

}  // namespace gaitway::stopgram
