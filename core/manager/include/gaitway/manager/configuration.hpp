// Which plug-ins the main controller loads, and their parameters, as read from a YAML file:
//
//   plugins:
//     - name: trajectory                           # unique; also what faults and statistics are called by
//       library: libgaitway_plugin_trajectory.so   # on the search path; default: libgaitway_plugin_<name>.so
//       isolation: none                            # default; process: in a process of its own, of which
//                                                  # isolation/settings.hpp says more
//       parameters: {step_time: 0.4 s, lift: 0.03 m}
//       budget: 5 ms                               # and what else containment_settings.hpp says
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/isolation/settings.hpp"
#include "gaitway/manager/containment_settings.hpp"

namespace gaitway::core {

// What is wrong with a configuration: names file, line, key, value, rule and remedy.
class ConfigurationError : public std::runtime_error {
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

struct PluginEntry {
  std::string name;
  std::string library;
  int line = 0;
  std::vector<ParameterEntry> parameters = {};
  Isolation isolation = Isolation::none;
  StepSchedule schedule = {};
  ContainmentSettings containment = {};
  ChildSettings child = {};  // with Isolation::process
};

struct Configuration {
  std::filesystem::path file;
  std::vector<PluginEntry> plugins;  // in the file's order
};

// Both throw ConfigurationError. `file`: what errors call it, and the folder of relative library paths.
Configuration read_configuration(const std::filesystem::path& file);
Configuration parse_configuration(const std::string& text, const std::filesystem::path& file);

}  // namespace gaitway::core
