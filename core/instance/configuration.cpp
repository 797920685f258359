// Reads the plug-in list; every complaint says where.
#include "gaitway/instance/configuration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/input/yaml_value.hpp"

namespace gaitway::core {
namespace {

using input::YamlValue;

// Each pair of them is compared, and each is tried in a process of its own: thousands would take minutes.
constexpr std::size_t kMostPlugins = 64;

std::string name_of(const YamlValue& value, const std::vector<PluginEntry>& others) {
  constexpr std::size_t kLongest = 40;
  const std::string name = value.text();
  const bool printable = std::ranges::all_of(name, [](char c) { return c > ' ' && c < 0x7f; });
  if (name.empty() || name.size() > kLongest || !printable) {
    value.refuse(fmt::format("must have 1 to {} printable characters without spaces", kLongest),
                 "Choose another name");
  }
  const auto first = std::ranges::find(others, name, &PluginEntry::name);
  if (first != others.end()) {
    value.refuse(fmt::format("is already the plug-in of line {}; names must be unique", first->line),
                 "Give one of them another name");
  }
  return name;
}

std::string library_of(const YamlValue& value) {
  std::string library = value.text();
  if (library.empty()) {
    value.refuse("must not be empty", "Name the shared library, or leave the key out");
  }
  return library;
}

Isolation isolation_of(const YamlValue& value) {
  const std::string text = value.text();
  if (text != "process" && text != "none") {
    value.refuse("must be 'process' or 'none'",
                 "'process' runs the plug-in in a process of its own, 'none' in the main controller's");
  }
  return text == "process" ? Isolation::process : Isolation::none;
}

std::uint32_t ticks_of(const YamlValue& value, std::int64_t lowest_ns, std::int64_t highest_ns) {
  const std::int64_t time_ns = value.number_with_unit(input::kTimeUnits_ns, lowest_ns, highest_ns);
  if (time_ns % facts::kSlot_ns != 0) {
    value.refuse("must be a multiple of the tick of 10 ms", "Round it");
  }
  return static_cast<std::uint32_t>(time_ns / facts::kSlot_ns);
}

StepSchedule schedule_of(const YamlValue& plugin) {
  constexpr std::int64_t kLongest_ns = 1'000'000'000;
  StepSchedule schedule;
  if (const auto period = plugin.find("period")) {
    schedule.every_ticks = ticks_of(*period, facts::kSlot_ns, kLongest_ns);
  }
  if (const auto phase = plugin.find("phase")) {
    schedule.phase_ticks = ticks_of(*phase, 0, kLongest_ns);
    if (schedule.phase_ticks >= schedule.every_ticks) {
      phase->refuse("must be less than the period", "Give a longer period, or an earlier phase");
    }
  }
  return schedule;
}

constexpr std::array<std::string_view, 7> kFallbackNames{
    "by_topics", "none", "estimate", "trims_from_gains", "trims_to_zero", "stop", "safe_tail"};

FallbackKind read_kind(const YamlValue& value) {
  const std::string text = value.text();
  std::vector<std::string> known;
  for (std::size_t kind = 1; kind < kFallbackNames.size(); ++kind) {
    if (text == kFallbackNames[kind]) {
      return static_cast<FallbackKind>(kind);
    }
    known.emplace_back(kFallbackNames[kind]);
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

bool read_sockets(const YamlValue& value) {
  const std::string text = value.text();
  if (text != "local" && text != "none") {
    value.refuse("must be 'local' or 'none'",
                 "'local' lets the plug-in use Unix sockets, 'none' keeps it from all; what serves a network "
                 "belongs beside the user interface module, as its client");
  }
  return text == "local";
}

bool answers_next_step(const YamlValue& value) {
  const std::string text = value.text();
  if (text != "this_step" && text != "next_step") {
    value.refuse("must be 'this_step' or 'next_step'",
                 "'this_step': the tick waits for it; 'next_step': it works beside the tick, and what it "
                 "publishes is there one step later");
  }
  return text == "next_step";
}

ChildSettings read_child_settings(const YamlValue& plugin, bool isolated) {
  ChildSettings settings;
  for (const std::string_view key : {"sockets", "descriptors", "memory", "answer"}) {
    if (const auto value = plugin.find(key); value && !isolated) {
      value->refuse("is for plug-ins in processes of their own alone",
                    "Add 'isolation: process', or leave it out");
    }
  }
  if (const auto sockets = plugin.find("sockets")) {
    settings.local_sockets = read_sockets(*sockets);
  }
  if (const auto answer = plugin.find("answer")) {
    settings.answers_next_step = answers_next_step(*answer);
  }
  if (const auto descriptors = plugin.find("descriptors")) {
    settings.descriptor_limit = static_cast<std::uint32_t>(descriptors->integer(16, 4096));
  }
  if (const auto memory = plugin.find("memory")) {
    settings.memory_limit_bytes = static_cast<std::uint64_t>(
        memory->number_with_unit(input::kSizeUnits_bytes, std::int64_t{64} << 20U, std::int64_t{64} << 30U));
  }
  return settings;
}

PluginEntry read_plugin(const YamlValue& map, const std::vector<PluginEntry>& others) {
  constexpr std::array<std::string_view, 13> kKeys{
      "name",   "library",       "isolation", "parameters",  "period", "phase", "fallback",
      "budget", "give_up_after", "sockets",   "descriptors", "memory", "answer"};
  map.require_map(kKeys);
  PluginEntry entry;
  entry.line = map.line();
  entry.name = name_of(map.at("name"), others);
  const auto library = map.find("library");
  entry.library = library ? library_of(*library) : fmt::format("libgaitway_plugin_{}.so", entry.name);
  if (const auto isolation = map.find("isolation")) {
    entry.isolation = isolation_of(*isolation);
    if (is_python(entry.library) && entry.isolation == Isolation::none) {
      isolation->refuse("must be 'process' for a plug-in in Python",
                        "Leave it out: it has a process of its own");
    }
  }
  const auto parameters = map.find("parameters");
  if (parameters && !parameters->is_empty()) {
    for (const auto& [name, value] : parameters->entries()) {
      entry.parameters.push_back({name, value.text(), value.line()});
    }
  }
  entry.schedule = schedule_of(map);
  entry.containment = read_containment(map);
  entry.child = read_child_settings(map, has_own_process(entry));
  // What users reach the robot through is never put out of service.
  entry.containment.give_up.never = entry.child.local_sockets && !map.find("give_up_after");
  return entry;
}

Configuration read_root(const YamlValue& root) {
  constexpr std::array<std::string_view, 1> kKeys{"plugins"};
  root.require_map(kKeys);
  Configuration configuration{root.file(), {}};
  const YamlValue plugins = root.at("plugins");
  const std::vector<YamlValue> entries = plugins.items();
  if (entries.size() > kMostPlugins) {
    plugins.refuse(fmt::format("must be a list of at most {} plug-ins", kMostPlugins), "Remove the others");
  }
  for (const YamlValue& plugin : entries) {
    configuration.plugins.push_back(read_plugin(plugin, configuration.plugins));
  }
  if (configuration.plugins.empty()) {
    plugins.refuse("must be a list with at least one plug-in", "Add entries like '- name: zmp'");
  }
  return configuration;
}

template <class Read>
Configuration checked(const Read& read) {
  try {
    return read_root(read());
  } catch (const input::InputError& error) {
    throw ConfigurationError(error.what());
  }
}

}  // namespace

std::string_view fallback_kind_name(FallbackKind kind) noexcept {
  return kFallbackNames[static_cast<std::size_t>(kind)];
}

Configuration parse_configuration(const std::string& text, const std::filesystem::path& file) {
  return checked([&] { return YamlValue::parse(text, file); });
}

Configuration read_configuration(const std::filesystem::path& file) {
  return checked([&] { return YamlValue::read(file); });
}

}  // namespace gaitway::core
