// The robot's side of the robot API in a configuration of plug-ins.
#pragma once

#include <string>

#include "gaitway/instance/configuration.hpp"

namespace gaitway::tools {

// The plug-in that keeps the link to the user interface module. Throws std::invalid_argument: there is none.
[[nodiscard]] core::PluginEntry& api_of(core::Configuration& configuration);
// Where it keeps it, in place of what the configuration says.
void set_link(core::PluginEntry& api, const std::string& link);

}  // namespace gaitway::tools
