// The robot that the tests of the feed publish.
#pragma once

#include <filesystem>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api::test {

inline const urdf::RobotModel& humanoid() {
  static const urdf::RobotModel robot =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  return robot;
}

}  // namespace gaitway::api::test
