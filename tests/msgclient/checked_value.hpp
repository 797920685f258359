// A value that proves its own wholeness: every word follows from the first.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gaitway::msgclient {

template <std::size_t words>
struct CheckedValue {
  std::array<std::uint64_t, words> word{};

  static constexpr std::uint64_t derived(std::uint64_t seed, std::size_t i) noexcept {
    std::uint64_t x = (seed + i) * 0x9e3779b97f4a7c15u;
    return x ^ (x >> 29);
  }
  void fill(std::uint64_t seed) noexcept {
    word[0] = seed;
    for (std::size_t i = 1; i < words; ++i) {
      word[i] = derived(seed, i);
    }
  }
  [[nodiscard]] bool whole() const noexcept {
    for (std::size_t i = 1; i < words; ++i) {
      if (word[i] != derived(word[0], i)) {
        return false;
      }
    }
    return true;
  }
};

}  // namespace gaitway::msgclient
