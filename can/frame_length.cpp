// How long a frame is on the wire: CRC-15 and bit stuffing, a byte at a time by tables.
#include "gaitway/can/frame.hpp"

#include <array>

namespace gaitway::can {
namespace {

constexpr std::uint16_t kPolynomial = 0x4599;
constexpr int kHeaderBits = 19;          // SOF, identifier, RTR, IDE, r0, DLC
constexpr int kExtendedHeaderBits = 39;  // SOF, 11 bits, SRR, IDE, 18 bits, RTR, r1, r0, DLC
constexpr int kCrcBits = 15;

constexpr std::array<std::uint16_t, 256> make_crc_table() {
  std::array<std::uint16_t, 256> table{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    unsigned remainder = byte << 7U;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder & 0x4000U) != 0 ? (remainder << 1U) ^ kPolynomial : remainder << 1U;
    }
    table[byte] = static_cast<std::uint16_t>(remainder & 0x7FFFU);
  }
  return table;
}

// Where the stuffing stands after some bits: the last bit and how often it has come in a row (1..5, stuff
// bits count). After five equal bits a stuff bit of the other value follows at once, so a run never stays at
// five.
struct StuffState {
  unsigned last = 0;
  unsigned run = 1;
  [[nodiscard]] constexpr unsigned index() const { return last * 4U + (run - 1U); }
};

// Takes one bit; true when a stuff bit follows it.
constexpr bool take_bit(StuffState& state, unsigned bit) {
  state.run = bit == state.last ? state.run + 1U : 1U;
  state.last = bit;
  if (state.run < 5U) {
    return false;
  }
  state = {bit ^ 1U, 1U};
  return true;
}

struct StuffStep {
  std::uint8_t stuffed = 0;
  std::uint8_t next = 0;  // StuffState::index()
};

constexpr auto make_stuff_table() {
  std::array<std::array<StuffStep, 256>, 8> table{};
  for (unsigned index = 0; index < 8; ++index) {
    for (unsigned byte = 0; byte < 256; ++byte) {
      StuffState state{index / 4U, index % 4U + 1U};
      unsigned stuffed = 0;
      for (int bit = 7; bit >= 0; --bit) {
        stuffed += take_bit(state, (byte >> static_cast<unsigned>(bit)) & 1U) ? 1U : 0U;
      }
      table[index][byte] = {static_cast<std::uint8_t>(stuffed), static_cast<std::uint8_t>(state.index())};
    }
  }
  return table;
}

constexpr auto kCrcTable = make_crc_table();
constexpr auto kStuffTable = make_stuff_table();

// From SOF (0) to the last bit of the data length code, in the low bits.
std::uint64_t header(const Frame& frame) noexcept {
  const std::uint64_t remote = frame.remote ? 1U : 0U;
  if (!frame.extended) {
    return (std::uint64_t{frame.id & kLargestId} << 7U) | (remote << 6U) | frame.size;
  }
  const std::uint64_t leading = (frame.id >> 18U) & kLargestId;
  const std::uint64_t trailing = frame.id & 0x3'FFFFU;
  return (leading << 27U) | (std::uint64_t{3} << 25U) | (trailing << 7U) | (remote << 6U) | frame.size;
}

}  // namespace

std::uint16_t crc15(const Frame& frame) noexcept {
  unsigned crc = 0;
  const auto take = [&crc](std::uint64_t byte) {
    crc = ((crc << 8U) ^ kCrcTable[((crc >> 7U) ^ byte) & 0xFFU]) & 0x7FFFU;
  };
  // The header is padded with zeros in front, which leave a CRC that starts at zero as it is.
  const std::uint64_t bits = header(frame);
  if (frame.extended) {
    take(bits >> 32U);
    take(bits >> 24U);
  }
  take(bits >> 16U);
  take(bits >> 8U);
  take(bits);
  for (const std::uint8_t byte : frame.payload()) {
    take(byte);
  }
  return static_cast<std::uint16_t>(crc);
}

int frame_bits(const Frame& frame) noexcept {
  // 19 or 39 header bits, data, 15 CRC bits: two or six bits first, then whole bytes.
  const std::uint64_t bits = header(frame);
  const int header_bits = frame.extended ? kExtendedHeaderBits : kHeaderBits;
  const int first_bits = frame.extended ? 6 : 2;
  StuffState state{0, 1};  // after SOF
  int stuffed = 0;
  for (int bit = 1; bit < first_bits; ++bit) {
    const unsigned place = static_cast<unsigned>(header_bits - 1 - bit);
    stuffed += take_bit(state, static_cast<unsigned>(bits >> place) & 1U) ? 1 : 0;
  }
  unsigned index = state.index();
  const auto take = [&](std::uint64_t byte) {
    const StuffStep step = kStuffTable[index][byte & 0xFFU];
    stuffed += step.stuffed;
    index = step.next;
  };
  if (frame.extended) {
    take(bits >> 25U);
    take(bits >> 17U);
  }
  // The header's last bit has no byte of its own, so each data byte is taken with the bit before it.
  take(bits >> 9U);
  take(bits >> 1U);
  unsigned carry = static_cast<unsigned>(bits & 1U);
  const std::span<const std::uint8_t> payload = frame.payload();
  for (const std::uint8_t byte : payload) {
    take((carry << 7U) | (byte >> 1U));
    carry = byte & 1U;
  }
  const unsigned tail = (carry << 15U) | crc15(frame);
  take(tail >> 8U);
  take(tail);
  return header_bits + 8 * static_cast<int>(payload.size()) + kCrcBits + stuffed + kTrailerBits;
}

}  // namespace gaitway::can
