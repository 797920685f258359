// Reads motions from YAML files, strictly.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/motion/motion.hpp"

namespace gaitway::motion {

// Throws urdf::RobotError with file, line, field, value, rule and remedy.
[[nodiscard]] Motion read_motion(const std::filesystem::path& file, const urdf::RobotModel& robot);

// The same of a text; `file` is what complaints call it.
[[nodiscard]] Motion parse_motion(const std::string& text, const std::filesystem::path& file,
                                  const urdf::RobotModel& robot);

// The motions of a folder: its *.yaml files, in the order of their names. Throws
// urdf::RobotError if it is none.
[[nodiscard]] std::vector<std::filesystem::path> motion_files(const std::filesystem::path& folder);

}  // namespace gaitway::motion
