// Reads a number and its unit.
#include "configured_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "gaitway/input/yaml_value.hpp"

namespace gaitway::core {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 4> kTimeUnits{
    {{"ns", 1.0}, {"us", 1e3}, {"ms", 1e6}, {"s", 1e9}}};

}  // namespace

std::int64_t read_time_ns(const input::YamlValue& value, std::int64_t lowest_ns, std::int64_t highest_ns,
                          const char* range) {
  const std::string text = value.text();
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  for (const auto& [name, scale] : kTimeUnits) {
    if (error == std::errc{} && unit == name) {
      const double time_ns = number * scale;
      if (!(time_ns >= static_cast<double>(lowest_ns) && time_ns <= static_cast<double>(highest_ns))) {
        value.refuse(fmt::format("must lie between {}", range), "Choose another time");
      }
      return std::llround(time_ns);
    }
  }
  value.refuse("must be a number with its unit: ns, us, ms or s", "Write it like '200 us'");
}

}  // namespace gaitway::core
