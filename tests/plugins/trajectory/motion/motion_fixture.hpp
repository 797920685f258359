// The robot and its shipped motions, for the tests of motions.
#pragma once

#include <filesystem>
#include <numbers>
#include <string>

#include "gaitway/motion/motion.hpp"
#include "gaitway/motion/motion_planner.hpp"

namespace gaitway::motion {

inline constexpr double kDegree = std::numbers::pi / 180.0;

inline const urdf::RobotModel& humanoid22() {
  static const urdf::RobotModel robot = urdf::load_robot(GAITWAY_ROBOT);
  return robot;
}

inline Motion shipped(const std::string& name) {
  return read_motion(std::filesystem::path(GAITWAY_MOTIONS) / (name + ".yaml"), humanoid22());
}

inline Motion of_keys(const std::string& keys) {
  return parse_motion("name: test\ndescription: for a test\nkeys:\n" + keys, "test.yaml", humanoid22());
}

}  // namespace gaitway::motion
