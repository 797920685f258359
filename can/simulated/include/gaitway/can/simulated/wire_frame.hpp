// A frame bit by bit, with its stuff bits: as its sender puts it on the wire, and as a receiver follows it
// there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "gaitway/can/frame.hpp"

namespace gaitway::can {

// As its sender puts it on the wire.
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

// Takes the stuff bits out, checks them, the CRC and the fields of fixed form (ISO 11898-1, error detection).
class FrameReader {
 public:
  enum class Step : std::uint8_t {
    more,
    stuff_error,  // six equal bits where stuffing rules them out
    form_error,   // a dominant bit in a delimiter or in end-of-frame
    crc_error,    // told at the ACK delimiter, as the standard has it
    valid,        // the last but one bit of end-of-frame: this receiver has the frame
    complete,     // the last bit of end-of-frame
    overload      // the last bit of end-of-frame is dominant: no error to a receiver
  };

  void start() noexcept { *this = {}; }
  // The next bit as this receiver sees it; the first is start of frame. Not after an error or completion.
  Step take(bool dominant) noexcept;
  // The next bit is the ACK slot, and the frame has come well so far.
  [[nodiscard]] bool acknowledges() const noexcept { return trailer_ == 1 && crc_ == 0; }

 private:
  void take_field_bit(bool dominant) noexcept;
  Step take_trailer_bit(bool dominant) noexcept;

  std::uint8_t run_ = 0;  // equal bits at the end so far
  bool last_dominant_ = false;
  bool extended_ = false;
  bool remote_ = false;
  std::uint8_t field_bits_ = 0;      // without stuff bits
  std::uint8_t field_bits_end_ = 0;  // how many come until the CRC's last; 0 while not known
  std::uint8_t data_length_code_ = 0;
  std::int8_t trailer_ = -1;  // bits since the CRC's last; -1 before
  std::uint16_t crc_ = 0;     // zero after the CRC's last bit of an undisturbed frame
};

}  // namespace gaitway::can
