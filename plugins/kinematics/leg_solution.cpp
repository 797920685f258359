// Joint limits of a leg, and failures in words.
#include "gaitway/kinematics/leg_solution.hpp"

#include <fmt/format.h>

#include <limits>

namespace gaitway::kinematics {

LegSolution unreachable(LegStatus status, double excess) noexcept {
  LegSolution solution;
  solution.angle_rad.fill(std::numeric_limits<double>::quiet_NaN());
  solution.status = status;
  solution.excess = excess;
  return solution;
}

LegLimits leg_limits(const urdf::RobotModel& model, urdf::Side side) {
  LegLimits limits;
  const urdf::Leg& leg = model.legs[static_cast<std::size_t>(side)];
  for (std::size_t i = 0; i < 6; ++i) {
    const urdf::Joint& joint = model.joints.at(static_cast<std::size_t>(leg.joints[i]));
    limits.lower_rad[i] = joint.lower_rad;
    limits.upper_rad[i] = joint.upper_rad;
  }
  return limits;
}

void check_limits(const LegLimits& limits, LegSolution& solution) noexcept {
  for (std::size_t i = 0; i < 6; ++i) {
    const double angle = solution.angle_rad[i];
    const double below = limits.lower_rad[i] - angle;
    const double above = angle - limits.upper_rad[i];
    const double excess = below > above ? below : above;
    // Written so that a NaN is a violation.
    if (excess <= kLimitTolerance_rad || excess <= solution.excess) continue;
    solution.status = LegStatus::joint_limit;
    solution.joint = static_cast<int>(i);
    solution.excess = excess;
  }
}

std::string describe(const LegSolution& solution, const urdf::RobotModel& model, urdf::Side side) {
  switch (solution.status) {
    case LegStatus::reached:
      return "the leg reaches the foot pose";
    case LegStatus::over_stretched:
      return fmt::format("the leg is over-stretched by {:.1f} mm", solution.excess * 1e3);
    case LegStatus::over_folded:
      return fmt::format("the foot is too close to the hip by {:.1f} mm", solution.excess * 1e3);
    case LegStatus::not_converged:
      return fmt::format("no posture found that reaches the foot pose, {:.1f} mm are left",
                         solution.excess * 1e3);
    case LegStatus::joint_limit:
      break;
  }
  const auto index = static_cast<std::size_t>(solution.joint);
  const auto joint_index = static_cast<std::size_t>(model.legs[static_cast<std::size_t>(side)].joints[index]);
  const urdf::Joint& joint = model.joints[joint_index];
  return fmt::format("joint '{}' would be at {:.4f} rad, {:.4f} rad beyond its limits [{:.4f}, {:.4f}]",
                     joint.name, solution.angle_rad[index], solution.excess, joint.lower_rad,
                     joint.upper_rad);
}

}  // namespace gaitway::kinematics
