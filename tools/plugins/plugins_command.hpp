// `gaitway plugins`: which plug-ins there are, and what each says of itself.
#pragma once

#include <filesystem>
#include <vector>

namespace CLI {
class App;
}

namespace gaitway::tools {

struct PluginsOptions {
  std::vector<std::filesystem::path> plugin_path;  // these alone; empty: the search path
  std::filesystem::path robot;                     // what the plug-ins are told
  bool json = false;
};

// Adds the subcommand; `options` is filled when it is parsed.
CLI::App* add_plugins_command(CLI::App& app, PluginsOptions& options);

// Prints the list; returns the exit code: 1 if a library is not usable or a given folder is none.
int list_plugins(const PluginsOptions& options);

}  // namespace gaitway::tools
