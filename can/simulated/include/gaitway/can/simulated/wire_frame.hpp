// A frame as its sender puts it on the wire, bit by bit with its stuff bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "gaitway/can/frame.hpp"

namespace gaitway::can {

class WireFrame {
 public:
  WireFrame() = default;
  explicit WireFrame(const Frame& frame) noexcept;

  // Bits from start of frame (0) to the last bit of end-of-frame: frame_bits().
  [[nodiscard]] int length() const noexcept { return length_; }
  [[nodiscard]] bool dominant(int bit) const noexcept { return !test(recessive_, bit); }
  [[nodiscard]] bool is_stuff_bit(int bit) const noexcept { return test(stuff_, bit); }
  // The first bit behind the arbitration field (which ends with RTR).
  [[nodiscard]] int arbitration_end() const noexcept { return arbitration_end_; }
  // Sent as recessive; receivers answer dominant.
  [[nodiscard]] int acknowledge_slot() const noexcept { return acknowledge_slot_; }

 private:
  static constexpr std::size_t kWords = 3;  // the longest frame has 157 bits
  using Bits = std::array<std::uint64_t, kWords>;
  static bool test(const Bits& bits, int bit) noexcept {
    const auto place = static_cast<unsigned>(bit);
    return ((bits[place / 64U] >> (place % 64U)) & 1U) != 0;
  }
  static void set(Bits& bits, int bit) noexcept {
    const auto place = static_cast<unsigned>(bit);
    bits[place / 64U] |= std::uint64_t{1} << (place % 64U);
  }
  void append(unsigned value, int width) noexcept;  // stuffed, the highest bit first

  Bits recessive_{};
  Bits stuff_{};
  int length_ = 0;
  int arbitration_end_ = 0;
  int acknowledge_slot_ = 0;
  int run_ = 0;  // equal bits at the end so far
};

}  // namespace gaitway::can
