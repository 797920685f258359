// Reads the containment of a plug-in strictly.
#include "gaitway/manager/containment_settings.hpp"

#include <array>
#include <string>
#include <vector>

#include "gaitway/input/complaint.hpp"
#include "gaitway/input/yaml_value.hpp"

namespace gaitway::core {
namespace {

using input::YamlValue;

constexpr std::array<std::string_view, 7> kKindNames{"by_topics",     "none", "estimate", "trims_from_gains",
                                                     "trims_to_zero", "stop", "safe_tail"};

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
               input::suggest(text, known));
}

GiveUpRule read_give_up(const YamlValue& map) {
  constexpr std::array<std::string_view, 3> kKeys{"faults", "within", "batches"};
  map.require_map(kKeys);
  GiveUpRule rule;
  if (const auto faults = map.find("faults")) {
    rule.faults = faults->integer(1, GiveUpRule::kMostFaults);
  }
  if (const auto within = map.find("within")) {
    rule.within_ns = within->number_with_unit(input::kTimeUnits_ns, 10'000'000, 1'000'000'000'000);
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
    settings.budget_ns = budget->number_with_unit(input::kTimeUnits_ns, 1000, 80'000'000);
  }
  if (const auto give_up = plugin.find("give_up_after")) {
    settings.give_up = read_give_up(*give_up);
  }
  return settings;
}

}  // namespace gaitway::core
