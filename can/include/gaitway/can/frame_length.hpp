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

// Longest possible frame of `size` data bytes with an 11-bit identifier, interframe space included
// (Davis, Burns, Bril, Lukkien 2007): g + 8s + 13 + floor((g + 8s - 1) / 4), g = 34. 135 bits for 8 bytes.
[[nodiscard]] constexpr int worst_case_bits(int size) noexcept {
  constexpr int kStuffable = 34;
  return kStuffable + 8 * size + 13 + (kStuffable + 8 * size - 1) / 4;
}

}  // namespace gaitway::can
