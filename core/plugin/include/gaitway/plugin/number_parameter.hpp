// The numbers of a plug-in's parameters in one list: what the configuration calls each, its unit, its range,
// what it is for, and whether it may change while the robot walks. Plain C++: a plug-in's algorithm may have
// such a list without knowing of plug-ins.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "gaitway/facts/body_scale.hpp"

namespace gaitway {

// Whether a number that suits one body suits a larger one when it grows with it, or as it is: what comes from
// the network's cycle or the electronics.
enum class Scaling : bool { with_body, none };

// One number, where it is kept, and what it may be whatever the others are.
struct NumberParameter {
  double& value;
  const char* name;
  const char* unit;  // "1": none
  double lowest, highest;
  const char* doc = "";  // one line for people
  bool live = false;     // may change between two steps
  Scaling scaling = Scaling::with_body;
};
inline constexpr bool kLive = true;

namespace detail {

// With its unit; the shortest digits that are this number and no other.
inline std::string text_of(double value, std::string_view unit) {
  std::array<char, 32> digits{};
  std::string text(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
  if (unit != "1") text.append(" ").append(unit);
  return text;
}

}  // namespace detail

// Throws std::invalid_argument with name, value, rule and remedy, unless the rule holds. rule: what the
// number must be, "at least step_time".
inline void require_number(bool holds, std::string_view name, double value, std::string_view unit,
                           std::string_view rule) {
  if (holds) return;
  std::string text(name);
  text.append(" is ").append(detail::text_of(value, unit)).append(", but must be ").append(rule);
  throw std::invalid_argument(text.append("; change it in the plug-in's parameters"));
}

// The same for the range of each.
inline void require_in_range(std::span<const NumberParameter> numbers) {
  for (const NumberParameter& number : numbers) {
    if (number.value >= number.lowest && number.value <= number.highest) continue;  // not so of NaN
    std::string rule("from ");
    rule.append(detail::text_of(number.lowest, "1")).append(" to ");
    rule.append(detail::text_of(number.highest, number.unit));
    require_number(false, number.name, number.value, number.unit, rule);
  }
}

// Makes defaults that were found with one body those of another, as far as their ranges go.
inline void scale_to_body(std::span<const NumberParameter> numbers, const facts::BodyScale& scale) {
  for (const NumberParameter& number : numbers) {
    if (number.scaling == Scaling::none) continue;
    number.value = std::clamp(number.value * scale.factor(number.unit), number.lowest, number.highest);
  }
}

}  // namespace gaitway
