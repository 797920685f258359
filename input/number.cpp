// Reads numbers strictly, whatever the locale: one decimal point, no NaN, no infinity, nothing cut off.
#include "gaitway/input/number.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>
#include <vector>

namespace gaitway::input {
namespace {

bool is_digit(char letter) {
  return letter >= '0' && letter <= '9';
}

// "0,4 s": a digit, a comma and a digit, where the number ends that was read.
bool has_decimal_comma(std::string_view text, std::size_t end) {
  return end > 0 && end + 1 < text.size() && is_digit(text[end - 1]) && text[end] == ',' &&
         is_digit(text[end + 1]);
}

template <class Number>
std::from_chars_result read(std::string_view text, Number& number) {
  const char* const end = text.data() + text.size();
  if constexpr (std::is_integral_v<Number>) {
    if (text.starts_with("0x") && text.size() > 2 && text[2] != '-') {
      return std::from_chars(text.data() + 2, end, number, 16);
    }
  }
  return std::from_chars(text.data(), end, number);
}

// "10 ms" of 10,000,000: in the largest unit of which it is at least one.
std::string amount(std::int64_t value, std::span<const Unit> units) {
  if (value == 0) {
    return "0";
  }
  const auto count = static_cast<double>(value);
  const auto fits = [count](const Unit& unit) { return count >= unit.factor; };
  const auto largest = std::find_if(units.rbegin(), units.rend(), fits);
  const Unit& unit = largest == units.rend() ? units.front() : *largest;
  return fmt::format("{:g} {}", count / unit.factor, unit.name);
}

}  // namespace

std::string_view trimmed(std::string_view text) noexcept {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

template <class Number>
NumberAndUnit<Number> split_number(std::string_view text) {
  const std::string rule = std::is_integral_v<Number> ? "must be a whole number" : "must be a number";
  std::string_view rest = trimmed(text);
  rest.remove_prefix(rest.starts_with('+') && rest.size() > 1 && rest[1] != '-' ? 1 : 0);
  Number number{};
  const auto [stop, error] = read(rest, number);
  const auto end = static_cast<std::size_t>(stop - rest.data());
  if (has_decimal_comma(rest, end)) {
    std::string corrected(rest);
    corrected[end] = '.';
    throw ValueError(rule + " with a decimal point, not with a comma", fmt::format("Write '{}'", corrected));
  }
  if (error != std::errc{} || !std::isfinite(static_cast<double>(number))) {
    throw ValueError(rule, "");
  }
  rest.remove_prefix(end);
  // What follows a whole number is its unit, not the rest of "1.5" or "1e3".
  if (std::is_integral_v<Number> && !rest.empty() && std::string_view(".eE").find(rest[0]) != rest.npos) {
    throw ValueError(rule, "");
  }
  return {number, trimmed(rest)};
}

template <class Number>
Number plain_number(std::string_view text) {
  const auto [number, unit] = split_number<Number>(text);
  if (!unit.empty()) {
    throw ValueError(std::is_integral_v<Number> ? "must be a whole number" : "must be a number", "");
  }
  return number;
}

std::int64_t number_with_unit(std::string_view text, std::span<const Unit> units, std::int64_t lowest,
                              std::int64_t highest) {
  std::vector<std::string_view> names;
  for (const Unit& unit : units) {
    names.push_back(unit.name);
  }
  const std::string last(names.back());
  names.pop_back();
  const ValueError without_unit(
      fmt::format("must be a number with its unit: {} or {}", fmt::join(names, ", "), last),
      fmt::format("Write it like '200 {}'", names.back()));
  NumberAndUnit<double> written;
  try {
    written = split_number<double>(text);
  } catch (const ValueError& error) {
    throw error.remedy.empty() ? without_unit : error;
  }
  const auto unit = std::ranges::find(units, written.unit, &Unit::name);
  if (unit == units.end()) {
    throw without_unit;
  }
  const double value = written.number * unit->factor;
  if (!(value >= static_cast<double>(lowest) && value <= static_cast<double>(highest))) {
    throw ValueError(fmt::format("must lie between {} and {}", amount(lowest, units), amount(highest, units)),
                     "Choose another value");
  }
  return std::llround(value);
}

template <class Number>
std::string option_fault(std::string_view text, Number lowest, Number highest) {
  constexpr std::string_view kKind = std::is_integral_v<Number> ? "a whole number" : "a number";
  try {
    const Number number = plain_number<Number>(text);
    if (number >= lowest && number <= highest) {
      return {};
    }
  } catch (const ValueError& error) {
    if (!error.remedy.empty()) {
      return fmt::format("'{}' {}. {}", text, error.rule, error.remedy);
    }
  }
  return fmt::format("'{}' must be {} from {} to {}", text, kKind, lowest, highest);
}

template NumberAndUnit<double> split_number(std::string_view);
template NumberAndUnit<std::int64_t> split_number(std::string_view);
template NumberAndUnit<std::uint64_t> split_number(std::string_view);
template double plain_number(std::string_view);
template std::int64_t plain_number(std::string_view);
template std::uint64_t plain_number(std::string_view);
template std::string option_fault(std::string_view, double, double);
template std::string option_fault(std::string_view, std::int64_t, std::int64_t);
template std::string option_fault(std::string_view, std::uint64_t, std::uint64_t);

}  // namespace gaitway::input
