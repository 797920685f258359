// The balance feedback that suits a robot before anybody has configured one.
#pragma once

#include "gaitway/stability/balance_parameters.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::stability {

// The defaults scaled to the robot's body (BodyScale), but for what the hips answer to the trunk's rate,
// which sets the trunk chattering at 25 Hz if it is too much:
// - The answer comes a slot late on any body, so it is no larger on a large one than on humanoid22.
// - A turn of the hips by the angle q lets the trunk turn within that slot at the mean rate phi q / 10 ms,
// where
//   phi = 1 - exp(-10 ms d / J) with the trunk's inertia J about the hips and the damping d of both servos. A
//   light trunk follows at once; the answer to that rate is no larger a share of q than humanoid22's.
[[nodiscard]] BalanceParameters balance_of(const urdf::RobotModel& robot);

}  // namespace gaitway::stability
