// A log of one robot's bus, checked, and laid out from the robot's start on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "gaitway/can/candump_log.hpp"
#include "gaitway/can/profile.hpp"

namespace gaitway::tools {

struct RobotLog {
  std::vector<can::LoggedFrame> frames;
  std::int64_t shift_ns = 0;  // what was taken off a log of another clock than the robot's
};

// Throws std::runtime_error or std::invalid_argument that names file, line or frame, and rule: not candump's
// format, no frame, out of order, or for the most part no messages of the profile.
[[nodiscard]] RobotLog read_robot_log(const std::filesystem::path& file, const can::Profile& profile);

}  // namespace gaitway::tools
