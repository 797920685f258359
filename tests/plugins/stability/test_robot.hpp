// The robot of the tests, as it is and with joints that turn the other way.
#pragma once

#include <string>

#include "gaitway/stability/balance_parameters.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::stability::test {

inline const BalanceParameters kDefaults;

inline const urdf::RobotModel& humanoid() {
  static const urdf::RobotModel model = urdf::load_robot(GAITWAY_URDF_DIR "/humanoid22");
  return model;
}

// The same body; every second leg joint counts its angle the other way round.
inline urdf::RobotModel robot_with_flipped_axes() {
  urdf::RobotModel model = humanoid();
  for (const auto& leg : model.legs) {
    for (const std::size_t joint : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
      urdf::Joint& flipped = model.joints[static_cast<std::size_t>(leg.joints[joint])];
      flipped.axis = -flipped.axis;
      flipped.home_rad = -flipped.home_rad;
    }
  }
  return model;
}

// Channel of a leg joint (2 hip pitch, 4 ankle pitch, 5 ankle roll).
inline std::size_t channel_of(const urdf::RobotModel& model, std::size_t side, std::size_t leg_joint) {
  return static_cast<std::size_t>(
      model.joints[static_cast<std::size_t>(model.legs[side].joints[leg_joint])].trim_channel);
}
inline const std::size_t kLeftAnklePitch = channel_of(humanoid(), 0, 4);

}  // namespace gaitway::stability::test
