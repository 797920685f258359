// CRC-15, exact length and bits of frames of all formats (can/frame.hpp, can/simulated/wire_frame.hpp)
// against a slow reference; and never longer than the worst case.
#include "gaitway/can/frame.hpp"

#include <cstdint>
#include <span>

#include "fuzz_frame.hpp"
#include "gaitway/can/simulated/wire_frame.hpp"
#include "slow_frame.hpp"

namespace gaitway::fuzz {

void frame_length(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  const can::Frame frame = take_frame(input);
  require(can::crc15(frame) == slow_crc(slow_fields(frame)), "the CRC is the reference's");
  const Bits slow = slow_wire(frame);
  const auto length = static_cast<int>(slow.size());
  require(can::frame_bits(frame) == length, "the length is the reference's");
  const int data_bytes = static_cast<int>(frame.payload().size());
  require(length + can::kInterframeBits <= can::worst_case_bits(data_bytes, frame.extended),
          "no frame is longer than the worst case");
  const can::WireFrame wire(frame);
  require(wire.length() == length, "the frame on the wire is as long");
  for (int bit = 0; bit < length; ++bit) {
    require(wire.dominant(bit) == (slow[static_cast<std::size_t>(bit)] == 0), "its bits are the reference's");
  }
}

}  // namespace gaitway::fuzz
