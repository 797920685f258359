// Reads the containment of a plug-in strictly.
#include "gaitway/core/containment_settings.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/urdf/nearest_name.hpp"
#include "gaitway/urdf/yaml_value.hpp"

namespace gaitway::core {
namespace {

using urdf::YamlValue;

constexpr std::array<std::string_view, 7> kKindNames{"by_topics",     "none", "estimate", "trims_from_gains",
                                                     "trims_to_zero", "stop", "safe_tail"};
constexpr std::array<std::pair<std::string_view, double>, 4> kTimeUnits{
    {{"ns", 1.0}, {"us", 1e3}, {"ms", 1e6}, {"s", 1e9}}};

FallbackKind read_kind(const YamlValue& value) {
  const std::string text = value.text();
  std::vector<std::string> known;
  for (std::size_t kind = 1; kind < kKindNames.size(); ++kind) {
    if (text == kKindNames[kind]) {
      return static_cast<FallbackKind>(kind);
    }
    known.emplace_back(kKindNames[kind]);
  }
  value.refuse("must be estimate, trims_from_gains, trims_to_zero, stop, safe_tail or none",
               urdf::suggest(text, known));
}

// "200 us": a number and its unit.
std::int64_t read_time(const YamlValue& value, double lowest_ns, double highest_ns, const char* range) {
  const std::string text = value.text();
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  for (const auto& [name, scale] : kTimeUnits) {
    if (error == std::errc{} && unit == name) {
      const double time_ns = number * scale;
      if (!(time_ns >= lowest_ns && time_ns <= highest_ns)) {
        value.refuse(fmt::format("must lie between {}", range), "Choose another time");
      }
      return static_cast<std::int64_t>(std::llround(time_ns));
    }
  }
  value.refuse("must be a number with its unit: ns, us, ms or s", "Write it like '200 us'");
}

GiveUpRule read_give_up(const YamlValue& map) {
  constexpr std::array<std::string_view, 3> kKeys{"faults", "within", "batches"};
  map.require_map(kKeys);
  GiveUpRule rule;
  if (const auto faults = map.find("faults")) {
    rule.faults = faults->integer(1, GiveUpRule::kMostFaults);
  }
  if (const auto within = map.find("within")) {
    rule.within_ns = read_time(*within, 1e7, 1e12, "10 ms and 1000 s");
  }
  if (const auto batches = map.find("batches")) {
    rule.batches = batches->integer(1, GiveUpRule::kMostFaults);
  }
  return rule;
}

}  // namespace

std::string_view fallback_kind_name(FallbackKind kind) noexcept {
  return kKindNames[static_cast<std::size_t>(kind)];
}

ContainmentSettings read_containment(const YamlValue& plugin) {
  ContainmentSettings settings;
  if (const auto fallback = plugin.find("fallback")) {
    settings.fallback = read_kind(*fallback);
  }
  if (const auto budget = plugin.find("budget")) {
    settings.budget_ns = read_time(*budget, 1e3, 8e7, "1 us and 80 ms");
  }
  if (const auto give_up = plugin.find("give_up_after")) {
    settings.give_up = read_give_up(*give_up);
  }
  return settings;
}

}  // namespace gaitway::core
