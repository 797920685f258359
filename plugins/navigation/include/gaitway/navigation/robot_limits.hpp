// What the planner has to know of a robot, from its description and its gait.
#pragma once

#include "gaitway/planning/limits.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::navigation {

// Steps are those of the gait that is chosen for the robot. The body is that of its collision shapes in the
// home posture. Heights of steps and unevenness are what humanoid22 walks over unaware, times the robot's
// size.
[[nodiscard]] planning::Limits limits_of(const urdf::RobotModel& robot);

// How long a step of that gait takes.
[[nodiscard]] double step_time_s(const urdf::RobotModel& robot);

// Of a map for it: 10 mm on humanoid22.
[[nodiscard]] double cell_for(const planning::Limits& limits);

}  // namespace gaitway::navigation
