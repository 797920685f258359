// Leg lengths, and the farthest corner of the footstep limits.
#include "gaitway/trajectory/robot_gait.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/joint_pace.hpp"
#include "gaitway/trajectory/joint_torque.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/leg_joints.hpp"

namespace gaitway::trajectory {
namespace {

constexpr double kShortStep = 0.05;  // of the hip height: a robot that cannot take it does not walk
constexpr int kStepParts = 4;  // lengths of steps that are looked at: the hips are lower in a longer one
// Of what a fast walk lowers the hips, this is still there at the end of a long step in which they rise for a
// stop.
constexpr double kLoweredInStop = 0.4;
// Of the leg's length, on a body like humanoid22: for balance feedback and the way of the CoM.
constexpr double kInHand_m = 0.002;

// Largest and smallest cosine over an interval of angles.
double largest_cosine(double from_rad, double to_rad) noexcept {
  constexpr double kTurn_rad = 2.0 * std::numbers::pi;
  const bool over_zero = std::floor(to_rad / kTurn_rad) >= std::ceil(from_rad / kTurn_rad);
  return over_zero ? 1.0 : std::max(std::cos(from_rad), std::cos(to_rad));
}
double smallest_cosine(double from_rad, double to_rad) noexcept {
  return -largest_cosine(from_rad + std::numbers::pi, to_rad + std::numbers::pi);
}

struct Axis {
  Eigen::Vector3d point_m, direction;
};

Axis axis_of(const urdf::RobotModel& robot, const urdf::ForwardKinematics& zero, int index) {
  const urdf::Joint& joint = robot.joints[static_cast<std::size_t>(index)];
  return {zero.link_position_m(joint.child_link), zero.joint_axis(robot, index)};
}

LegReach measure(const urdf::RobotModel& robot, const urdf::ForwardKinematics& zero,
                 const urdf::ForwardKinematics& home, urdf::Side side) {
  const urdf::LegJoints joints(robot, home, side);
  const int knee_index = joints[urdf::LegJoint::knee];
  const Axis hip = axis_of(robot, zero, joints[urdf::LegJoint::hip_pitch]),
             knee = axis_of(robot, zero, knee_index);
  const Eigen::Vector3d ankle_m = axis_of(robot, zero, joints[urdf::LegJoint::ankle_pitch]).point_m;
  const Eigen::Vector3d thigh = knee.point_m - hip.point_m, shin = ankle_m - knee.point_m;
  // The knee turns the shin about its axis; what lies along the axis stays.
  const double along_m = knee.direction.dot(thigh + shin);
  const Eigen::Vector3d a = thigh - knee.direction * knee.direction.dot(thigh);
  const Eigen::Vector3d b = shin - knee.direction * knee.direction.dot(shin);
  const double angle_rad = std::atan2(knee.direction.dot(a.cross(b)), a.dot(b));  // 0: stretched
  const urdf::Joint& knee_joint = robot.joints[static_cast<std::size_t>(knee_index)];
  const double from_rad = angle_rad + knee_joint.lower_rad, to_rad = angle_rad + knee_joint.upper_rad;
  const auto distance_m = [&](double cosine) {
    const double planar = a.squaredNorm() + b.squaredNorm() + 2.0 * a.norm() * b.norm() * cosine;
    return std::sqrt(std::max(0.0, planar) + along_m * along_m);
  };
  const Eigen::Vector3d ankle = zero.sole_pose(side).inverse() * ankle_m;
  const Eigen::Vector3d middle_m = 0.5 * (home.sole_pose(urdf::Side::left).translation() +
                                          home.sole_pose(urdf::Side::right).translation());
  return {.hip_forward_m = hip.point_m.x() - home.com_m().x(),
          .hip_left_m = hip.point_m.y() - middle_m.y(),
          .ankle_height_m = ankle.z(),
          .ankle_forward_m = ankle.x(),
          .ankle_left_m = ankle.y(),
          .longest_m = distance_m(largest_cosine(from_rad, to_rad)),
          .shortest_m = distance_m(smallest_cosine(from_rad, to_rad)),
          .thigh_m = a.norm(),
          .shin_m = b.norm(),
          .aside_m = along_m};
}

// Where the CoM is at the ends of double support: its distance from the farther foot as a share of the step.
// The steady walk of the cart-table: from -x to x over the stance foot, then with the speed x ω coth(ω T/2)
// to the next.
double farther_share(const GaitParameters& p) noexcept {
  const double omega = std::sqrt(facts::kGravity_m_per_s2 / p.com_height_m);
  const double swing_s = p.swing_points() * facts::kSlot_s;
  const double double_support_s = p.double_support_points() * facts::kSlot_s;
  return 1.0 - 1.0 / (2.0 + omega * double_support_s / std::tanh(0.5 * omega * swing_s));
}

[[noreturn]] void refuse(std::string_view name, double value_m, const std::string& rule,
                         std::string_view remedy) {
  throw std::invalid_argument(
      fmt::format("trajectory: parameter {} = {:.4g} m: footstep unreachable: {}. {} in the plug-in's "
                  "configuration.",
                  name, value_m, rule, remedy));
}

}  // namespace

bool stands_as_described(const GaitParameters& parameters, const GaitParameters& described) noexcept {
  constexpr double kSame_m = 1e-4;
  const auto same = [](double a, double b) { return std::abs(a - b) < kSame_m; };
  return same(parameters.stand_com_forward_m, described.stand_com_forward_m) &&
         same(parameters.hip_height_m, described.hip_height_m) &&
         same(parameters.foot_spacing_m, described.foot_spacing_m);
}

double usable_reach_m(const urdf::RobotModel& robot, const LegReach& leg) {
  return leg.longest_m - robot.body_scale().factor("m") * kInHand_m;
}

std::array<LegReach, 2> leg_reach(const urdf::RobotModel& robot) {
  urdf::ForwardKinematics zero(robot);
  zero.compute(std::vector<double>(robot.joints.size(), 0.0));
  const urdf::ForwardKinematics home(robot);
  return {measure(robot, zero, home, urdf::Side::left), measure(robot, zero, home, urdf::Side::right)};
}

double farthest_hip_to_ankle_m(const GaitParameters& p, const LegReach& leg, double step_forward_m,
                               double foot_spacing_m) {
  const double far = farther_share(p);
  const double side = leg.hip_left_m < 0.0 ? -1.0 : 1.0;
  double farthest_m = 0.0;
  for (int part = 0; part <= kStepParts; ++part) {
    const double step_m = step_forward_m * part / kStepParts;
    const double lowered_m = p.hip_height_m - p.hip_height_at_m(step_m / p.step_time_s);
    const double hip_height_m = p.hip_height_m - kLoweredInStop * lowered_m;
    for (const double share : {far, 1.0 - far}) {
      for (const double turn_rad : {-0.5 * p.max_step_turn_rad, 0.5 * p.max_step_turn_rad}) {
        for (const double ahead_m : {share * step_m, -share * step_m}) {
          // In the heading of the base: the CoM keeps over the reference ZMP, the foot is turned against it.
          const Eigen::Rotation2Dd foot(turn_rad);
          const Eigen::Vector2d sole = Eigen::Vector2d(ahead_m, side * share * foot_spacing_m) -
                                       foot * Eigen::Vector2d(p.zmp_forward_m, 0.0);
          const Eigen::Vector2d ankle = sole + foot * Eigen::Vector2d(leg.ankle_forward_m, leg.ankle_left_m);
          const Eigen::Vector2d hip(leg.hip_forward_m, leg.hip_left_m);
          farthest_m =
              std::max(farthest_m, std::hypot((ankle - hip).norm(), hip_height_m - leg.ankle_height_m));
        }
      }
    }
  }
  return farthest_m;
}

void require_reachable(const GaitParameters& p, const urdf::RobotModel& robot) {
  for (const LegReach& leg : leg_reach(robot)) {
    const double reach_m = usable_reach_m(robot, leg);
    const auto too_far = [&](double forward_m, double spacing_m) {
      return farthest_hip_to_ankle_m(p, leg, forward_m, spacing_m) > reach_m;
    };
    const auto rule = [&](double forward_m, double spacing_m) {
      return fmt::format(
          "with hip_height = {:.4g} m, max_foot_spacing = {:.4g} m and max_step_turn = {:.4g} rad, hip and "
          "ankle "
          "are {:.4g} m apart in double support, but the leg reaches {:.4g} m",
          p.hip_height_m, p.max_foot_spacing_m, p.max_step_turn_rad,
          farthest_hip_to_ankle_m(p, leg, forward_m, spacing_m), reach_m);
    };
    if (too_far(0.0, p.foot_spacing_m)) {
      refuse("hip_height", p.hip_height_m, rule(0.0, p.foot_spacing_m), "Lower hip_height");
    }
    if (too_far(0.0, p.max_foot_spacing_m)) {
      refuse("max_foot_spacing", p.max_foot_spacing_m, rule(0.0, p.max_foot_spacing_m),
             "Lower max_foot_spacing or hip_height");
    }
    if (too_far(p.max_step_forward_m, p.max_foot_spacing_m)) {
      refuse("max_step_forward", p.max_step_forward_m, rule(p.max_step_forward_m, p.max_foot_spacing_m),
             "Lower max_step_forward, max_foot_spacing or hip_height");
    }
    if (too_far(p.max_step_backward_m, p.max_foot_spacing_m)) {
      refuse("max_step_backward", p.max_step_backward_m, rule(p.max_step_backward_m, p.max_foot_spacing_m),
             "Lower max_step_backward, max_foot_spacing or hip_height");
    }
    const double folded_m = p.fast_hip_height_m - leg.ankle_height_m - p.lift_m;
    const double most_folded_m = leg.shortest_m + leg.longest_m - usable_reach_m(robot, leg);
    if (folded_m < most_folded_m) {
      refuse("lift", p.lift_m,
             fmt::format(
                 "with fast_hip_height = {:.4g} m, hip and ankle come as near as {:.4g} m, but the leg folds "
                 "to {:.4g} m",
                 p.fast_hip_height_m, folded_m, most_folded_m),
             "Lower lift or raise fast_hip_height");
    }
  }
}

void require_room_for_steps(const GaitParameters& p, const urdf::RobotModel& robot) {
  const double step_m = std::min(kShortStep * p.hip_height_m, p.max_step_forward_m);
  const StrideDemand demand = stride_demand(p, robot, step_m / p.step_time_s);
  if (demand.room.room_rad < 0.0) {
    const urdf::Joint& joint = joint_of(robot, demand.room.side, demand.room.joint);
    throw std::invalid_argument(fmt::format(
        "trajectory: parameter hip_height = {:.4g} m: a step of {:.3g} m turns the {} {:.3f} rad "
        "beyond its limits "
        "({:.4g}..{:.4g} rad for '{}'). Widen them in robot.urdf, or choose a stand that leaves it "
        "more room (home angles in robot.yaml)",
        p.hip_height_m, step_m, urdf::leg_joint_name(demand.room.joint), -demand.room.room_rad,
        joint.lower_rad, joint.upper_rad, joint.name));
  }
  if (demand.pace.share > 1.0) {
    const urdf::Joint& joint = joint_of(robot, demand.pace.side, demand.pace.joint);
    throw std::invalid_argument(fmt::format(
        "trajectory: parameter step_time = {:.4g} s: a step of {:.3g} m turns the {} at {:.3g} "
        "rad/s, but '{}' turns at {:.3g} at most. Raise step_time, lower lift, or put a quicker "
        "motor there",
        p.step_time_s, step_m, urdf::leg_joint_name(demand.pace.joint),
        demand.pace.share * joint.velocity_limit_rad_per_s, joint.name, joint.velocity_limit_rad_per_s));
  }
}

void require_walkable(const GaitParameters& parameters, const urdf::RobotModel& robot) {
  require_reachable(parameters, robot);
  require_room_for_steps(parameters, robot);
  require_strong_enough(parameters, robot);
}

}  // namespace gaitway::trajectory
