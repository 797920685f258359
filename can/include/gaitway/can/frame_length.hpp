// How long a data frame is on the wire, to the bit: CRC-15 and stuff bits are computed, not estimated.
// Freestanding.
#pragma once

#include <cstdint>

#include "gaitway/can/frame.hpp"

namespace gaitway::can {

inline constexpr int kInterframeBits = 3;

// CRC-15 of the frame (polynomial 0x4599) over start of frame to the last data bit, without stuff bits.
[[nodiscard]] std::uint16_t crc15(const Frame& frame) noexcept;

// Bits from start of frame to the last bit of end-of-frame, stuff bits included, interframe space not.
[[nodiscard]] int frame_bits(const Frame& frame) noexcept;

// Longest possible frame of `size` data bytes, interframe space included (Davis, Burns, Bril, Lukkien 2007):
// g + 8s + 13 + floor((g + 8s - 1) / 4) with g = 34 for an 11-bit identifier and 54 for a 29-bit one. 135 and
// 160 bits for 8 bytes.
[[nodiscard]] constexpr int worst_case_bits(int size, bool extended = false) noexcept {
  const int stuffable = (extended ? 54 : 34) + 8 * size;
  return stuffable + 13 + (stuffable - 1) / 4;
}

}  // namespace gaitway::can
