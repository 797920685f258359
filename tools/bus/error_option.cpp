// Parses `key:value` parts between commas.
#include "tools/bus/error_option.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "gaitway/input/nearest_name.hpp"

namespace gaitway::tools {
namespace {

constexpr int kMostErrors = 100'000;
constexpr double kLongest_ns = 1e12;  // 1000 s

[[noreturn]] void refuse(const std::string& text, std::string_view rule) {
  throw std::invalid_argument(fmt::format("--errors {}: {}", text, rule));
}

// The number at the start of `value`, and what follows it.
std::pair<double, std::string_view> number_of(std::string_view value) {
  double number = std::nan("");
  const auto parsed = std::from_chars(value.data(), value.data() + value.size(), number);
  return {parsed.ec == std::errc() ? number : std::nan(""),
          value.substr(static_cast<std::size_t>(parsed.ptr - value.data()))};
}

std::int64_t time_ns(const std::string& text, std::string_view key, std::string_view value) {
  constexpr std::array<std::pair<std::string_view, double>, 3> kUnits{{{"us", 1e3}, {"ms", 1e6}, {"s", 1e9}}};
  const auto [number, unit] = number_of(value);
  for (const auto& [name, unit_ns] : kUnits) {
    if (unit == name && number > 0.0 && number * unit_ns >= 1.0 && number * unit_ns <= kLongest_ns) {
      return std::llround(number * unit_ns);
    }
  }
  refuse(text,
         fmt::format("{} = '{}': must be a time above 0 and up to 1000 s with its unit us, ms or s, for "
                     "example 10ms",
                     key, value));
}

int count(const std::string& text, std::string_view value) {
  const auto [number, rest] = number_of(value);
  if (!rest.empty() || !(number >= 1.0 && number <= kMostErrors) || number != std::floor(number)) {
    refuse(text, fmt::format("burst = '{}': must be a whole number 1..{}", value, kMostErrors));
  }
  return static_cast<int>(number);
}

}  // namespace

can::ErrorSource parse_errors(const std::string& text) {
  static const std::vector<std::string> kKeys{"burst", "interval", "jam"};
  can::ErrorSource source;
  std::set<std::string> seen;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t colon = part.find(':');
    const std::string key = part.substr(0, colon);
    const std::string value = colon == std::string::npos ? "" : part.substr(colon + 1);
    if (!seen.insert(key).second) {
      refuse(text, fmt::format("'{}' is there twice; give --errors again for a second source", key));
    }
    if (key == "burst") {
      source.burst = count(text, value);
    } else if (key == "interval") {
      source.interval_ns = time_ns(text, key, value);
    } else if (key == "jam") {
      source.duration_ns = time_ns(text, key, value);
    } else {
      refuse(text, fmt::format("'{}': there is no such part. {}", key, input::suggest(key, kKeys)));
    }
  }
  if (seen.empty()) {
    refuse(text, "says nothing. Write for example burst:4,interval:10ms or jam:2ms");
  }
  return source;
}

}  // namespace gaitway::tools
