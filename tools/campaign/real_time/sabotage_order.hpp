// One number that tells a plug-in of the campaign what it is to do wrong, and when: whoever takes the failed
// one's place has the same parameters, and is not to fail again.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gaitway::tools {

inline constexpr std::array<std::string_view, 9> kSabotages{
    "segfault", "abort", "exit", "throw", "loop", "memory", "descriptors", "fork", "garbage"};
inline constexpr std::int64_t kSabotageWays = 16;
// A plug-in that is stepped each 10 ms does it once in that time; one that was lost is replaced later.
inline constexpr std::int64_t kSabotageDue_ms = 25;

// Throws std::invalid_argument for what is none of them.
[[nodiscard]] inline std::int64_t sabotage_order(std::string_view sabotage, std::int64_t at_ns) {
  for (std::size_t way = 0; way < kSabotages.size(); ++way) {
    if (kSabotages[way] == sabotage) {
      return at_ns / 1'000'000 * kSabotageWays + static_cast<std::int64_t>(way);
    }
  }
  throw std::invalid_argument("no such sabotage: " + std::string(sabotage));
}

[[nodiscard]] inline bool is_due(std::int64_t order, std::int64_t now_ns) noexcept {
  const std::int64_t since_ms = now_ns / 1'000'000 - order / kSabotageWays;
  return order > 0 && since_ms >= 0 && since_ms < kSabotageDue_ms;
}

[[nodiscard]] inline std::string sabotage_of(std::int64_t order) {
  const auto way = static_cast<std::size_t>(order % kSabotageWays);
  return std::string(way < kSabotages.size() ? kSabotages[way] : std::string_view());
}

}  // namespace gaitway::tools
