// Checks for the options of a command line, since CLI11's own let NaN pass and cut off what is too large; and
// what a program says of a line that it does not run.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

#include "gaitway/input/number.hpp"
#include "gaitway/input/text.hpp"

namespace gaitway::input {

template <class Number>
[[nodiscard]] CLI::Validator within(Number lowest, Number highest, const std::string& in_help) {
  return {[=](const std::string& text) { return option_fault(text, lowest, highest); }, in_help};
}

// Finite numbers from `lowest` to `highest`; of a list, each.
[[nodiscard]] inline CLI::Validator number_within(double lowest, double highest) {
  return within(lowest, highest, fmt::format("{} to {}", lowest, highest));
}

// Any seed of 64 bits.
[[nodiscard]] inline CLI::Validator seed() {
  return within(std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max(), "");
}

// The main of `program`: parses the line and runs it. Prints the help that was asked for, or what is wrong
// with the line, whose words may hold anything, or what `run` throws. Returns the exit code: 1 for bad input.
template <class Run>
[[nodiscard]] int run_line(CLI::App& app, int argc, const char* const* argv, std::string_view program,
                           const Run& run) {
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::ParseError& error) {
    std::ostringstream complaint;
    const int code = app.exit(error, std::cout, complaint);
    fmt::print(stderr, "{}", terminal_text(complaint.str()));
    return code == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", program, terminal_text(error.what()));
    return 1;
  }
}

}  // namespace gaitway::input
