// What a plug-in library says of itself. It is found out in a process of its own, so that a library that
// crashes or hangs there harms nobody.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/parameter_set.hpp"
#include "gaitway/instance/plugin_library.hpp"
#include "gaitway/instance/topic_port.hpp"
#include "gaitway/plugin/cycle.hpp"

namespace gaitway::core {

struct PluginDescription {
  std::filesystem::path file;
  std::string name;
  std::string version;
  std::string text;
  Period period = Period::tick;
  std::vector<TopicUse> topics;
  std::vector<Parameter> parameters;

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
