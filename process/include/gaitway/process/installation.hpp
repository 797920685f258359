// Where the parts of this installation lie, found from the place of the running code: nothing of it is fixed
// at build time, so an installation may be moved. A build tree is laid out like an installation.
//
//   <root>/bin                          programs
//   <root>/lib/gaitway                  libraries that they bring along; plugins/ the plug-ins
//   <root>/share/gaitway                urdf/, config/, scenarios/, worlds/, missions/, templates/,
//                                       calibration/
//
// Of a build tree, urdf/ is the source tree's, into which nothing is built: what is prepared for its robots
// lies in prepared_motions/ROBOT.
#pragma once

#include <filesystem>
#include <vector>

namespace gaitway::process {

// The root; empty if this code lies in no installation.
[[nodiscard]] std::filesystem::path installation_root();

// The folders hold what they should, or std::runtime_error says where it was looked for.
[[nodiscard]] std::filesystem::path default_robot_directory();
[[nodiscard]] std::filesystem::path config_directory();
[[nodiscard]] std::filesystem::path default_config_file();  // in it
[[nodiscard]] std::filesystem::path scenario_directory();
[[nodiscard]] std::filesystem::path world_directory();
[[nodiscard]] std::filesystem::path mission_directory();
[[nodiscard]] std::filesystem::path template_directory();
[[nodiscard]] std::filesystem::path calibration_directory();

// The key-frame motions of a robot, in its own folder: NAME.yaml as people write it, NAME.motion as it is
// played.
[[nodiscard]] std::filesystem::path motion_directory(const std::filesystem::path& robot_directory);

// Where motions are that the robot can play, the first before the others: its folder's, and, in a build tree,
// those that were built for it. The folders need not exist.
[[nodiscard]] std::vector<std::filesystem::path> prepared_motion_directories(
    const std::filesystem::path& robot_directory);

// Where the shipped plug-ins are; empty if this code lies in no installation.
[[nodiscard]] std::filesystem::path shipped_plugin_directory();

// The folder that find_package(gaitway) needs as gaitway_DIR.
[[nodiscard]] std::filesystem::path package_directory();

}  // namespace gaitway::process
