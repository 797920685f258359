// The robot's limits, joint by joint.
#include "gaitway/motion/motion_limits.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::motion {
namespace {

// Carrying on the rounding of the point before takes one of the counts that a signed byte holds.
constexpr double kLargestStep_counts = facts::kLargestByte_counts - 1;

}  // namespace

JointLimits::JointLimits(const urdf::RobotModel& robot, const MotionLimits& limits) {
  const auto count = static_cast<Eigen::Index>(robot.joints.size());
  for (Eigen::VectorXd* const values : {&lower_rad, &upper_rad, &speed_rad_per_s, &acceleration_rad_per_s2,
                                        &standstill_torque_Nm, &motor_speed_rad_per_s}) {
    values->resize(count);
  }
  for (Eigen::Index j = 0; j < count; ++j) {
    const urdf::Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    // Home may lie nearer to a stop than the margin.
    lower_rad[j] = std::min(joint.lower_rad + limits.joint_margin_rad, joint.home_rad);
    upper_rad[j] = std::max(joint.upper_rad - limits.joint_margin_rad, joint.home_rad);
    speed_rad_per_s[j] = std::min(
        limits.speed_share * std::min(joint.velocity_limit_rad_per_s, joint.motor.speed_limit_rad_per_s),
        kLargestStep_counts * joint.count_rad / facts::kSlot_s);
    acceleration_rad_per_s2[j] = limits.acceleration_limit_rad_per_s2;
    standstill_torque_Nm[j] = limits.torque_share * joint.motor.torque_limit_Nm;
    motor_speed_rad_per_s[j] = joint.motor.speed_limit_rad_per_s;
  }
}

double JointLimits::torque_Nm(Eigen::Index joint, double at_speed_rad_per_s, double asked_Nm) const noexcept {
  const bool driving = asked_Nm * at_speed_rad_per_s > 0.0;
  const double fade =
      driving ? std::max(0.0, 1.0 - std::abs(at_speed_rad_per_s) / motor_speed_rad_per_s[joint]) : 1.0;
  return fade * standstill_torque_Nm[joint];
}

}  // namespace gaitway::motion
