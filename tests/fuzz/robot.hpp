// The shipped robot, loaded once.
#pragma once

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::fuzz {

inline const urdf::RobotModel& shipped_robot() {
  static const urdf::RobotModel robot = urdf::load_robot(GAITWAY_ROBOT_DIRECTORY);
  return robot;
}

}  // namespace gaitway::fuzz
