// The standing posture by forward kinematics; then one fit after the other, each of which says what it took
// into account.
#include "gaitway/trajectory/gait_choice.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/joint_torque.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "step_search.hpp"

namespace gaitway::trajectory {
namespace {

constexpr double kSameSpacing_m = 1e-6;
constexpr double kMostInward = 0.25;  // of the sole's width
constexpr double kLeastStep = 0.05;   // of the hip height: a step that is not worth less

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
  const urdf::Foot& foot = *std::ranges::min_element(robot.feet, {}, [](const urdf::Foot& one) {
    return one.size_m.x() * one.size_m.y();  // the smaller one bounds every step
  });
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
  fit_step(p, robot, [&log](const std::string& reason) { log.note(reason); });
  shorten_steps(p, log, [&]() -> std::string {
    return too_much_ahead(p, robot, p.max_step_forward_m / p.step_time_s);
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
