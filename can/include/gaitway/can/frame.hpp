// A classic CAN frame, the unit that everything on the bus is made of, and its length on the wire, to the
// bit: CRC-15 and stuff bits are computed, not estimated. The robot's own messages are data frames with an
// 11-bit identifier; the other formats exist because a bus can carry them. Freestanding.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace gaitway::can {

struct Frame {
  std::uint32_t id = 0;   // 0..0x7FF, or 0..0x1FFF'FFFF when extended; the lower, the higher its priority
  std::uint8_t size = 0;  // 0..8: number of valid bytes in data; of a remote frame: how many it asks for
  std::array<std::uint8_t, 8> data{};
  bool extended = false;  // 29-bit identifier
  bool remote = false;    // asks for data and carries none

  friend bool operator==(const Frame&, const Frame&) = default;
  [[nodiscard]] std::span<const std::uint8_t> payload() const noexcept {
    return {data.data(), remote ? std::size_t{0} : size};
  }
};

inline constexpr std::uint32_t kLargestId = 0x7FF;
inline constexpr std::uint32_t kLargestExtendedId = 0x1FFF'FFFF;

// Identifier and size are ones that a frame can have.
[[nodiscard]] constexpr bool is_valid(const Frame& frame) noexcept {
  return frame.id <= (frame.extended ? kLargestExtendedId : kLargestId) && frame.size <= 8;
}

// The bits that take part in arbitration, the first on the wire as the highest: of two frames that start
// together, the one with the smaller key wins (ISO 11898-1). The eleven leading identifier bits are followed
// by RTR and IDE of a base frame, or by SRR, IDE, the other 18 bits and RTR of an extended one.
[[nodiscard]] constexpr std::uint32_t arbitration_key(const Frame& frame) noexcept {
  const std::uint32_t remote = frame.remote ? 1U : 0U;
  if (!frame.extended) {
    return (frame.id << 21U) | (remote << 20U);
  }
  return ((frame.id >> 18U) << 21U) | (3U << 19U) | ((frame.id & 0x3'FFFFU) << 1U) | remote;
}

inline constexpr int kInterframeBits = 3;
inline constexpr int kSuspendBits =
    8;  // that an error-passive station waits besides, after a frame of its own
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
