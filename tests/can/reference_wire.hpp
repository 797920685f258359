// A frame's bits on the wire and a bus of wired AND, written down field by field and bit by bit as the
// standard reads: slow, and independent of what it is to check.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "gaitway/can/frame.hpp"

namespace gaitway::can::reference {

using Bits = std::vector<bool>;  // true: recessive

inline void append(Bits& bits, unsigned value, int width) {
  for (int bit = width - 1; bit >= 0; --bit) {
    bits.push_back(((value >> static_cast<unsigned>(bit)) & 1U) != 0);
  }
}

inline Bits header_and_data(const Frame& frame) {
  Bits bits{false};  // start of frame
  if (frame.extended) {
    append(bits, frame.id >> 18U, 11);
    append(bits, 1, 1);  // SRR
    append(bits, 1, 1);  // IDE
    append(bits, frame.id % (1U << 18U), 18);
    append(bits, frame.remote ? 1 : 0, 1);  // RTR
    append(bits, 0, 2);                     // r1, r0
  } else {
    append(bits, frame.id, 11);
    append(bits, frame.remote ? 1 : 0, 1);  // RTR
    append(bits, 0, 1);                     // IDE
    append(bits, 0, 1);                     // r0
  }
  append(bits, frame.size, 4);
  for (std::size_t byte = 0; !frame.remote && byte < frame.size; ++byte) {
    append(bits, frame.data[byte], 8);
  }
  return bits;
}

// As in the CAN specification (Bosch, 2.0A, 3.1.1): one bit at a time.
inline unsigned crc(const Bits& bits) {
  unsigned crc = 0;
  for (const bool bit : bits) {
    const bool next = bit != ((crc & 0x4000U) != 0);
    crc = (crc << 1U) & 0x7FFFU;
    if (next) {
      crc ^= 0x4599U;
    }
  }
  return crc;
}

inline Bits stuffed(const Bits& bits) {
  Bits wire;
  int run = 0;
  for (const bool bit : bits) {
    run = !wire.empty() && wire.back() == bit ? run + 1 : 1;
    wire.push_back(bit);
    if (run == 5) {
      wire.push_back(!bit);
      run = 1;
    }
  }
  return wire;
}

// From start of frame to the last bit of end-of-frame.
inline Bits wire(const Frame& frame) {
  Bits bits = header_and_data(frame);
  append(bits, crc(bits), 15);
  Bits all = stuffed(bits);
  append(all, 0x3FF, 10);  // CRC delimiter, ACK slot and delimiter, end of frame
  return all;
}

// Which of the frames that start together goes on to its end, none sending the same bits as another: each
// stops where it sends recessive and the bus is dominant.
inline std::size_t arbitrate(const std::vector<Frame>& frames) {
  std::vector<Bits> wires;
  std::vector<std::size_t> left;
  for (const Frame& frame : frames) {
    left.push_back(left.size());
    wires.push_back(wire(frame));
  }
  for (std::size_t bit = 0; left.size() > 1; ++bit) {
    const bool bus =
        std::all_of(left.begin(), left.end(), [&](std::size_t i) { return bool{wires[i].at(bit)}; });
    std::erase_if(left, [&](std::size_t i) { return wires[i].at(bit) != bus; });
  }
  return left.front();
}

// Of any format, often with long runs of equal bits.
inline Frame draw_frame(std::mt19937& random) {
  constexpr std::array<std::uint8_t, 6> kLongRuns{0x00, 0xFF, 0xF0, 0x0F, 0x83, 0x7C};
  Frame frame;
  frame.extended = random() % 2 == 0;
  frame.remote = random() % 4 == 0;
  frame.id = static_cast<std::uint32_t>(random()) & (frame.extended ? kLargestExtendedId : kLargestId);
  frame.size = static_cast<std::uint8_t>(random() % 9);
  const auto how = random() % 4;
  for (std::uint8_t& byte : frame.data) {
    const auto value = random();
    byte = how == 0   ? static_cast<std::uint8_t>(value)
           : how == 1 ? kLongRuns[value % kLongRuns.size()]
           : how == 2 ? std::uint8_t{0}
                      : static_cast<std::uint8_t>(value % 5);
  }
  if (how == 3) {
    frame.id &= 0x1041'0041U & (frame.extended ? kLargestExtendedId : kLargestId);
  }
  return frame;
}

}  // namespace gaitway::can::reference
