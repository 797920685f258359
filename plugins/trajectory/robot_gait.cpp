// The standing posture by forward kinematics; leg lengths, and the farthest corner of the footstep limits.
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
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/leg_joints.hpp"

namespace gaitway::trajectory {
namespace {

// Each link of the leg moves with the foot by its share of the way from hip to sole; what does not belong to
// the leg moves the other way, so that the CoM does not follow.
double swing_moment_s2(const urdf::RobotModel& robot, const urdf::ForwardKinematics& home,
                       double sole_height_m) {
  const double com_height_m = home.com_m().z();
  const double hip_height_m = sole_height_m + robot.hip_height_m;
  double moved_kg = 0.0, leg_kg = 0.0, leg_height_kg_m = 0.0, moment_kg_m = 0.0;
  for (const int index : robot.legs[0].joints) {
    const int child = robot.joints[static_cast<std::size_t>(index)].child_link;
    const urdf::Link& link = robot.links[static_cast<std::size_t>(child)];
    const double height_m = (home.link_pose(child) * link.com_m).z();
    const double share = std::clamp((hip_height_m - height_m) / robot.hip_height_m, 0.0, 1.0);
    moved_kg += link.mass_kg * share;
    leg_kg += link.mass_kg;
    leg_height_kg_m += link.mass_kg * height_m;
    moment_kg_m += link.mass_kg * share * (com_height_m - height_m);
  }
  const double mass_kg = robot.total_mass_kg();
  const double rest_height_m = (mass_kg * com_height_m - leg_height_kg_m) / (mass_kg - leg_kg);
  moment_kg_m += moved_kg * (rest_height_m - com_height_m);
  return moment_kg_m / (mass_kg * facts::kGravity_m_per_s2);
}

constexpr int kStepParts = 4;  // lengths of steps that are looked at: the hips are lower in a longer one
// Of what a fast walk lowers the hips, this is still there at the end of a long step in which they rise for a
// stop.
constexpr double kLoweredInStop = 0.4;
constexpr double kSameSpacing_m = 1e-6;
constexpr double kMostInward = 0.25;  // of the sole's width
constexpr double kLeastStep = 0.05;   // of the hip height: a step that is not worth less
// Walks whose planned joints turn at more than the first share of their limits at the usual speed are refused
// batches on the simulated robot, since balance, load and steps that a push moves ask for more; the second is
// the share of humanoid22's fastest.
constexpr double kUsualShare = 0.78, kFastestShare = 0.92;
constexpr double kUsualSpeed_m_per_s = 0.15;                             // of a body as large as humanoid22
constexpr double kLongestStep_s = 1.0;                                   // that the parameter may be
constexpr double kGoodLift = 0.6, kLeastLift = 0.3, kSlowestStep = 1.6;  // of the scaled defaults
constexpr double kInHand_m = 0.002;  // of the leg's length, for balance feedback and the way of the CoM

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

// A stance that is wider or narrower than that of the scaled defaults.
void fit_stance(GaitParameters& p, double wider_m) {
  if (std::abs(wider_m) > kSameSpacing_m) {
    p.max_foot_spacing_m += wider_m;
    p.adjust_spacing_m += wider_m;
  }
  p.zmp_inward_m = std::min(p.zmp_inward_m, kMostInward * p.sole.width_m);
  p.min_sole_gap_m = std::clamp(p.foot_spacing_m - p.sole.width_m, 0.0, p.min_sole_gap_m);
}

// As long as a plan carries.
void fit_tail(GaitParameters& p) {
  while (p.longest_tail_points() > GaitParameters::kMostTailPoints) p.settle_s -= facts::kSlot_s;
}

// Shorter and narrower steps, both by the same share, as far as the legs reach.
void fit_reach(GaitParameters& p, const urdf::RobotModel& robot) {
  constexpr double kLess = 0.98;
  const std::array<LegReach, 2> legs = leg_reach(robot);
  const auto too_far = [&](double forward_m) {
    return std::any_of(legs.begin(), legs.end(), [&](const LegReach& leg) {
      return farthest_hip_to_ankle_m(p, leg, forward_m, p.max_foot_spacing_m) > leg.longest_m - kInHand_m;
    });
  };
  while (p.max_step_forward_m > kLeastStep * p.hip_height_m &&
         (too_far(0.0) || too_far(p.max_step_forward_m) || too_far(p.max_step_backward_m))) {
    p.max_step_forward_m *= kLess;
    p.max_step_backward_m *= kLess;
    p.max_foot_spacing_m = std::lerp(p.foot_spacing_m, p.max_foot_spacing_m, kLess);
  }
  p.adjust_spacing_m = std::min(p.adjust_spacing_m, p.max_foot_spacing_m);
}

// Slower motors get a lower lift and slower steps, until a walk at the default speed leaves them enough for
// the balance; then shorter steps, until the fastest walk is one that they can follow.
void fit_motors(GaitParameters& p, const urdf::RobotModel& robot) {
  constexpr double kLower = 0.95, kShorter = 0.98;
  try {
    p.validate();
  } catch (const std::invalid_argument&) {
    return;  // the configuration may mend it; else it is told then
  }
  const GaitParameters wanted = p;
  const double slowest_s = std::min(kSlowestStep * wanted.step_time_s, kLongestStep_s) - facts::kSlot_s;
  const double usual_m_per_s = kUsualSpeed_m_per_s * robot.body_scale().factor("m/s");
  while (fastest_joint(p, robot, usual_m_per_s).share > kUsualShare) {
    if (p.lift_m > kGoodLift * wanted.lift_m) {
      p.lift_m *= kLower;
    } else if (p.step_time_s < slowest_s) {
      p.step_time_s += facts::kSlot_s;
    } else if (p.lift_m > kLeastLift * wanted.lift_m) {
      p.lift_m *= kLower;
    } else {
      break;
    }
  }
  const double slower = p.step_time_s / wanted.step_time_s;
  p.adjust_shortest_swing_s *= slower;
  p.adjust_longest_swing_s *= slower;
  while (p.max_step_forward_m > kLeastStep * p.hip_height_m &&
         fastest_joint(p, robot, p.max_step_forward_m / p.step_time_s).share > kFastestShare) {
    p.max_step_forward_m *= kShorter;
    p.max_step_backward_m *= kShorter;
  }
}

[[noreturn]] void refuse(std::string_view name, double value_m, const std::string& rule,
                         std::string_view remedy) {
  throw std::invalid_argument(
      fmt::format("trajectory: parameter {} = {:.4g} m: footstep unreachable: {}. {} in the plug-in's "
                  "configuration.",
                  name, value_m, rule, remedy));
}

}  // namespace

GaitParameters gait_of(const urdf::RobotModel& robot) {
  GaitParameters parameters;
  scale_to_body(parameters.numbers(), robot.body_scale());
  const urdf::ForwardKinematics home(robot);
  const Eigen::Vector3d& com = home.com_m();
  const Eigen::Vector3d left = home.sole_pose(urdf::Side::left).translation();
  const Eigen::Vector3d right = home.sole_pose(urdf::Side::right).translation();
  const double wider_m = left.y() - right.y() - parameters.foot_spacing_m;
  parameters.com_height_m = com.z() - 0.5 * (left.z() + right.z());
  parameters.stand_com_forward_m = com.x() - 0.5 * (left.x() + right.x());
  parameters.foot_spacing_m = left.y() - right.y();
  parameters.hip_height_m = robot.hip_height_m;
  parameters.fast_hip_height_m = std::min(parameters.fast_hip_height_m, robot.hip_height_m);
  parameters.swing_moment_s2 = swing_moment_s2(robot, home, 0.5 * (left.z() + right.z()));
  const urdf::Foot& foot = robot.feet[0];
  parameters.sole = {foot.size_m.x(), foot.size_m.y(), foot.centre_m.x()};
  parameters.zmp_forward_m = foot.centre_m.x();
  fit_stance(parameters, wider_m);
  fit_tail(parameters);
  fit_reach(parameters, robot);
  fit_motors(parameters, robot);
  fit_tail(parameters);
  return parameters;
}

bool stands_as_described(const GaitParameters& parameters, const GaitParameters& described) noexcept {
  constexpr double kSame_m = 1e-4;
  const auto same = [](double a, double b) { return std::abs(a - b) < kSame_m; };
  return same(parameters.stand_com_forward_m, described.stand_com_forward_m) &&
         same(parameters.hip_height_m, described.hip_height_m) &&
         same(parameters.foot_spacing_m, described.foot_spacing_m);
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
    const double reach_m = leg.longest_m - kInHand_m;
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
    if (folded_m < leg.shortest_m + kInHand_m) {
      refuse("lift", p.lift_m,
             fmt::format(
                 "with fast_hip_height = {:.4g} m, hip and ankle come as near as {:.4g} m, but the leg folds "
                 "to {:.4g} m",
                 p.fast_hip_height_m, folded_m, leg.shortest_m + kInHand_m),
             "Lower lift or raise fast_hip_height");
    }
  }
}

}  // namespace gaitway::trajectory
