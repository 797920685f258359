// What the walking pattern needs to know of a robot, from its description by forward kinematics.
#pragma once

#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::trajectory {

// `parameters` with CoM height and place, hip height, foot spacing and sole of the robot in its standing
// posture (all joints at home_rad), so that the nominal stand of the plans is the posture that the joints
// hold. The ZMP is put below the middle of the sole.
[[nodiscard]] GaitParameters with_standing_posture(GaitParameters parameters, const urdf::RobotModel& robot);

// Whether a robot with `parameters` stands as one with `described` does: CoM, hips and feet.
[[nodiscard]] bool stands_as_described(const GaitParameters& parameters,
                                       const GaitParameters& described) noexcept;

}  // namespace gaitway::trajectory
