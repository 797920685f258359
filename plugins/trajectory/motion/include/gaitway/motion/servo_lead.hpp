// The references with which compliant servos move as planned.
#pragma once

#include <vector>

#include "gaitway/motion/motion_plan.hpp"

namespace gaitway::motion {

// A servo gives a torque only by lagging behind its reference. So that the joint and not the reference is
// where the plan wants it, the reference leads by what the planned torque takes, beyond what standing at home
// takes: rows as the plan's, equal to them where the robot stands at home, and where its contact is none.
[[nodiscard]] std::vector<double> leading_references(const urdf::RobotModel& robot, const MotionPlan& plan);

}  // namespace gaitway::motion
