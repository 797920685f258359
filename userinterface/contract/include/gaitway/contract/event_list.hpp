// The newest events, each with its number, so that none is told twice and it is known which are lost.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "gaitway/contract/topic_codec.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::contract {

//   the number of the first (7 bits a byte, as whole numbers in topic_codec.hpp), how many, the events
class EventList {
 public:
  static constexpr std::size_t kKept = 8;

  void add(const Event& event) noexcept { kept_[++last_ % kKept] = event; }
  // Numbers of those that it holds: from first() to last(), counted from 1; last() 0: none.
  [[nodiscard]] std::uint64_t last() const noexcept { return last_; }
  [[nodiscard]] std::uint64_t first() const noexcept { return last_ <= kKept ? 1 : last_ - kKept + 1; }
  [[nodiscard]] const Event& event(std::uint64_t number) const noexcept { return kept_[number % kKept]; }

  // Into `room`; returns the bytes, 0 when they do not fit.
  std::size_t encode(const TopicCodec& codec, std::span<std::uint8_t> room) const noexcept;
  // Nothing: the bytes are no list.
  static std::optional<EventList> decode(const TopicCodec& codec,
                                         std::span<const std::uint8_t> bytes) noexcept;
  [[nodiscard]] static std::size_t most_bytes(const TopicCodec& codec) noexcept;

 private:
  std::array<Event, kKept> kept_{};  // event n at n modulo their number
  std::uint64_t last_ = 0;
};

}  // namespace gaitway::contract
