// Where the parts of this installation lie, found from the place of the running code: nothing of it is fixed
// at build time, so an installation may be moved. A build tree is laid out like an installation.
//
//   <root>/bin                          programs
//   <root>/lib/gaitway                  libraries that they bring along; plugins/ the plug-ins
//   <root>/share/gaitway                urdf/, config/, scenarios/, templates/, motions/, prepared_motions/,
//                                       calibration/
#pragma once

#include <filesystem>

namespace gaitway::process {

// The root; empty if this code lies in no installation.
[[nodiscard]] std::filesystem::path installation_root();

// The folders hold what they should, or std::runtime_error says where it was looked for.
[[nodiscard]] std::filesystem::path default_robot_directory();
[[nodiscard]] std::filesystem::path default_config_file();
[[nodiscard]] std::filesystem::path scenario_directory();
[[nodiscard]] std::filesystem::path template_directory();
[[nodiscard]] std::filesystem::path motion_directory();
[[nodiscard]] std::filesystem::path calibration_directory();

// Where the motions are that a robot can play; empty if this code lies in no installation.
[[nodiscard]] std::filesystem::path prepared_motion_directory();

// Where the shipped plug-ins are; empty if this code lies in no installation.
[[nodiscard]] std::filesystem::path shipped_plugin_directory();

// The folder that find_package(gaitway) needs as gaitway_DIR.
[[nodiscard]] std::filesystem::path package_directory();

}  // namespace gaitway::process
