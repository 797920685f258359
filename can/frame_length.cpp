// CRC-15 and bit stuffing, a byte at a time by tables.
#include "gaitway/can/frame_length.hpp"

#include <array>

namespace gaitway::can {
namespace {

constexpr std::uint16_t kPolynomial = 0x4599;
constexpr int kHeaderBits = 19;  // SOF, identifier, RTR, IDE, r0, DLC
constexpr int kCrcBits = 15;
constexpr int kTrailerBits = 10;  // CRC delimiter, ACK slot, ACK delimiter, end of frame (7)

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

std::uint32_t header(const Frame& frame) noexcept {
  return (static_cast<std::uint32_t>(frame.id & 0x7FFU) << 7U) | frame.size;
}

}  // namespace

std::uint16_t crc15(const Frame& frame) noexcept {
  unsigned crc = 0;
  const auto take = [&crc](unsigned byte) {
    crc = ((crc << 8U) ^ kCrcTable[((crc >> 7U) ^ byte) & 0xFFU]) & 0x7FFFU;
  };
  // The header is padded with zeros in front, which leave a CRC that starts at zero as it is.
  const std::uint32_t bits = header(frame);
  take((bits >> 16U) & 0xFFU);
  take((bits >> 8U) & 0xFFU);
  take(bits & 0xFFU);
  for (std::size_t i = 0; i < frame.size; ++i) {
    take(frame.data[i]);
  }
  return static_cast<std::uint16_t>(crc);
}

int frame_bits(const Frame& frame) noexcept {
  // 19 header bits, data, 15 CRC bits: two bits first, then whole bytes.
  const std::uint32_t bits = header(frame);
  StuffState state{(bits >> 18U) & 1U, 1U};
  take_bit(state, (bits >> 17U) & 1U);
  unsigned index = state.index();
  int stuffed = 0;
  const auto take = [&](unsigned byte) {
    const StuffStep step = kStuffTable[index][byte & 0xFFU];
    stuffed += step.stuffed;
    index = step.next;
  };
  // The header's last bit has no byte of its own, so each data byte is taken with the bit before it.
  take(bits >> 9U);
  take(bits >> 1U);
  unsigned carry = bits & 1U;
  for (std::size_t i = 0; i < frame.size; ++i) {
    take((carry << 7U) | (frame.data[i] >> 1U));
    carry = frame.data[i] & 1U;
  }
  const unsigned tail = (carry << 15U) | crc15(frame);
  take(tail >> 8U);
  take(tail);
  return kHeaderBits + 8 * frame.size + kCrcBits + stuffed + kTrailerBits;
}

}  // namespace gaitway::can
