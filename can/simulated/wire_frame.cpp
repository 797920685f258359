// Puts a frame's fields in their order on the wire, with stuff bits (ISO 11898-1).
#include "gaitway/can/simulated/wire_frame.hpp"

#include <algorithm>

namespace gaitway::can {
namespace {

constexpr unsigned kPolynomial = 0x4599;
constexpr int kCrcBits = 15;
// Places in the frame without stuff bits, start of frame being 0.
constexpr int kRemotePlace = 12;  // or SRR
constexpr int kExtendedPlace = 13;
constexpr int kCodeEnd = 19;  // of the data length code
constexpr int kExtendedRemotePlace = 32;
constexpr int kExtendedCodeEnd = 39;
// Places behind the CRC, the CRC delimiter being 0.
constexpr int kAcknowledgeSlot = 1;
constexpr int kAcknowledgeDelimiter = 2;
constexpr int kLastButOne = 8;
constexpr int kLast = 9;

}  // namespace

WireFrame::WireFrame(const Frame& frame) noexcept {
  const unsigned remote = frame.remote ? 1U : 0U;
  append(0, 1);  // start of frame
  if (frame.extended) {
    append(frame.id >> 18U, 11);
    append(3, 2);  // SRR, IDE
    append(frame.id & 0x3'FFFFU, 18);
    append(remote, 1);
    arbitration_end_ = length_;
    append(0, 2);  // r1, r0
  } else {
    append(frame.id, 11);
    append(remote, 1);
    arbitration_end_ = length_;
    append(0, 2);  // IDE, r0
  }
  append(frame.size, 4);
  for (const std::uint8_t byte : frame.payload()) {
    append(byte, 8);
  }
  append(crc15(frame), 15);
  acknowledge_slot_ = length_ + 1;
  for (int bit = 0; bit < kTrailerBits; ++bit) {
    set(recessive_, length_++);
  }
}

void WireFrame::append(unsigned value, int width) noexcept {
  for (int bit = width - 1; bit >= 0; --bit) {
    const bool recessive = ((value >> static_cast<unsigned>(bit)) & 1U) != 0;
    run_ = length_ > 0 && recessive != dominant(length_ - 1) ? run_ + 1 : 1;
    if (recessive) {
      set(recessive_, length_);
    }
    ++length_;
    if (run_ == 5) {
      set(stuff_, length_);
      if (!recessive) {
        set(recessive_, length_);
      }
      ++length_;
      run_ = 1;
    }
  }
}

FrameReader::Step FrameReader::take(bool dominant) noexcept {
  if (trailer_ >= 0) {
    return take_trailer_bit(dominant);
  }
  const bool equal = run_ > 0 && dominant == last_dominant_;
  const bool stuff_bit = run_ == 5;
  if (stuff_bit && equal) {
    return Step::stuff_error;
  }
  run_ = equal ? static_cast<std::uint8_t>(run_ + 1U) : std::uint8_t{1};
  last_dominant_ = dominant;
  if (!stuff_bit) {
    take_field_bit(dominant);
  }
  if (field_bits_end_ != 0 && field_bits_ == field_bits_end_ && run_ < 5) {
    trailer_ = 0;
  }
  return Step::more;
}

void FrameReader::take_field_bit(bool dominant) noexcept {
  const int place = field_bits_++;
  const unsigned bit = dominant ? 0U : 1U;
  const bool feedback = (((crc_ >> 14U) & 1U) ^ bit) != 0;
  const unsigned shifted = (static_cast<unsigned>(crc_) << 1U) & 0x7FFFU;
  crc_ = static_cast<std::uint16_t>(feedback ? shifted ^ kPolynomial : shifted);
  if (field_bits_end_ != 0) {
    return;
  }
  if (place == kExtendedPlace) {
    extended_ = !dominant;
  } else if (place == kRemotePlace || (extended_ && place == kExtendedRemotePlace)) {
    remote_ = !dominant;
  }
  const int code_end = extended_ ? kExtendedCodeEnd : kCodeEnd;
  if (place >= code_end - 4 && place > kExtendedPlace) {
    data_length_code_ = static_cast<std::uint8_t>(data_length_code_ * 2U + bit);
  }
  if (place == code_end - 1) {
    const int bytes = remote_ ? 0 : std::min<int>(data_length_code_, 8);
    field_bits_end_ = static_cast<std::uint8_t>(code_end + 8 * bytes + kCrcBits);
  }
}

FrameReader::Step FrameReader::take_trailer_bit(bool dominant) noexcept {
  const int place = trailer_++;
  if (place == kAcknowledgeSlot) {
    return Step::more;
  }
  if (place == kLast) {
    return dominant ? Step::overload : Step::complete;
  }
  if (dominant) {
    return Step::form_error;
  }
  if (place == kAcknowledgeDelimiter && crc_ != 0) {
    return Step::crc_error;
  }
  return place == kLastButOne ? Step::valid : Step::more;
}

}  // namespace gaitway::can
