// Where the robot, the configuration and the plug-ins are found when nobody says otherwise: in the source
// tree for a build tree's command, beside the command for an installed one.
#pragma once

#include <filesystem>
#include <vector>

namespace gaitway::tools {

std::filesystem::path default_robot_directory();
std::filesystem::path default_config_file();
std::vector<std::filesystem::path> plugin_directories();

}  // namespace gaitway::tools
