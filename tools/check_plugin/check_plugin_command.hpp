// `gaitway check-plugin`: a plug-in against every rule of the plug-in interface.
#pragma once

#include <filesystem>
#include <optional>

#include "tools/check_plugin/plugin_check.hpp"

namespace CLI {
class App;
}

namespace gaitway::tools {

struct CheckPluginOptions {
  plugin_check::CheckOptions check;
  std::optional<std::filesystem::path> json;  // everything that was found and measured goes here
};

CLI::App* add_check_plugin_command(CLI::App& app, CheckPluginOptions& options);

// Exit codes of `gaitway check-plugin`; bad input is 1.
inline constexpr int kExitFindings = 2;

// Prints one line a check. Throws on bad input.
int check_plugin(const CheckPluginOptions& options);

}  // namespace gaitway::tools
