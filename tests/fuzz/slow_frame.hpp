// A frame on the wire, slowly: bit by bit as ISO 11898-1 writes it down. What the fast ones are compared
// with.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gaitway/can/frame.hpp"

namespace gaitway::fuzz {

using Bits = std::vector<int>;  // 0 dominant, 1 recessive

inline void append(Bits& bits, std::uint32_t value, int width) {
  for (int bit = width - 1; bit >= 0; --bit) {
    bits.push_back(static_cast<int>((value >> static_cast<unsigned>(bit)) & 1U));
  }
}

// Start of frame to the last data bit, without stuff bits.
inline Bits slow_fields(const can::Frame& frame) {
  Bits bits;
  const std::uint32_t remote = frame.remote ? 1U : 0U;
  append(bits, 0, 1);  // start of frame
  if (frame.extended) {
    append(bits, frame.id >> 18U, 11);
    append(bits, 3, 2);  // SRR, IDE
    append(bits, frame.id & 0x3'FFFFU, 18);
    append(bits, remote, 1);
    append(bits, 0, 2);  // r1, r0
  } else {
    append(bits, frame.id, 11);
    append(bits, remote, 1);
    append(bits, 0, 2);  // IDE, r0
  }
  append(bits, frame.size, 4);
  for (const std::uint8_t byte : frame.payload()) {
    append(bits, byte, 8);
  }
  return bits;
}

// The register of the standard: shift left, and subtract the polynomial when the bit that falls out differs.
inline std::uint32_t slow_crc(std::span<const int> bits) {
  std::uint32_t crc = 0;
  for (const int bit : bits) {
    const bool subtract = bit != static_cast<int>((crc >> 14U) & 1U);
    crc = (crc << 1U) & 0x7FFFU;
    crc ^= subtract ? 0x4599U : 0U;
  }
  return crc;
}

// After five equal bits, one of the other value.
inline Bits stuffed(std::span<const int> bits) {
  Bits result;
  int last = -1, run = 0;
  for (const int bit : bits) {
    result.push_back(bit);
    run = bit == last ? run + 1 : 1;
    last = bit;
    if (run == 5) {
      last = 1 - bit;  // begins a run of its own
      run = 1;
      result.push_back(last);
    }
  }
  return result;
}

// The whole frame as its sender puts it on the wire.
inline Bits slow_wire(const can::Frame& frame) {
  constexpr int kTrailer = 10;  // CRC delimiter, ACK slot and delimiter, end of frame: recessive
  Bits bits = slow_fields(frame);
  append(bits, slow_crc(bits), 15);
  bits = stuffed(bits);
  bits.insert(bits.end(), kTrailer, 1);
  return bits;
}

}  // namespace gaitway::fuzz
