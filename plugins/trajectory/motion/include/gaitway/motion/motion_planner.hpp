// From a motion's keys to the table that the robot plays: points, ways out from every batch, rows.
#pragma once

#include <cstddef>
#include <vector>

#include "gaitway/motion/motion_limits.hpp"
#include "gaitway/motion/motion_path.hpp"
#include "gaitway/motion/motion_plan.hpp"
#include "gaitway/trajectory/motion_table.hpp"

namespace gaitway::motion {

struct PlannerOptions {
  MotionLimits limits;
  double smoothness = 3e-7;  // weight of the squared jerk against time, s per (rad/s³)²·s
};

struct PlannedMotion {
  MotionPlan plan;
  PlanReport report;            // of the check of every point: all limits hold
  double first_duration_s = 0;  // of the slow first guess
  double stretch = 1.0;         // by how much the optimum was slowed down in the end, so that all limits hold
};

// Optimises durations, and velocities and accelerations at the keys that are passed through, with Ceres; then
// checks every point. Throws MotionError if a key is not possible, or the limits do not even hold on a slow
// way.
[[nodiscard]] PlannedMotion plan_motion(const urdf::RobotModel& robot, const Motion& motion,
                                        const PlannerOptions& options);

// How a motion is left before its end: from each batch's end a way to rest that keeps the limits, too.
struct ExitPlan {
  std::vector<trajectory::MotionExit> exits;  // one for each batch of the motion, and one for its end
  std::vector<MotionPlan> ways;               // whole batches; only their points, without keys
};

// `plan`: whole batches after its first point. Where both feet stand, the fastest way home that the limits
// allow is looked for, from the posture and the speed of that point; the exit is the sooner of it and of
// going on to where there is one. Where nothing stands, the joints come to rest where they are. Throws
// MotionError when from some point the robot would not rest within the longest safe tail.
[[nodiscard]] ExitPlan plan_exits(const urdf::RobotModel& robot, const MotionPlan& plan,
                                  const MotionLimits& limits);

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
