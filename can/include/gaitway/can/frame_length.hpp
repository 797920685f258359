// How long a frame is on the wire, to the bit: CRC-15 and stuff bits are computed, not estimated. All four
// formats of classic CAN: base or extended identifier, data or remote frame. Freestanding.
#pragma once

#include <cstdint>

#include "gaitway/can/frame.hpp"

namespace gaitway::can {

inline constexpr int kInterframeBits = 3;
inline constexpr int kTrailerBits = 10;  // CRC delimiter, ACK slot, ACK delimiter, end of frame (7)

// CRC-15 of the frame (polynomial 0x4599) over start of frame to the last data bit, without stuff bits.
[[nodiscard]] std::uint16_t crc15(const Frame& frame) noexcept;

// Bits from start of frame to the last bit of end-of-frame, stuff bits included, interframe space not.
[[nodiscard]] int frame_bits(const Frame& frame) noexcept;

// Longest possible frame of `size` data bytes, interframe space included (Davis, Burns, Bril, Lukkien 2007):
// g + 8s + 13 + floor((g + 8s - 1) / 4), g = 34 with an 11-bit identifier and 54 with one of 29 bits. 135 or
// 160 bits for 8 bytes. A remote frame is as long as a data frame without data.
[[nodiscard]] constexpr int worst_case_bits(int size, bool extended = false) noexcept {
  const int stuffable = (extended ? 54 : 34) + 8 * size;
  return stuffable + 13 + (stuffable - 1) / 4;
}

}  // namespace gaitway::can
