// How a receiver follows a frame, bit by bit: it takes the stuff bits out, checks them, the CRC and the
// fields of fixed form (ISO 11898-1, error detection).
#pragma once

#include <cstdint>

namespace gaitway::can {

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
