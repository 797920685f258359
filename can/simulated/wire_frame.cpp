// Puts a frame's fields in their order on the wire, with stuff bits (ISO 11898-1).
#include "gaitway/can/simulated/wire_frame.hpp"

#include "gaitway/can/frame.hpp"

namespace gaitway::can {

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

}  // namespace gaitway::can
