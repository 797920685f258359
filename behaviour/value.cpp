// Reads and writes values of behaviour trees, with their units.
#include "gaitway/behaviour/value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <span>

#include "gaitway/input/complaint.hpp"
#include "gaitway/input/number.hpp"

namespace gaitway::behaviour {
namespace {

using input::Unit;
using input::ValueError;

constexpr double kRadPerDeg = std::numbers::pi / 180.0;

// The units in which a number may be written whose port has the first of them.
struct Quantity {
  std::array<Unit, 4> units;
  std::size_t count;
  [[nodiscard]] std::span<const Unit> all() const { return std::span(units).first(count); }
};
constexpr std::array<Quantity, 9> kQuantities{{
    {{{{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}}}, 3},
    {{{{"rad", 1.0}, {"deg", kRadPerDeg}}}, 2},
    {{{{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}}, 4},
    {{{{"m/s", 1.0}, {"cm/s", 0.01}, {"mm/s", 0.001}}}, 3},
    {{{{"rad/s", 1.0}, {"deg/s", kRadPerDeg}}}, 2},
    {{{{"N", 1.0}}}, 1},
    {{{{"N s", 1.0}}}, 1},
    {{{{"kg", 1.0}, {"g", 0.001}}}, 2},
    {{{{"%", 1.0}}}, 1},
}};

const Quantity* quantity(std::string_view unit) noexcept {
  const auto found = std::ranges::find_if(
      kQuantities, [unit](const Quantity& candidate) { return candidate.units[0].name == unit; });
  return found == kQuantities.end() ? nullptr : &*found;
}

void require_within(double number, const ValueType& type) {
  if (number >= type.lowest && number <= type.highest) return;
  const std::string unit = type.unit.empty() ? "" : " " + type.unit;
  std::string rule = fmt::format("must be {}..{}{}", type.lowest, type.highest, unit);
  if (std::isinf(type.highest)) rule = fmt::format("must be at least {}{}", type.lowest, unit);
  if (std::isinf(type.lowest)) rule = fmt::format("must be at most {}{}", type.highest, unit);
  throw ValueError(rule, "");
}

double parse_number(std::string_view text, const ValueType& type) {
  const auto [number, unit] = input::split_number<double>(text);
  if (type.unit.empty()) {
    if (!unit.empty()) throw ValueError("must be a number without a unit", "");
    return number;
  }
  const Quantity* const units = quantity(type.unit);
  for (const Unit& known : units->all()) {
    if (known.name == unit) return number * known.factor;
  }
  std::vector<std::string_view> names;
  std::vector<std::string> meant;
  for (const Unit& known : units->all()) {
    names.push_back(known.name);
    meant.push_back(fmt::format("'{} {}'", number, known.name));
  }
  throw ValueError(fmt::format("must be a number with one of the units {}", fmt::join(names, ", ")),
                   unit.empty() ? fmt::format("Write {}, as it is meant", fmt::join(meant, " or ")) : "");
}

std::int64_t parse_duration(std::string_view text) {
  constexpr std::int64_t kMost_ns = std::int64_t{1'000'000'000} * 3600 * 24 * 365;
  const std::string_view word = input::trimmed(text);
  const bool bare = !word.empty() && std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
  return input::number_with_unit(bare ? fmt::format("{} ms", word) : std::string(word), input::kTimeUnits_ns,
                                 0, kMost_ns);
}

bool parse_boolean(std::string_view text) {
  const std::string_view word = input::trimmed(text);
  for (const std::string_view yes : {"true", "True", "TRUE", "1"}) {
    if (word == yes) return true;
  }
  for (const std::string_view no : {"false", "False", "FALSE", "0"}) {
    if (word == no) return false;
  }
  throw ValueError("must be true or false", "");
}

}  // namespace

Text::Text(std::string_view text) noexcept : size_(static_cast<std::uint8_t>(std::min(text.size(), kMost))) {
  std::memcpy(bytes_.data(), text.data(), size_);
}

std::string_view name(ValueKind kind) noexcept {
  constexpr std::array<std::string_view, 7> kNames{"anything", "true or false", "whole number", "number",
                                                   "text",     "choice",        "duration"};
  return kNames[static_cast<std::size_t>(kind)];
}

bool same_type(const ValueType& a, const ValueType& b) noexcept {
  return a.kind == b.kind && a.unit == b.unit && a.choices == b.choices;
}

std::string describe(const ValueType& type) {
  if (type.kind == ValueKind::choice) return fmt::format("one of {}", fmt::join(type.choices, ", "));
  return type.unit.empty() ? std::string(name(type.kind))
                           : fmt::format("{} in {}", name(type.kind), type.unit);
}

bool fits(const Value& value, const ValueType& type) noexcept {
  const auto within = [&type](double number) { return number >= type.lowest && number <= type.highest; };
  switch (type.kind) {
    case ValueKind::any:
      return value.index() != 0;
    case ValueKind::boolean:
      return std::holds_alternative<bool>(value);
    case ValueKind::number: {
      const double* const number = std::get_if<double>(&value);
      return number != nullptr && std::isfinite(*number) && within(*number);
    }
    case ValueKind::text:
      return std::holds_alternative<Text>(value);
    case ValueKind::integer:
    case ValueKind::duration:
    case ValueKind::choice:
      break;
  }
  const std::int64_t* const whole = std::get_if<std::int64_t>(&value);
  if (whole == nullptr) return false;
  if (type.kind == ValueKind::integer) return within(static_cast<double>(*whole));
  return *whole >= 0 &&
         (type.kind == ValueKind::duration || static_cast<std::size_t>(*whole) < type.choices.size());
}

Value parse_value(std::string_view text, const ValueType& type) {
  switch (type.kind) {
    case ValueKind::boolean:
      return parse_boolean(text);
    case ValueKind::integer: {
      const auto whole = input::plain_number<std::int64_t>(text);
      require_within(static_cast<double>(whole), type);
      return whole;
    }
    case ValueKind::number: {
      const double number = parse_number(text, type);
      if (!std::isfinite(number)) throw ValueError("must be a number", "");
      require_within(number, type);
      return number;
    }
    case ValueKind::choice: {
      const auto found = std::ranges::find(type.choices, input::trimmed(text));
      if (found != type.choices.end()) return static_cast<std::int64_t>(found - type.choices.begin());
      throw ValueError(fmt::format("must be {}", describe(type)), input::suggest(text, type.choices));
    }
    case ValueKind::duration:
      return parse_duration(text);
    case ValueKind::any:
    case ValueKind::text:
      break;
  }
  if (text.size() > Text::kMost) {
    throw ValueError(fmt::format("must have at most {} bytes", Text::kMost), "Shorten it");
  }
  return Text(text);
}

std::string written(const Value& value, const ValueType& type) {
  if (const bool* const truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const Text* const text = std::get_if<Text>(&value)) return std::string(text->view());
  if (const double* const number = std::get_if<double>(&value)) {
    return type.unit.empty() ? fmt::format("{}", *number) : fmt::format("{} {}", *number, type.unit);
  }
  const std::int64_t* const whole = std::get_if<std::int64_t>(&value);
  if (whole == nullptr) return "";
  if (type.kind == ValueKind::duration) return fmt::format("{} ns", *whole);
  if (type.kind == ValueKind::choice && *whole >= 0 &&
      static_cast<std::size_t>(*whole) < type.choices.size()) {
    return type.choices[static_cast<std::size_t>(*whole)];
  }
  return fmt::format("{}", *whole);
}

bool is_known_unit(std::string_view unit) noexcept {
  return quantity(unit) != nullptr;
}

}  // namespace gaitway::behaviour
