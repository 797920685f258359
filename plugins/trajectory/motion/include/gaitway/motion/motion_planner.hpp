// From a motion's keys to points: the fastest smooth way that the limits allow.
#pragma once

#include "gaitway/motion/key_postures.hpp"
#include "gaitway/motion/motion_plan.hpp"
#include "gaitway/motion/plan_check.hpp"

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

}  // namespace gaitway::motion
