// A number that tells runs apart which differ in a single bit.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "gaitway/can/frame.hpp"

namespace gaitway::simulator {

// A 64-bit hash over everything that a run did: two runs are the same to the bit when their digests are.
class RunDigest {
 public:
  void add(std::uint64_t word) noexcept {
    // One round of a multiply-xorshift mix (Steele, Lea, Flood 2014) a word, chained.
    state_ ^= word;
    state_ *= 0xBF58'476D'1CE4'E5B9ULL;
    state_ ^= state_ >> 29U;
  }
  void add(std::span<const double> values) noexcept {
    for (const double value : values) {
      add(std::bit_cast<std::uint64_t>(value));
    }
  }
  void add(const can::Frame& frame, std::int64_t start_ns) noexcept {
    add(std::bit_cast<std::uint64_t>(frame.data));
    add((std::uint64_t{frame.id} << 8U) | frame.size);
    add(static_cast<std::uint64_t>(start_ns));
  }
  [[nodiscard]] std::uint64_t value() const noexcept { return state_; }

 private:
  std::uint64_t state_ = 0x9E37'79B9'7F4A'7C15ULL;
};

}  // namespace gaitway::simulator
