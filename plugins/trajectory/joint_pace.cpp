// A walk is planned, and each leg solved as a triangle at each point.
#include "gaitway/trajectory/joint_pace.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"
#include "gaitway/urdf/arm_swing.hpp"

namespace gaitway::trajectory {
namespace {

using urdf::LegJoint;
enum Axis : std::uint8_t { kRoll, kPitch, kYaw };
struct TriangleJoint {
  LegJoint joint;
  Axis about;  // of the base
};
constexpr std::array<TriangleJoint, 6> kJoints{{{LegJoint::hip_pitch, kPitch},
                                                {LegJoint::knee, kPitch},
                                                {LegJoint::ankle_pitch, kPitch},
                                                {LegJoint::hip_yaw, kYaw},
                                                {LegJoint::hip_roll, kRoll},
                                                {LegJoint::ankle_roll, kRoll}}};
using Angles = std::array<double, kJoints.size()>;
constexpr double kSteps = 8.0;  // until the walk is steady

// Of a leg over the point `i` of a plan.
Angles angles_at(const MotionPlan& plan, std::size_t i, std::size_t side, const LegReach& leg) noexcept {
  const Eigen::Rotation2Dd base(plan.base_yaw[i]), foot(plan.foot_yaw[i][side]);
  const Eigen::Vector2d hip = Eigen::Vector2d(plan.com[i][0], plan.com[i][1]) +
                              base * Eigen::Vector2d(leg.hip_forward_m, leg.hip_left_m);
  const double height_m = plan.foot_position[i][side][2];
  const double toe_up_rad = plan.toe_up * height_m;
  const Eigen::Vector2d sagittal =  // of the ankle from the sole: ahead, up
      Eigen::Rotation2Dd(toe_up_rad) * Eigen::Vector2d(leg.ankle_forward_m, leg.ankle_height_m);
  const Eigen::Vector2d ankle =
      Eigen::Vector2d(plan.foot_position[i][side][0], plan.foot_position[i][side][1]) +
      foot * Eigen::Vector2d(sagittal.x(), leg.ankle_left_m);
  const Eigen::Vector2d out = base.inverse() * (ankle - hip);
  const double down = plan.hip_height[i] - sagittal.y() - height_m;
  const double depth = std::hypot(down, out.y());
  const double cosine = (out.x() * out.x() + depth * depth - leg.aside_m * leg.aside_m -
                         leg.thigh_m * leg.thigh_m - leg.shin_m * leg.shin_m) /
                        (2.0 * leg.thigh_m * leg.shin_m);
  const double knee = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double hip_pitch = -std::atan2(out.x(), depth) -
                           std::atan2(leg.shin_m * std::sin(knee), leg.thigh_m + leg.shin_m * std::cos(knee));
  const double hip_roll = std::atan2(out.y(), down);
  return {hip_pitch, knee,     -hip_pitch - knee - toe_up_rad, plan.foot_yaw[i][side] - plan.base_yaw[i],
          hip_roll,  -hip_roll};
}

// What the limits of a leg's joints leave, in the angles of the triangle.
struct LegLimits {
  Angles speed_rad_per_s{}, lowest_rad{}, highest_rad{};
};

// The standing triangle stands for the home posture; each joint turns the leg one way or the other.
LegLimits limits_of(const urdf::RobotModel& robot, const urdf::ForwardKinematics& home, urdf::Side side,
                    const Angles& standing_rad) {
  const urdf::LegJoints joints(robot, home, side);
  LegLimits limits;
  for (std::size_t j = 0; j < kJoints.size(); ++j) {
    const urdf::Joint& joint = robot.joints[static_cast<std::size_t>(joints[kJoints[j].joint])];
    limits.speed_rad_per_s[j] = joint.velocity_limit_rad_per_s;
    const double to_lower = joint.lower_rad - joint.home_rad, to_upper = joint.upper_rad - joint.home_rad;
    const bool same_way = home.joint_axis(robot, joints[kJoints[j].joint])[kJoints[j].about] > 0.0;
    limits.lowest_rad[j] = standing_rad[j] + (same_way ? to_lower : -to_upper);
    limits.highest_rad[j] = standing_rad[j] + (same_way ? to_upper : -to_lower);
  }
  return limits;
}

// Thigh, shin and foot: their masses, and where their centres lie along the segment from the joint above.
struct LegMasses {
  std::array<double, 3> mass_kg{};
  std::array<double, 2> along{};  // of thigh and shin
  double hip_left_m = 0.0, ankle_left_m = 0.0;
};

LegMasses masses_of(const urdf::RobotModel& robot, const urdf::ForwardKinematics& home, urdf::Side side) {
  const urdf::LegJoints joints(robot, home, side);
  const auto place = [&](LegJoint which) {
    return home.link_position_m(robot.joints[static_cast<std::size_t>(joints[which])].child_link);
  };
  const Eigen::Vector3d hip = place(LegJoint::hip_pitch), knee = place(LegJoint::knee),
                        ankle = place(LegJoint::ankle_pitch);
  std::array<Eigen::Vector3d, 3> moment_kg_m{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                             Eigen::Vector3d::Zero()};
  LegMasses masses{.hip_left_m = hip.y(), .ankle_left_m = ankle.y()};
  const urdf::Leg& leg = robot.legs[urdf::index_of(side)];
  for (std::size_t i = 0; i < leg.joints.size(); ++i) {
    const int child = robot.joints[static_cast<std::size_t>(leg.joints[i])].child_link;
    const urdf::Link& link = robot.links[static_cast<std::size_t>(child)];
    const std::size_t segment = i < 3 ? 0 : i == 3 ? 1 : 2;
    masses.mass_kg[segment] += link.mass_kg;
    moment_kg_m[segment] += link.mass_kg * (home.link_pose(child) * link.com_m);
  }
  const auto along = [&](std::size_t segment, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d com = moment_kg_m[segment] / masses.mass_kg[segment];
    return (com - from).dot(to - from) / (to - from).squaredNorm();
  };
  masses.along = {along(0, hip, knee), along(1, knee, ankle)};
  return masses;
}

// Moment of a leg's masses about the vertical through the CoM, as far as they move ahead: sum of mass x way
// ahead of the CoM x distance to its left.
double way_moment_kg_m2(const LegMasses& masses, const LegReach& leg, const Angles& angle_rad,
                        double ankle_ahead_m) {
  const double thigh_m = -leg.thigh_m * std::sin(angle_rad[0]);
  const double shin_m = -leg.shin_m * std::sin(angle_rad[0] + angle_rad[1]);
  const double hip_m = ankle_ahead_m - thigh_m - shin_m;
  return masses.hip_left_m * masses.mass_kg[0] * (hip_m + masses.along[0] * thigh_m) +
         0.5 * (masses.hip_left_m + masses.ankle_left_m) * masses.mass_kg[1] *
             (hip_m + thigh_m + masses.along[1] * shin_m) +
         masses.ankle_left_m * masses.mass_kg[2] * ankle_ahead_m;
}

// Of the points of a rectangle, from its middle.
double mean_distance_m(const Sole& sole) {
  const double a = 0.5 * sole.length_m, b = 0.5 * sole.width_m, d = std::hypot(a, b);
  return d / 3.0 + a * a / (6.0 * b) * std::log((b + d) / a) + b * b / (6.0 * a) * std::log((a + d) / b);
}

struct WalkingLeg {
  LegReach reach;
  LegLimits limits;
  LegMasses masses;
};

// Looks at one plan after the other.
class StrideWatch {
 public:
  StrideWatch(const GaitParameters& parameters, const urdf::RobotModel& robot) {
    const std::array<LegReach, 2> reach = leg_reach(robot);
    const urdf::ForwardKinematics home(robot);
    MotionPlan stand{};
    stand.hip_height[0] = robot.hip_height_m;
    for (std::size_t side = 0; side < 2; ++side) {
      stand.foot_position[0][side][0] = -parameters.stand_com_forward_m;
      stand.foot_position[0][side][1] = (side == 0 ? 0.5 : -0.5) * parameters.foot_spacing_m;
    }
    for (const urdf::Side side : urdf::kSides) {
      const std::size_t i = urdf::index_of(side);
      legs_[i] = {reach[i], limits_of(robot, home, side, angles_at(stand, 0, i, reach[i])),
                  masses_of(robot, home, side)};
    }
    demand_.room.room_rad = std::numbers::pi;
    arms_ = urdf::arm_swing(robot, home);
    borne_Nm_ = robot.contact.friction * robot.total_mass_kg() * facts::kGravity_m_per_s2 *
                mean_distance_m(parameters.sole);
  }

  void look(const MotionPlan& plan, bool steady) {
    std::array<Angles, 2> before{};
    std::array<double, 2> moments{};  // of the two points before
    double back_before_rad = 0.0;     // the left arm
    for (std::size_t i = 0; i < kBatchPoints + plan.tail_count; ++i) {
      double moment = 0.0;
      for (std::size_t side = 0; side < 2; ++side) {
        const Angles now = angles_at(plan, i, side, legs_[side].reach);
        if (i > 0) look_at_joints(side, before[side], now);
        before[side] = now;
        moment += way_moment_kg_m2(legs_[side].masses, legs_[side].reach, now,
                                   plan.foot_position[i][side][0] - plan.com[i][0]);
      }
      if (arms_) {
        const double back_rad = arm_back_rad(plan, i);
        moment -= arms_->moment_kg_m2 * back_rad;
        if (i > 0) look_at_arms(back_rad - back_before_rad);
        back_before_rad = back_rad;
      }
      if (steady && i >= 2 && i < kBatchPoints) {
        const double twist_Nm =
            std::abs(moment - 2.0 * moments[1] + moments[0]) / (facts::kSlot_s * facts::kSlot_s);
        demand_.twist_share = std::max(demand_.twist_share, twist_Nm / borne_Nm_);
      }
      moments = {moments[1], moment};
    }
  }
  [[nodiscard]] const StrideDemand& demand() const noexcept { return demand_; }

 private:
  [[nodiscard]] double arm_back_rad(const MotionPlan& plan, std::size_t i) const noexcept {
    const double left_ahead_m = plan.foot_position[i][0][0] - plan.foot_position[i][1][0];
    return arms_->limited_rad(plan.arm_swing * left_ahead_m);
  }
  void look_at_arms(double turned_rad) {
    demand_.arm_pace_share =
        std::max(demand_.arm_pace_share, std::abs(turned_rad) / facts::kSlot_s / arms_->most_rad_per_s);
  }
  void look_at_joints(std::size_t index, const Angles& before, const Angles& now) {
    const LegLimits& limits = legs_[index].limits;
    const urdf::Side side = urdf::kSides[index];
    for (std::size_t j = 0; j < kJoints.size(); ++j) {
      const double share = std::abs(now[j] - before[j]) / facts::kSlot_s / limits.speed_rad_per_s[j];
      if (share > demand_.pace.share) demand_.pace = {side, kJoints[j].joint, share};
      const double room = std::min(now[j] - limits.lowest_rad[j], limits.highest_rad[j] - now[j]);
      if (room < demand_.room.room_rad) demand_.room = {side, kJoints[j].joint, room};
    }
  }

  std::array<WalkingLeg, 2> legs_;
  std::optional<urdf::ArmSwing> arms_;
  double borne_Nm_ = 0.0;
  StrideDemand demand_;
};

}  // namespace

const urdf::Joint& joint_of(const urdf::RobotModel& robot, urdf::Side side, urdf::LegJoint which) {
  const urdf::LegJoints joints(robot, urdf::ForwardKinematics(robot), side);
  return robot.joints[static_cast<std::size_t>(joints[which])];
}

StrideDemand stride_demand(const GaitParameters& parameters, const urdf::RobotModel& robot,
                           const Velocity2& velocity) {
  StrideWatch watch(parameters, robot);
  WalkCommand walk{};
  walk.walk = 1;
  walk.velocity[0] = velocity.forward_m_per_s;
  walk.velocity[1] = velocity.left_m_per_s;
  walk.turn_rate = velocity.turn_rad_per_s;
  const double to_speed_s =
      parameters.lead_in_s +
      std::max({std::abs(velocity.forward_m_per_s) / parameters.forward_acceleration_m_per_s2,
                std::abs(velocity.left_m_per_s) / parameters.lateral_acceleration_m_per_s2,
                std::abs(velocity.turn_rad_per_s) / parameters.turn_acceleration_rad_per_s2});
  const double seconds = to_speed_s + kSteps * parameters.step_time_s;
  WalkingPattern pattern(parameters);
  const auto plan = std::make_unique<MotionPlan>();
  for (std::uint32_t batch = 1; batch * facts::kCycle_s < seconds; ++batch) {
    pattern.plan(batch, facts::kCycle_ns * std::int64_t{batch}, walk, Correction{}, *plan);
    watch.look(*plan, batch * facts::kCycle_s > to_speed_s + 0.5 * kSteps * parameters.step_time_s);
  }
  return watch.demand();
}

}  // namespace gaitway::trajectory
