// How a receiver follows a frame bit by bit (can/simulated/wire_frame.hpp). Every frame of every format is
// valid to it; any other bits come to an end in one of its verdicts, no later than the longest frame does,
// and what it finds valid has stuff bits where they belong and the right CRC.
#include "gaitway/can/simulated/wire_frame.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include "fuzz_frame.hpp"
#include "slow_frame.hpp"

namespace gaitway::fuzz {
namespace {

using can::FrameReader;
using Step = FrameReader::Step;

constexpr std::size_t kTrailer = 10;
constexpr std::size_t kLongest = 157;  // extended identifier and 8 bytes, all of it stuffed
constexpr std::size_t kAcknowledge = 9;

void check_frame(const can::Frame& frame) {
  const Bits bits = slow_wire(frame);
  FrameReader reader;
  reader.start();
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const std::size_t left = bits.size() - i;  // with this one
    require(reader.acknowledges() == (left == kAcknowledge), "a frame is acknowledged in its slot");
    const Step step = reader.take(left == kAcknowledge || bits[i] == 0);
    require(step == (left == 2   ? Step::valid
                     : left == 1 ? Step::complete
                                 : Step::more),
            "a frame is read to its end");
  }
}

// The bits in front of the CRC delimiter, without stuff bits; nothing if those are not where they belong.
Bits fields_of(std::span<const int> wire) {
  Bits fields;
  int last = -1, run = 0;
  for (const int bit : wire) {
    const bool stuff = run == 5;
    run = bit == last ? run + 1 : 1;
    last = bit;
    if (run > 5) {
      return {};
    }
    if (!stuff) {
      fields.push_back(bit);
    }
  }
  return fields;
}

void check_any(Input& input) {
  FrameReader reader;
  reader.start();
  Bits bits;
  std::uint8_t byte = 0;
  Step step = Step::more;
  while (step == Step::more) {
    require(bits.size() < kLongest, "every frame comes to an end");
    if (bits.size() % 8 == 0) {
      byte = input.take<std::uint8_t>();
    }
    const bool dominant = bits.empty() || (std::uint32_t{byte} >> (bits.size() % 8) & 1U) == 0;
    bits.push_back(dominant ? 0 : 1);
    step = reader.take(dominant);
  }
  if (step == Step::valid) {
    const Bits fields = fields_of(std::span(bits).first(bits.size() + 1 - kTrailer));
    require(!fields.empty() && slow_crc(fields) == 0, "what is valid has the right CRC");
  }
}

}  // namespace

void frame_reader(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  const can::Frame frame = take_frame(input);
  check_frame(frame);
  // A frame with some bits turned round, and whatever follows.
  Bits bits = slow_wire(frame);
  for (std::size_t flips = input.choose(4); flips > 0; --flips) {
    int& bit = bits[1 + input.take<std::uint8_t>() % (bits.size() - 1)];
    bit = 1 - bit;
  }
  std::vector<std::uint8_t> packed((bits.size() + 7) / 8 + 4);
  for (std::size_t i = 0; i < bits.size(); ++i) {
    packed[i / 8] = static_cast<std::uint8_t>(packed[i / 8] | static_cast<unsigned>(bits[i]) << (i % 8));
  }
  Input disturbed(packed);
  check_any(disturbed);
  check_any(input);
}

}  // namespace gaitway::fuzz
