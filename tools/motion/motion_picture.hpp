// Film strips of planned motions.
#pragma once

#include <filesystem>

#include "gaitway/motion/motion_plan.hpp"

namespace gaitway::tools {

// The planned postures, evenly spread over the motion's time. Throws std::runtime_error where no picture can
// be made.
void draw_motion(const urdf::RobotModel& robot, const motion::MotionPlan& plan, int pictures,
                 const std::filesystem::path& file);

}  // namespace gaitway::tools
