// Numbers as people write them, with or without a unit: "0.4", "200 us", "512 MiB".
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "gaitway/input/complaint.hpp"

namespace gaitway::input {

// What is wrong with a value. Whoever knows where it stands says that.
class ValueError : public InputError {
 public:
  ValueError(const std::string& broken_rule, const std::string& what_to_do)
      : InputError(what_to_do.empty() ? broken_rule : broken_rule + ". " + what_to_do),
        rule(broken_rule),
        remedy(what_to_do) {}

  std::string rule, remedy;  // without full stops; no remedy: it depends on the place
};

// Without the blanks and tabs around it.
[[nodiscard]] std::string_view trimmed(std::string_view text) noexcept;

template <class Number>
struct NumberAndUnit {
  Number number{};
  std::string_view unit;  // what stands behind the number, trimmed
};

// Splits "0.4 s". Number is double (finite), std::int64_t or std::uint64_t; whole numbers may be written as
// 0x1F, too. Throws ValueError.
template <class Number>
[[nodiscard]] NumberAndUnit<Number> split_number(std::string_view text);

// The same with nothing behind it.
template <class Number>
[[nodiscard]] Number plain_number(std::string_view text);

struct Unit {
  std::string_view name;
  double factor;
};
inline constexpr std::array<Unit, 4> kTimeUnits_ns{{{"ns", 1.0}, {"us", 1e3}, {"ms", 1e6}, {"s", 1e9}}};
inline constexpr std::array<Unit, 3> kSizeUnits_bytes{
    {{"KiB", 1024.0}, {"MiB", 1024.0 * 1024.0}, {"GiB", 1024.0 * 1024.0 * 1024.0}}};

// A number with one of these units, in what their factors count. Throws ValueError.
[[nodiscard]] std::int64_t number_with_unit(std::string_view text, std::span<const Unit> units,
                                            std::int64_t lowest, std::int64_t highest);

// What is wrong with the value of an option of a command line that takes numbers from `lowest` to `highest`;
// empty: nothing.
template <class Number>
[[nodiscard]] std::string option_fault(std::string_view text, Number lowest, Number highest);

}  // namespace gaitway::input
