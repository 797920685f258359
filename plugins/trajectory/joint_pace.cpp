// A walk is planned, and each leg solved as a triangle at each point.
#include "gaitway/trajectory/joint_pace.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"

namespace gaitway::trajectory {
namespace {

using urdf::LegJoint;
constexpr std::array kJoints{LegJoint::hip_pitch, LegJoint::knee, LegJoint::ankle_pitch};
using Angles = std::array<double, kJoints.size()>;
constexpr double kSteps = 8.0;  // until the walk is steady

// Of a leg over the point `i` of a plan.
Angles angles_at(const MotionPlan& plan, std::size_t i, std::size_t side, const LegReach& leg) noexcept {
  const Eigen::Rotation2Dd base(plan.base_yaw[i]), foot(plan.foot_yaw[i][side]);
  const Eigen::Vector2d hip = Eigen::Vector2d(plan.com[i][0], plan.com[i][1]) +
                              base * Eigen::Vector2d(leg.hip_forward_m, leg.hip_left_m);
  const Eigen::Vector2d ankle =
      Eigen::Vector2d(plan.foot_position[i][side][0], plan.foot_position[i][side][1]) +
      foot * Eigen::Vector2d(leg.ankle_forward_m, leg.ankle_left_m);
  const Eigen::Vector2d out = base.inverse() * (ankle - hip);
  const double down = plan.hip_height[i] - leg.ankle_height_m - plan.foot_position[i][side][2];
  const double depth = std::hypot(down, out.y());
  const double cosine = (out.x() * out.x() + depth * depth - leg.aside_m * leg.aside_m -
                         leg.thigh_m * leg.thigh_m - leg.shin_m * leg.shin_m) /
                        (2.0 * leg.thigh_m * leg.shin_m);
  const double knee = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double hip_pitch = -std::atan2(out.x(), depth) -
                           std::atan2(leg.shin_m * std::sin(knee), leg.thigh_m + leg.shin_m * std::cos(knee));
  return {hip_pitch, knee, -hip_pitch - knee};
}

}  // namespace

JointPace fastest_joint(const GaitParameters& parameters, const urdf::RobotModel& robot,
                        double forward_m_per_s) {
  const std::array<LegReach, 2> legs = leg_reach(robot);
  const urdf::ForwardKinematics home(robot);
  std::array<Angles, 2> limits_rad_per_s{};
  for (const urdf::Side side : urdf::kSides) {
    const urdf::LegJoints joints(robot, home, side);
    for (std::size_t j = 0; j < kJoints.size(); ++j) {
      limits_rad_per_s[urdf::index_of(side)][j] =
          robot.joints[static_cast<std::size_t>(joints[kJoints[j]])].velocity_limit_rad_per_s;
    }
  }
  WalkCommand walk{};
  walk.walk = 1;
  walk.velocity[0] = forward_m_per_s;
  const double seconds = parameters.lead_in_s + kSteps * parameters.step_time_s +
                         forward_m_per_s / parameters.forward_acceleration_m_per_s2;
  WalkingPattern pattern(parameters);
  const auto plan = std::make_unique<MotionPlan>();
  JointPace fastest;
  for (std::uint32_t batch = 1; batch * facts::kCycle_s < seconds; ++batch) {
    pattern.plan(batch, facts::kCycle_ns * std::int64_t{batch}, walk, Correction{}, *plan);
    for (std::size_t side = 0; side < legs.size(); ++side) {
      Angles before = angles_at(*plan, 0, side, legs[side]);
      for (std::size_t i = 1; i < kBatchPoints + plan->tail_count; ++i) {
        const Angles now = angles_at(*plan, i, side, legs[side]);
        for (std::size_t j = 0; j < kJoints.size(); ++j) {
          const double share = std::abs(now[j] - before[j]) / facts::kSlot_s / limits_rad_per_s[side][j];
          if (share > fastest.share) fastest = {kJoints[j], share};
        }
        before = now;
      }
    }
  }
  return fastest;
}

}  // namespace gaitway::trajectory
