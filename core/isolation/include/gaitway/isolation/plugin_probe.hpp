// What a plug-in library says of itself. It is found out in a process of its own, so that a library that
// crashes or hangs there harms nobody.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/manager/configuration.hpp"
#include "gaitway/manager/data_flow.hpp"
#include "gaitway/manager/plugin_library.hpp"

namespace gaitway::core {

struct DescribedTopic {
  std::string name;
  std::string type_name;
  Access access = Access::read;
};

struct DescribedParameter {
  std::string name;
  std::string kind;      // parameter_kind_name()
  std::string unit;      // "1": a plain number; empty for flags and texts
  std::string fallback;  // the default, as text
  std::string doc;       // one line for people; may be empty
  double lowest = 0.0;   // of numbers; infinite: no limit
  double highest = 0.0;
  bool live = false;  // may be changed while the plug-in runs
};

struct PluginDescription {
  std::filesystem::path file;
  std::string name;
  std::string version;
  std::string text;
  bool every_tick = true;  // false: only at ticks that prepare a batch
  std::vector<DescribedTopic> topics;
  std::vector<DescribedParameter> parameters;

  [[nodiscard]] bool writes(std::string_view topic) const noexcept;
};

struct ProbeOptions {
  std::filesystem::path robot_directory;  // what the plug-in is told
  SearchPath plugin_path;                 // complete; see plugin_search_path()
  std::chrono::milliseconds patience{10'000};
};

// Constructs the entry's plug-in once, with its parameters, and destroys it. `configuration`: the file that
// relative paths start from. Throws PluginError: it cannot be loaded or constructed, crashed or did not end.
// For set-up.
PluginDescription probe_plugin(const PluginEntry& entry, const std::filesystem::path& configuration,
                               const ProbeOptions& options);

// The same of a library file that no configuration names.
PluginDescription probe_plugin(const std::filesystem::path& library, const ProbeOptions& options);

// Whether the file is a shared library with a plug-in's entry symbol. Reads it, runs nothing of it.
[[nodiscard]] bool is_plugin_library(const std::filesystem::path& file);

}  // namespace gaitway::core
