// One change after the other, what costs least first.
#include "step_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/joint_pace.hpp"
#include "gaitway/urdf/arm_swing.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::trajectory {
namespace {

// Walks whose planned joints turn at more than the first share of their limits at the usual speed are refused
// batches on the simulated robot, since balance, load and steps that a push moves ask for more; the second is
// the share of humanoid22's fastest.
constexpr double kUsualShare = 0.78, kFastestShare = 0.92;
constexpr double kUsualSpeed_m_per_s = 0.15;  // of a body as large as humanoid22
constexpr double kEverydaySpeed_m_per_s = 0.26, kFastSpeed_m_per_s = 0.455;  // Froude's number 0.02 and 0.06
constexpr double kLeastRoom_rad = 0.03;  // to the limits, for balance and load
constexpr double kMuchRoom_rad = 0.2;    // less than it may have: like twice the speed that it may have
// Of what a sole bears. Beyond it, robots turn on their feet; at 0.65 they fall.
constexpr double kMostTwist = 0.5;
constexpr double kSameHeight = 1e-3;  // of the hip height
// What the parameters may be.
constexpr double kQuickestStep_s = 0.2, kLongestStep_s = 1.0, kQuickestSwing_s = 0.1;
constexpr double kMostArmSwing_rad_per_m = 100.0;
// Of the scaled defaults.
constexpr double kFastLift = 0.85, kGoodLift = 0.6, kLeastLift = 0.3;
constexpr double kQuickestStep = 0.75, kSlowestStep = 1.6, kSlowestFastStep = 1.15;
constexpr double kFlattest = 0.75;
constexpr double kMostArm_rad = 0.6;   // ahead and back, in the longest step
constexpr double kMoreArm = 0.15;      // of that, from one try to the next
constexpr double kMostArmShare = 0.5;  // of the shoulders' speed: steps that a push moves ask for more

// What keeps that joint from turning faster.
std::string speed_reason(const urdf::RobotModel& robot, const JointPace& pace) {
  const urdf::Joint& joint = joint_of(robot, pace.side, pace.joint);
  const double byte_rad_per_s = facts::kLargestByte_counts * joint.count_rad / facts::kSlot_s;
  const bool by_byte = joint.velocity_limit_rad_per_s > 0.99 * byte_rad_per_s;
  return fmt::format("speed: the {} turns at {:.3g} rad/s at most{}", urdf::leg_joint_name(pace.joint),
                     std::min(joint.velocity_limit_rad_per_s, byte_rad_per_s),
                     by_byte ? ": more does not fit the byte on the wire" : "");
}

std::string room_reason(const urdf::RobotModel& robot, const JointRoom& room) {
  const urdf::Joint& joint = joint_of(robot, room.side, room.joint);
  return fmt::format("limit: the {} turns from {:.3g} to {:.3g} rad", urdf::leg_joint_name(room.joint),
                     joint.lower_rad, joint.upper_rad);
}

constexpr const char* kTwistReason = "ground: heavy legs in the air twist the foot on the ground";
constexpr const char* kArmReason = "speed: the shoulders turn no faster";

// What a push makes of a swing is as much quicker or slower as the step.
void scale_adjusted_swings(GaitParameters& p, const GaitParameters& wanted) {
  const double slower = p.step_time_s / wanted.step_time_s;
  p.adjust_shortest_swing_s =
      std::clamp(slower * p.adjust_shortest_swing_s, kQuickestSwing_s, kLongestStep_s);
  p.adjust_longest_swing_s = std::clamp(slower * p.adjust_longest_swing_s, kQuickestSwing_s, kLongestStep_s);
}

// A speed at which a walk is to ask no more than this.
struct StrideGoal {
  double forward_m_per_s, most_pace, most_twist;
};

// By how much a gait asks too much: the sum over the limits, each as a share of it. 0: it may be walked.
struct Excess {
  double sum = 0.0;
  std::string reason;  // of the largest
};

Excess excess_of(const GaitParameters& p, const urdf::RobotModel& robot, std::span<const StrideGoal> goals) {
  constexpr double kHopeless = 1e6;
  Excess excess;
  double largest = 0.0;
  const auto add = [&](double share, const auto& reason) {
    const double beyond = std::isfinite(share) ? std::max(0.0, share - 1.0) : kHopeless;
    excess.sum += beyond;
    if (beyond <= largest) return;
    largest = beyond;
    excess.reason = reason();
  };
  for (const StrideGoal& goal : goals) {
    const StrideDemand demand = stride_demand(p, robot, goal.forward_m_per_s);
    add(demand.pace.share / goal.most_pace, [&] { return speed_reason(robot, demand.pace); });
    add(1.0 + (kLeastRoom_rad - demand.room.room_rad) / kMuchRoom_rad,
        [&] { return room_reason(robot, demand.room); });
    add(demand.twist_share / goal.most_twist, [&] { return std::string(kTwistReason); });
    add(demand.arm_pace_share / kMostArmShare, [] { return std::string(kArmReason); });
  }
  return excess;
}

// How far a gait may leave the scaled default.
struct StepBounds {
  double good_lift_m, least_lift_m, quickest_s, slowest_s;
  double fastest_m_per_s;
  double most_arm_rad;  // 0: there are no arms to swing
};

bool swing_arms(GaitParameters& p, const StepBounds& bounds) {
  const double longest_m = std::min(p.max_step_forward_m, bounds.fastest_m_per_s * p.step_time_s);
  const double most_rad_per_m = std::min(bounds.most_arm_rad / longest_m, kMostArmSwing_rad_per_m);
  p.arm_swing_rad_per_m += kMoreArm * most_rad_per_m;
  return p.arm_swing_rad_per_m < most_rad_per_m;
}

bool flatten(GaitParameters& p) {
  if (p.swing_flatness >= kFlattest) return false;
  p.swing_flatness = std::min(p.swing_flatness + 0.25, kFlattest);
  return true;
}
bool raise_fast_hips(GaitParameters& p) {
  const double lowered_m = p.hip_height_m - p.fast_hip_height_m;
  if (lowered_m <= kSameHeight * p.hip_height_m) return false;
  p.fast_hip_height_m += std::max(0.25 * lowered_m, 0.5 * kSameHeight * p.hip_height_m);
  return true;
}
bool lower_lift(GaitParameters& p, double least_m) {
  constexpr double kLower = 0.92;
  if (kLower * p.lift_m < least_m) return false;
  p.lift_m *= kLower;
  return true;
}
bool change_step_time(GaitParameters& p, double by_s, const StepBounds& bounds) {
  p.step_time_s += by_s;
  shorten_tail(p);
  return p.step_time_s > bounds.quickest_s && p.step_time_s < bounds.slowest_s;
}

// Changes of the step, until it asks no more than it may, or nothing helps: what costs least first.
void ease_step(GaitParameters& p, const urdf::RobotModel& robot, std::span<const StrideGoal> goals,
               const StepBounds& bounds, const NoteReason& note) {
  constexpr double kWorth = 0.003;
  using Change = std::function<bool(GaitParameters&)>;
  const std::array<Change, 6> changes{
      flatten,
      raise_fast_hips,
      [&](GaitParameters& q) { return lower_lift(q, bounds.good_lift_m); },
      [&](GaitParameters& q) { return change_step_time(q, -facts::kSlot_s, bounds); },
      [&](GaitParameters& q) { return change_step_time(q, facts::kSlot_s, bounds); },
      [&](GaitParameters& q) { return lower_lift(q, bounds.least_lift_m); },
  };
  Excess excess = excess_of(p, robot, goals);
  const auto helps = [&](const Change& change) {
    GaitParameters next = p;
    if (!change(next)) return false;
    Excess then = excess_of(next, robot, goals);
    if (then.sum > 0.0 && !(then.sum < excess.sum - kWorth)) return false;
    p = next;
    excess = std::move(then);
    return true;
  };
  while (excess.sum > 0.0) {
    const std::string reason = excess.reason;
    if (helps([&](GaitParameters& q) { return swing_arms(q, bounds); })) {
      note(kTwistReason);  // they make nothing else less
    } else if (std::ranges::any_of(changes, helps)) {
      note(reason);
    } else {
      return;
    }
  }
}

std::string too_much(const urdf::RobotModel& robot, const StrideDemand& demand) {
  if (demand.pace.share > kFastestShare) return speed_reason(robot, demand.pace);
  return demand.room.room_rad < kLeastRoom_rad ? room_reason(robot, demand.room) : "";
}

// The fastest walk that does not ask too much, up to this one.
double fastest_m_per_s(const GaitParameters& p, const urdf::RobotModel& robot, double most_m_per_s) {
  constexpr int kHalvings = 6;
  if (too_much_ahead(p, robot, most_m_per_s).empty()) return most_m_per_s;
  double possible = 0.0, too_fast = most_m_per_s;
  for (int i = 0; i < kHalvings; ++i) {
    const double speed = 0.5 * (possible + too_fast);
    (too_much_ahead(p, robot, speed).empty() ? possible : too_fast) = speed;
  }
  return possible;
}

// Where the joints' limits leave no room for steps as long as a fast walk wants them, more of them make up
// for it, and arms that go as far with shorter steps. Of walks that are as fast, quicker steps leave the body
// less time to fall.
void fit_cadence(GaitParameters& p, const urdf::RobotModel& robot, const StepBounds& bounds,
                 const NoteReason& note) {
  constexpr double kAsFast = 0.995;
  constexpr int kMostInVain = 2;
  const std::string reason = too_much_ahead(p, robot, bounds.fastest_m_per_s);
  if (reason.empty()) return;
  double fastest = fastest_m_per_s(p, robot, bounds.fastest_m_per_s);
  if (!(fastest > 0.0)) return;
  const auto take = [&](const GaitParameters& tried) {
    if (!too_much_ahead(tried, robot, kAsFast * fastest).empty()) return false;
    p = tried;
    fastest = std::max(fastest, fastest_m_per_s(tried, robot, bounds.fastest_m_per_s));
    return true;
  };
  const auto take_with_arms = [&](GaitParameters tried) {
    const double swing_rad_per_m =
        std::min(bounds.most_arm_rad / (fastest * tried.step_time_s), kMostArmSwing_rad_per_m);
    if (tried.arm_swing_rad_per_m >= swing_rad_per_m) return false;
    tried.arm_swing_rad_per_m = swing_rad_per_m;
    return take(tried);
  };
  if (take_with_arms(p)) note(kTwistReason);
  int in_vain = 0;
  for (GaitParameters quicker = p;
       in_vain < kMostInVain && change_step_time(quicker, -facts::kSlot_s, bounds);) {
    ++in_vain;
    if (take(quicker)) {
      in_vain = 0;
      note(reason);
    }
    if (take_with_arms(quicker)) {
      in_vain = 0;
      note(kTwistReason);
    }
    quicker.arm_swing_rad_per_m = p.arm_swing_rad_per_m;
  }
}

}  // namespace

void shorten_tail(GaitParameters& p) {
  while (p.longest_tail_points() > GaitParameters::kMostTailPoints) p.settle_s -= facts::kSlot_s;
}

std::string too_much_at(const GaitParameters& p, const urdf::RobotModel& robot, const Velocity2& velocity) {
  return too_much(robot, stride_demand(p, robot, velocity));
}

std::string too_much_ahead(const GaitParameters& p, const urdf::RobotModel& robot, double forward_m_per_s) {
  const StrideDemand demand = stride_demand(p, robot, forward_m_per_s);
  std::string why = too_much(robot, demand);
  if (why.empty() && demand.twist_share > kMostTwist) why = kTwistReason;
  return why;
}

void fit_step(GaitParameters& p, const urdf::RobotModel& robot, const NoteReason& note) {
  const GaitParameters wanted = p;
  const double larger = robot.body_scale().factor("m/s");
  const double longest_m_per_s = p.max_step_forward_m / p.step_time_s;
  const std::array<StrideGoal, 3> goals{
      {{kUsualSpeed_m_per_s * larger, kUsualShare, kMostTwist},
       {std::min(kEverydaySpeed_m_per_s * larger, longest_m_per_s), kFastestShare, kMostTwist},
       {std::min(kFastSpeed_m_per_s * larger, longest_m_per_s), kFastestShare, kMostTwist}}};
  const auto arms = urdf::arm_swing(robot, urdf::ForwardKinematics(robot));
  StepBounds bounds{.good_lift_m = kGoodLift * wanted.lift_m,
                    .least_lift_m = kLeastLift * wanted.lift_m,
                    .quickest_s = std::max(kQuickestStep * wanted.step_time_s, kQuickestStep_s),
                    .slowest_s = std::min(kSlowestStep * wanted.step_time_s, kLongestStep_s),
                    .fastest_m_per_s = goals.back().forward_m_per_s,
                    .most_arm_rad = arms ? std::min(kMostArm_rad, arms->free_rad()) : 0.0};
  ease_step(p, robot, std::span(goals).first(2), bounds, note);
  bounds.good_lift_m = bounds.least_lift_m = kFastLift * wanted.lift_m;
  bounds.slowest_s = kSlowestFastStep * wanted.step_time_s;
  ease_step(p, robot, goals, bounds, note);
  fit_cadence(p, robot, bounds, note);
  if (p.step_time_s != wanted.step_time_s) {
    scale_adjusted_swings(p, wanted);
    note("step: as much quicker or slower as its time");
  }
}

}  // namespace gaitway::trajectory
