// The balance feedback that suits a robot before anybody has configured one.
#pragma once

#include "gaitway/stability/balance_parameters.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::stability {

// The defaults scaled to the robot's body (BodyScale). The hips' rate gains are no larger than a light trunk
// on strong hips bears: a turn of the hips by the angle q lets it turn within one 10 ms sample at the mean
// rate phi q / 10 ms, where phi = 1 - exp(-10 ms / (J / d)) with the trunk's inertia J about the hips and the
// damping d of both servos. The answer to that rate must not be larger than q, or the trims answer themselves
// and the standing robot chatters. Simulated robots begin to at twice that.
[[nodiscard]] BalanceParameters balance_of(const urdf::RobotModel& robot);

}  // namespace gaitway::stability
