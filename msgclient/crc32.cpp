// CRC-32, four bytes a step ("slicing by four", Kounavis and Berry 2005): one table look-up a byte, none
// depends on the one before it.
#include "gaitway/msgclient/crc32.hpp"

#include <array>

namespace gaitway::msgclient {
namespace {

using Tables = std::array<std::array<std::uint32_t, 256>, 4>;

constexpr Tables make_tables() {
  Tables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t value = byte;
    for (int bit = 0; bit < 8; ++bit) {
      value = (value >> 1) ^ ((value & 1) != 0 ? 0xEDB88320u : 0u);
    }
    tables[0][byte] = value;
  }
  for (std::size_t byte = 0; byte < 256; ++byte) {
    for (std::size_t step = 1; step < tables.size(); ++step) {
      const std::uint32_t before = tables[step - 1][byte];
      tables[step][byte] = (before >> 8) ^ tables[0][before & 0xff];
    }
  }
  return tables;
}

constexpr Tables kTables = make_tables();

}  // namespace

std::uint32_t crc32(std::span<const std::uint32_t> words) noexcept {
  std::uint32_t value = 0xFFFFFFFFu;
  for (const std::uint32_t word : words) {
    value ^= word;
    value = kTables[3][value & 0xff] ^ kTables[2][(value >> 8) & 0xff] ^ kTables[1][(value >> 16) & 0xff] ^
            kTables[0][value >> 24];
  }
  return ~value;
}

}  // namespace gaitway::msgclient
