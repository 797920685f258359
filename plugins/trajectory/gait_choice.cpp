// The standing posture by forward kinematics; then one fit after the other, each of which says what it took
// into account.
#include "gaitway/trajectory/gait_choice.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/joint_pace.hpp"
#include "gaitway/trajectory/joint_torque.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::trajectory {
namespace {

constexpr double kSameSpacing_m = 1e-6;
constexpr double kMostInward = 0.25;  // of the sole's width
constexpr double kLeastStep = 0.05;   // of the hip height: a step that is not worth less
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
// Of the scaled defaults.
constexpr double kFastLift = 0.85, kGoodLift = 0.6, kLeastLift = 0.3;
constexpr double kQuickestStep = 0.75, kSlowestStep = 1.6, kSlowestFastStep = 1.15;
constexpr double kFlattest = 0.75;

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

// What becomes of each number, and why.
class ChoiceLog {
 public:
  explicit ChoiceLog(ChosenGait& gait) : gait_(gait), scaled_(values()), before_(scaled_) {}

  // Everything that has changed since the last call did so for this reason.
  void note(const std::string& reason) {
    const auto numbers = gait_.parameters.numbers();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (numbers[i].value == before_[i]) continue;
      GaitChoice& choice = entry(numbers[i], scaled_[i]);
      choice.chosen = numbers[i].value;
      if (std::ranges::find(choice.reasons, reason) == choice.reasons.end()) choice.reasons.push_back(reason);
    }
    before_ = values();
  }

 private:
  using Values = std::array<double, GaitParameters::kNumbers>;

  [[nodiscard]] Values values() {
    Values result{};
    const auto numbers = gait_.parameters.numbers();
    std::ranges::transform(numbers, result.begin(),
                           [](const NumberParameter& number) { return number.value; });
    return result;
  }
  GaitChoice& entry(const NumberParameter& number, double scaled) {
    const auto found = std::ranges::find(gait_.choices, number.name, &GaitChoice::parameter);
    if (found != gait_.choices.end()) return *found;
    return gait_.choices.emplace_back(GaitChoice{
        .parameter = number.name, .unit = number.unit, .scaled = scaled, .chosen = scaled, .reasons = {}});
  }

  ChosenGait& gait_;
  Values scaled_, before_;
};

// Returns by how much wider the stance is than the scaled default's.
double take_from_description(GaitParameters& p, const urdf::RobotModel& robot) {
  const urdf::ForwardKinematics home(robot);
  const Eigen::Vector3d& com = home.com_m();
  const Eigen::Vector3d left = home.sole_pose(urdf::Side::left).translation();
  const Eigen::Vector3d right = home.sole_pose(urdf::Side::right).translation();
  const double wider_m = left.y() - right.y() - p.foot_spacing_m;
  p.com_height_m = com.z() - 0.5 * (left.z() + right.z());
  p.stand_com_forward_m = com.x() - 0.5 * (left.x() + right.x());
  p.foot_spacing_m = left.y() - right.y();
  p.hip_height_m = robot.hip_height_m;
  p.fast_hip_height_m = std::min(p.fast_hip_height_m, robot.hip_height_m);
  p.swing_moment_s2 = swing_moment_s2(robot, home, 0.5 * (left.z() + right.z()));
  const urdf::Foot& foot = robot.feet[0];
  p.sole = {foot.size_m.x(), foot.size_m.y(), foot.centre_m.x()};
  p.zmp_forward_m = foot.centre_m.x();
  return wider_m;
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

// A tail as long as a plan carries.
void shorten_tail(GaitParameters& p) {
  while (p.longest_tail_points() > GaitParameters::kMostTailPoints) p.settle_s -= facts::kSlot_s;
}

void fit_tail(GaitParameters& p, ChoiceLog& log) {
  shorten_tail(p);
  log.note(
      fmt::format("a plan holds a safe tail of {:.3g} s", GaitParameters::kMostTailPoints * facts::kSlot_s));
}

// Shorter and narrower steps, both by the same share, as far as the legs reach.
void fit_reach(GaitParameters& p, const urdf::RobotModel& robot, ChoiceLog& log) {
  constexpr double kLess = 0.98;
  const std::array<LegReach, 2> legs = leg_reach(robot);
  const auto too_far = [&](double forward_m) {
    return std::any_of(legs.begin(), legs.end(), [&](const LegReach& leg) {
      return farthest_hip_to_ankle_m(p, leg, forward_m, p.max_foot_spacing_m) > usable_reach_m(robot, leg);
    });
  };
  while (p.max_step_forward_m > kLeastStep * p.hip_height_m &&
         (too_far(0.0) || too_far(p.max_step_forward_m) || too_far(p.max_step_backward_m))) {
    p.max_step_forward_m *= kLess;
    p.max_step_backward_m *= kLess;
    p.max_foot_spacing_m = std::lerp(p.foot_spacing_m, p.max_foot_spacing_m, kLess);
  }
  p.adjust_spacing_m = std::min(p.adjust_spacing_m, p.max_foot_spacing_m);
  const double reach_m = std::min(usable_reach_m(robot, legs[0]), usable_reach_m(robot, legs[1]));
  log.note(fmt::format("reach: a leg reaches {:.3g} m from hip to ankle, with the hips at {:.3g} m", reach_m,
                       p.hip_height_m));
}

// What keeps that joint from turning faster.
std::string speed_reason(const urdf::RobotModel& robot, const JointPace& pace) {
  const urdf::LegJoints joints(robot, urdf::ForwardKinematics(robot), urdf::Side::left);
  const urdf::Joint& joint = robot.joints[static_cast<std::size_t>(joints[pace.joint])];
  const double byte_rad_per_s = facts::kLargestByte_counts * joint.count_rad / facts::kSlot_s;
  const bool by_byte = joint.velocity_limit_rad_per_s > 0.99 * byte_rad_per_s;
  return fmt::format("speed: the {} turns at {:.3g} rad/s at most{}", urdf::leg_joint_name(pace.joint),
                     std::min(joint.velocity_limit_rad_per_s, byte_rad_per_s),
                     by_byte ? ": more does not fit the byte on the wire" : "");
}

std::string room_reason(const urdf::RobotModel& robot, const JointRoom& room) {
  const urdf::LegJoints joints(robot, urdf::ForwardKinematics(robot), urdf::Side::left);
  const urdf::Joint& joint = robot.joints[static_cast<std::size_t>(joints[room.joint])];
  return fmt::format("limit: the {} turns from {:.3g} to {:.3g} rad", urdf::leg_joint_name(room.joint),
                     joint.lower_rad, joint.upper_rad);
}

constexpr const char* kTwistReason = "ground: heavy legs in the air twist the foot on the ground";

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
  }
  return excess;
}

// How far a gait may leave the scaled default.
struct StepBounds {
  double good_lift_m, least_lift_m, quickest_s, slowest_s;
};

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

// One change of the step that makes it ask for less: what costs least first. False: there is none.
bool ease(GaitParameters& p, const StepBounds& bounds, Excess& excess, const auto& ask) {
  constexpr double kWorth = 0.003;
  const std::array<std::function<bool(GaitParameters&)>, 6> changes{
      flatten,
      raise_fast_hips,
      [&](GaitParameters& q) { return lower_lift(q, bounds.good_lift_m); },
      [&](GaitParameters& q) { return change_step_time(q, -facts::kSlot_s, bounds); },
      [&](GaitParameters& q) { return change_step_time(q, facts::kSlot_s, bounds); },
      [&](GaitParameters& q) { return lower_lift(q, bounds.least_lift_m); },
  };
  for (const auto& change : changes) {
    GaitParameters next = p;
    if (!change(next)) continue;
    Excess then = ask(next);
    if (then.sum > 0.0 && !(then.sum < excess.sum - kWorth)) continue;
    p = next;
    excess = std::move(then);
    return true;
  }
  return false;
}

// Changes of the step, until it asks no more than it may, or nothing helps.
void ease_step(GaitParameters& p, const urdf::RobotModel& robot, std::span<const StrideGoal> goals,
               const StepBounds& bounds, ChoiceLog& log) {
  const auto ask = [&](const GaitParameters& q) { return excess_of(q, robot, goals); };
  Excess excess = ask(p);
  for (std::string reason = excess.reason; excess.sum > 0.0 && ease(p, bounds, excess, ask);
       reason = excess.reason) {
    log.note(reason);
  }
}

// For a usual and an everyday walk whatever it takes; for a fast one what costs little.
void fit_step(GaitParameters& p, const urdf::RobotModel& robot, ChoiceLog& log) {
  const GaitParameters wanted = p;
  const double larger = robot.body_scale().factor("m/s");
  const double longest_m_per_s = p.max_step_forward_m / p.step_time_s;
  const std::array<StrideGoal, 3> goals{
      {{kUsualSpeed_m_per_s * larger, kUsualShare, kMostTwist},
       {std::min(kEverydaySpeed_m_per_s * larger, longest_m_per_s), kFastestShare, kMostTwist},
       {std::min(kFastSpeed_m_per_s * larger, longest_m_per_s), kFastestShare, kMostTwist}}};
  const double quickest_s = std::max(kQuickestStep * wanted.step_time_s, kQuickestStep_s);
  const double fast_lift_m = kFastLift * wanted.lift_m;
  ease_step(p, robot, std::span(goals).first(2),
            {kGoodLift * wanted.lift_m, kLeastLift * wanted.lift_m, quickest_s,
             std::min(kSlowestStep * wanted.step_time_s, kLongestStep_s)},
            log);
  ease_step(p, robot, goals, {fast_lift_m, fast_lift_m, quickest_s, kSlowestFastStep * wanted.step_time_s},
            log);
  if (p.step_time_s != wanted.step_time_s) {
    scale_adjusted_swings(p, wanted);
    log.note("step: as much quicker or slower as its time");
  }
}

// One or more numbers of the gait get less, down to a share of what they are, while `asks_too_much` says so;
// it returns its reason, or nothing.
template <class Lessen, class AsksTooMuch>
void lessen_while(ChoiceLog& log, double least_share, const Lessen& lessen,
                  const AsksTooMuch& asks_too_much) {
  constexpr double kLess = 0.98;
  std::string reason;
  for (double share = 1.0; share > least_share; share *= kLess) {
    std::string why = asks_too_much();
    if (why.empty()) break;
    if (reason.empty()) reason = std::move(why);
    lessen(kLess);
  }
  log.note(reason);
}

template <class AsksTooMuch>
void shorten_steps(GaitParameters& p, ChoiceLog& log, const AsksTooMuch& asks_too_much) {
  const auto shorten = [&](double share) {
    p.max_step_forward_m *= share;
    p.max_step_backward_m *= share;
  };
  lessen_while(log, kLeastStep * p.hip_height_m / p.max_step_forward_m, shorten, asks_too_much);
}

std::string too_much_at(const GaitParameters& p, const urdf::RobotModel& robot, const Velocity2& velocity) {
  const StrideDemand demand = stride_demand(p, robot, velocity);
  if (demand.pace.share > kFastestShare) return speed_reason(robot, demand.pace);
  return demand.room.room_rad < kLeastRoom_rad ? room_reason(robot, demand.room) : "";
}

// Until turning and side-stepping are such, too.
void fit_turns_and_side_steps(GaitParameters& p, const urdf::RobotModel& robot, ChoiceLog& log) {
  constexpr double kLeastTurn = 0.02;  // of the scaled default
  lessen_while(
      log, kLeastTurn, [&](double share) { p.max_step_turn_rad *= share; },
      [&] { return too_much_at(p, robot, {.turn_rad_per_s = FootstepPlanner(p).max_turn_rad_per_s()}); });
  const double widened_m = p.max_foot_spacing_m - p.foot_spacing_m;
  if (widened_m <= kSameSpacing_m) return;
  lessen_while(
      log, kLeastStep,
      [&](double share) {
        p.max_foot_spacing_m = std::lerp(p.foot_spacing_m, p.max_foot_spacing_m, share);
        p.adjust_spacing_m = std::min(p.adjust_spacing_m, p.max_foot_spacing_m);
      },
      [&] { return too_much_at(p, robot, {.left_m_per_s = FootstepPlanner(p).max_left_m_per_s()}); });
}

// Until the fastest walk is one that the motors can follow, and swing the leg for.
void fit_motors(GaitParameters& p, const urdf::RobotModel& robot, ChoiceLog& log) {
  try {
    p.validate();
  } catch (const std::invalid_argument&) {
    return;  // the configuration may mend it; else it is told then
  }
  fit_step(p, robot, log);
  shorten_steps(p, log, [&]() -> std::string {
    const double fastest_m_per_s = p.max_step_forward_m / p.step_time_s;
    std::string why = too_much_at(p, robot, {.forward_m_per_s = fastest_m_per_s});
    if (!why.empty()) return why;
    return stride_demand(p, robot, fastest_m_per_s).twist_share > kMostTwist ? kTwistReason : "";
  });
  fit_turns_and_side_steps(p, robot, log);
  shorten_steps(p, log, [&]() -> std::string {
    for (const JointTorque& torque : leg_torques(p, robot)) {
      if (JointTorque::kWalking * torque.swings_Nm <= torque.limit_Nm) continue;
      return fmt::format("torque: the {} has {:.3g} N*m to swing the leg with",
                         urdf::leg_joint_name(torque.joint), torque.limit_Nm);
    }
    return {};
  });
}

}  // namespace

const GaitChoice* ChosenGait::choice(const std::string& parameter) const noexcept {
  const auto found = std::ranges::find(choices, parameter, &GaitChoice::parameter);
  return found == choices.end() ? nullptr : &*found;
}

ChosenGait choose_gait(const urdf::RobotModel& robot) {
  ChosenGait gait;
  GaitParameters& p = gait.parameters;
  scale_to_body(p.numbers(), robot.body_scale());
  ChoiceLog log(gait);
  const double wider_m = take_from_description(p, robot);
  log.note("stance: the standing posture of the description");
  fit_stance(p, wider_m);
  log.note(fmt::format("stance: the soles are {:.3g} m wide and {:.3g} m apart", p.sole.width_m,
                       p.foot_spacing_m));
  fit_tail(p, log);
  fit_reach(p, robot, log);
  fit_motors(p, robot, log);
  fit_reach(p, robot, log);  // once more: in a quick walk the hips may be higher now
  fit_tail(p, log);
  return gait;
}

GaitParameters gait_of(const urdf::RobotModel& robot) {
  return choose_gait(robot).parameters;
}

}  // namespace gaitway::trajectory
