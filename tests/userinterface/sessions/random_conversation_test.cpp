// A thousand conversations at random, under the properties that the fuzz target api_session checks.
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "tests/fuzz/fuzz_input.hpp"

namespace gaitway::fuzz {

void api_session(std::span<const std::uint8_t> bytes);

namespace {

TEST(RandomConversation, KeepsEveryProperty) {
  constexpr std::uint32_t kConversations = 1000;
  for (std::uint32_t seed = 0; seed < kConversations; ++seed) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(100 + random() % 3000);
    for (std::uint8_t& byte : bytes) {
      byte = static_cast<std::uint8_t>(random());
    }
    try {
      api_session(bytes);
    } catch (const BrokenProperty& broken) {
      FAIL() << "seed " << seed << ": " << broken.what;
    }
  }
}

}  // namespace
}  // namespace gaitway::fuzz
