// The robot of the twin's tests.
#pragma once

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::tools {

inline const urdf::RobotModel& twin_robot() {
  static const urdf::RobotModel robot = urdf::load_robot(GAITWAY_SOURCE_DIR "/urdf/humanoid22");
  return robot;
}

}  // namespace gaitway::tools
