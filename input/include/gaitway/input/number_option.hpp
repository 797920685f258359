// Checks for the options of a command line: CLI11's own let NaN pass and cut off what is too large.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>
#include <string>

#include "gaitway/input/number.hpp"

namespace gaitway::input {

template <class Number>
[[nodiscard]] CLI::Validator within(Number lowest, Number highest, const std::string& in_help) {
  return {[=](const std::string& text) { return option_fault(text, lowest, highest); }, in_help};
}

// Finite numbers from `lowest` to `highest`; of a list, each.
[[nodiscard]] inline CLI::Validator number_within(double lowest, double highest) {
  return within(lowest, highest, fmt::format("{} to {}", lowest, highest));
}

[[nodiscard]] inline CLI::Validator whole_number_within(std::int64_t lowest, std::int64_t highest) {
  return within(lowest, highest, fmt::format("{} to {}", lowest, highest));
}

// Any seed of 64 bits.
[[nodiscard]] inline CLI::Validator seed() {
  return within(std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max(), "");
}

}  // namespace gaitway::input
