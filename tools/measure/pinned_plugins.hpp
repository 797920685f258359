// Copies of the plug-ins' libraries that a measurement of hours runs with, so that a build meanwhile changes
// nothing.
#pragma once

#include <filesystem>

#include "gaitway/manager/configuration.hpp"
#include "gaitway/manager/plugin_library.hpp"

namespace gaitway::tools {

// Copies each library into the folder, under a name that its content determines, and lets the configuration
// name the copies. Throws core::PluginError for a library that cannot be loaded, std::runtime_error when the
// copy fails.
void pin_plugins(core::Configuration& plugins, const core::SearchPath& plugin_path,
                 const std::filesystem::path& folder);

// Removes the copies in the folder that the configuration does not name; for whoever has the folder for
// himself.
void remove_other_plugins(const core::Configuration& plugins, const std::filesystem::path& folder);

}  // namespace gaitway::tools
