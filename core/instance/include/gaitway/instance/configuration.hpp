// Which plug-ins the main controller loads, with which parameters, what each may cost and do, and what is
// done when it fails, as read from a YAML file:
//
//   plugins:
//     - name: trajectory                           # unique; also what faults and statistics are called by
//       library: libgaitway_plugin_trajectory.so   # on the search path; default:
//       libgaitway_plugin_<name>.so;
//                                                  # or a plug-in in Python: ./sway.py
//       parameters: {step_time: 0.4 s, lift: 0.03 m}
//       budget: 5 ms                               # of a step
//       fallback: safe_tail                        # see FallbackKind
//       give_up_after: {faults: 20, within: 2 s, batches: 8}
//       isolation: process                         # in a process of its own; default: none. For such a one:
//       sockets: local                             # it may use Unix sockets; default: none
//       descriptors: 512                           # open files, 16..4096
//       memory: 1 GiB                              # address space, 64 MiB..64 GiB
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gaitway::core {

// What is wrong with a configuration: names file, line, key, value, rule and remedy.
class ConfigurationError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Why plug-ins could not be loaded, put in order or activated: names the plug-in, its place in the
// configuration, what was found, the rule and the remedy. Thrown during set-up only.
class PluginError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct ParameterEntry {
  std::string name;
  std::string text;  // as written; the plug-in's declaration says what it is read as
  int line = 0;      // 1 is the first
};

enum class Isolation : std::uint8_t { none, process };

// When a plug-in that is stepped every tick has its turn instead: in one tick of each period.
struct StepSchedule {
  std::uint32_t every_ticks = 1;
  std::uint32_t phase_ticks = 0;  // < every_ticks
};

// Who writes a plug-in's topics while it fails.
enum class FallbackKind : std::uint8_t {
  by_topics,         // the default: as its topics ask for
  none,              // nobody: the last values stay, and no batch is handed over that depends on them
  estimate,          // estimate from encoders and IMU
  trims_from_gains,  // trims go over to what the last gains make of the estimate, corrections fade to zero
  trims_to_zero,     // trims and corrections fade to zero
  stop,              // walk command: stop and stand
  safe_tail          // nobody: no batch is handed over, and the message controller plays its safe tail
};
[[nodiscard]] std::string_view fallback_kind_name(FallbackKind kind) noexcept;

// When a plug-in is put out of service.
struct GiveUpRule {
  static constexpr int kMostFaults = 100;
  int faults = 20;                         // of a plug-in that is stepped every tick: so many ...
  std::int64_t within_ns = 2'000'000'000;  // ... within this time
  int batches = 8;                         // of one that is stepped every batch: so many in a row
  bool never = false;                      // instead
};

struct ContainmentSettings {
  FallbackKind fallback = FallbackKind::by_topics;
  std::int64_t budget_ns = 0;  // of a step; 0: the default of its period
  GiveUpRule give_up = {};
};

// Of a step of a plug-in with these settings; `every_batch`: it is stepped in ticks that prepare a batch
// alone.
[[nodiscard]] constexpr std::int64_t step_budget_ns(const ContainmentSettings& settings,
                                                    bool every_batch) noexcept {
  constexpr std::int64_t kTickBudget_ns = 2'000'000, kBatchBudget_ns = 5'000'000;
  return settings.budget_ns > 0 ? settings.budget_ns : every_batch ? kBatchBudget_ns : kTickBudget_ns;
}

// Of a plug-in with Isolation::process.
struct ChildSettings {
  bool local_sockets = false;          // it may use Unix sockets: for a link to another process of the robot
  bool answers_next_step = false;      // no tick waits for its step; the next one takes what it gave
  std::uint32_t descriptor_limit = 0;  // 0: what all have
  std::uint64_t memory_limit_bytes = 0;  // 0: the same
};

struct PluginEntry {
  std::string name;
  std::string library;
  int line = 0;
  std::vector<ParameterEntry> parameters = {};
  Isolation isolation = Isolation::none;
  StepSchedule schedule = {};
  ContainmentSettings containment = {};
  ChildSettings child = {};
};

// A plug-in in Python is named by its file, NAME.py, in the place of a library: an interpreter runs it.
[[nodiscard]] constexpr bool is_python(std::string_view library) noexcept {
  return library.ends_with(".py");
}

// As its entry says; an interpreter is always in a process of its own.
[[nodiscard]] constexpr bool has_own_process(const PluginEntry& entry) noexcept {
  return entry.isolation == Isolation::process || is_python(entry.library);
}

struct Configuration {
  std::filesystem::path file;
  std::vector<PluginEntry> plugins;  // in the file's order
};

// Both throw ConfigurationError. `file`: what errors call it, and the folder of relative library paths.
Configuration read_configuration(const std::filesystem::path& file);
Configuration parse_configuration(const std::string& text, const std::filesystem::path& file);

}  // namespace gaitway::core
