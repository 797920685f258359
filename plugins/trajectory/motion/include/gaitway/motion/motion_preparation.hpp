// From a motion's keys to the table that the robot plays: planned, with a way out from every batch.
#pragma once

#include "gaitway/motion/motion_planner.hpp"
#include "gaitway/trajectory/motion_table.hpp"

namespace gaitway::motion {

struct PreparedMotion {
  trajectory::MotionTable table;
  PlannedMotion planned;
  std::size_t longest_exit_points = 0;
};

// Throws MotionError if the motion, or a way out of it, breaks a limit; std::runtime_error if the robot's
// description cannot be read.
[[nodiscard]] PreparedMotion prepare_motion(const urdf::RobotModel& robot, const Motion& motion,
                                            const PlannerOptions& options);

}  // namespace gaitway::motion
