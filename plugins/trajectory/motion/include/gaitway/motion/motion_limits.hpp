// What a planned motion may ask of the robot, and the check of every point against it.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/motion.hpp"
#include "gaitway/motion/motion_plan.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::motion {

struct MotionLimits {
  double joint_margin_rad = 0.009;  // kept from each joint's stops
  double speed_share = 0.9;         // of motor and reference speed
  double torque_share = 0.8;        // of what the motor gives at the speed of that instant
  // Not the robot's but the servo's: what it follows within a degree.
  double acceleration_limit_rad_per_s2 = 120.0;
  double zmp_margin_m = 0.012;      // inside the edges of the support
  double friction_share = 0.6;      // of the ground's coefficient
  double least_weight_share = 0.3;  // of the weight that stays on the ground
};

// Those of the motion: no more torque than its own share, if it says one.
[[nodiscard]] MotionLimits limits_of(const Motion& motion, MotionLimits limits) noexcept;

// The same in numbers for each joint.
struct JointLimits {
  JointLimits(const urdf::RobotModel& robot, const MotionLimits& limits);

  // Largest torque at that speed: fades to zero at the motor's speed limit when it drives, not when it
  // brakes.
  [[nodiscard]] double torque_Nm(Eigen::Index joint, double at_speed_rad_per_s,
                                 double asked_Nm) const noexcept;

  Eigen::VectorXd lower_rad, upper_rad;
  // The least of motor, reference and wire: a byte of counts in a point, less one for the rounding.
  Eigen::VectorXd speed_rad_per_s;
  Eigen::VectorXd acceleration_rad_per_s2;
  Eigen::VectorXd standstill_torque_Nm, motor_speed_rad_per_s;
};

enum class LimitKind : std::uint8_t {
  position,
  speed,
  acceleration,
  torque,
  zmp,
  friction,
  weight,
  foot_place,
};

// How near the motion comes to a limit: the worst point.
struct LimitUse {
  LimitKind kind = LimitKind::position;
  std::string what;  // the joint, or what else is limited
  std::string unit;
  double time_s = 0.0;
  double value = 0.0, limit = 0.0;  // in the unit
  double excess = -1e9;             // in the unit; > 0: the limit does not hold
};

struct PlanReport {
  std::vector<LimitUse> uses;  // one for each kind that could be checked

  [[nodiscard]] const LimitUse* broken() const noexcept;  // the first limit that does not hold, or none
};

[[nodiscard]] std::string_view name_of(LimitKind kind) noexcept;
// E.g. "left_knee: torque 9.1 N·m at 1.23 s, limit 6.4 N·m".
[[nodiscard]] std::string describe(const LimitUse& use);

// At every point, from the points alone: whatever made them.
[[nodiscard]] PlanReport check_plan(const urdf::RobotModel& robot, const MotionPlan& plan,
                                    const MotionLimits& limits);

}  // namespace gaitway::motion
