// The checksum against published values, and in pieces.
#include "gaitway/process/crc32.hpp"

#include <gtest/gtest.h>

#include <span>
#include <string_view>

namespace gaitway::process {
namespace {

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}

TEST(Crc32, GivesThePublishedCheckValue) {
  EXPECT_EQ(crc32(bytes_of("123456789")), 0xCBF43926U);
  EXPECT_EQ(crc32({}), 0U);
}

TEST(Crc32, OfPiecesIsThatOfTheWhole) {
  EXPECT_EQ(crc32(bytes_of("6789"), crc32(bytes_of("12345"))), 0xCBF43926U);
}

}  // namespace
}  // namespace gaitway::process
