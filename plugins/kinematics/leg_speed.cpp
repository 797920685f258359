// One joint after the other, from point to point.
#include "gaitway/kinematics/leg_speed.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "gaitway/facts/facts.hpp"

namespace gaitway::kinematics {

LegSpeed::LegSpeed(const urdf::RobotModel& model) {
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < 6; ++i) {
      const int index = model.legs[side].joints[i];
      const urdf::Joint& joint = model.joints[static_cast<std::size_t>(index)];
      // The wire carries whole counts, from rounded to rounded.
      const double byte_rad = (facts::kLargestByte_counts - 1) * joint.count_rad;
      joints_[side][i] = {index, std::min(joint.velocity_limit_rad_per_s * facts::kSlot_s, byte_rad)};
    }
  }
}

void LegSpeed::keep(JointPlan& joint_plan, int points, const LegAngles* start_rad) const noexcept {
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < 6; ++i) {
      const Joint& joint = joints_[side][i];
      const double start = start_rad != nullptr ? (*start_rad)[side][i] : joint_plan.position[0][joint.index];
      if (farthest_behind_rad(joint_plan, points, joint, start) <= kMostBehind_rad)
        follow(joint_plan, points, joint, start);
    }
  }
}

double LegSpeed::farthest_behind_rad(const JointPlan& joint_plan, int points, const Joint& joint,
                                     double reference_rad) noexcept {
  double farthest_rad = 0.0;
  for (int point = 0; point < points; ++point) {
    const double behind_rad = joint_plan.position[point][joint.index] - reference_rad;
    if (!std::isfinite(behind_rad)) return std::numeric_limits<double>::infinity();
    const double step_rad = std::clamp(behind_rad, -joint.most_rad, joint.most_rad);
    farthest_rad = std::max(farthest_rad, std::abs(behind_rad - step_rad));
    reference_rad += step_rad;
  }
  return farthest_rad;
}

void LegSpeed::follow(JointPlan& joint_plan, int points, const Joint& joint, double reference_rad) noexcept {
  for (int point = 0; point < points; ++point) {
    float& asked_rad = joint_plan.position[point][joint.index];
    const double behind_rad = static_cast<double>(asked_rad) - reference_rad;
    if (std::abs(behind_rad) <= joint.most_rad) {
      reference_rad = asked_rad;
      continue;
    }
    reference_rad += std::copysign(joint.most_rad, behind_rad);
    asked_rad = static_cast<float>(reference_rad);
  }
}

LegAngles LegSpeed::references_rad(const JointPlan& joint_plan, int point) const noexcept {
  LegAngles references{};
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < 6; ++i)
      references[side][i] = joint_plan.position[point][joints_[side][i].index];
  }
  return references;
}

}  // namespace gaitway::kinematics
