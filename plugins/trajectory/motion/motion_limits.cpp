// The robot's limits joint by joint, and the dense check: every point against every limit.
#include "gaitway/motion/motion_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/body_load.hpp"
#include "gaitway/motion/stance_map.hpp"

namespace gaitway::motion {
namespace {

// Carrying on the rounding of the point before takes one of the counts that a signed byte holds.
constexpr double kLargestStep_counts = facts::kLargestByte_counts - 1;

constexpr std::array<std::string_view, 8> kNames{"position", "speed",    "acceleration", "torque",
                                                 "ZMP",      "friction", "weight",       "place"};
constexpr double kPlaceLimit_m = 0.0005;
constexpr double kSumRounding = 1e-9;  // of sums, not a tolerance

class PlanChecker {
 public:
  PlanChecker(const urdf::RobotModel& robot, const MotionPlan& plan, const MotionLimits& limits)
      : robot_(robot),
        plan_(plan),
        limits_(limits),
        joints_(robot, limits),
        loads_(robot, plan),
        worst_(kNames.size()) {}

  PlanReport run() {
    for (std::size_t i = 0; i < plan_.point_count(); ++i) check_point(i);
    PlanReport report;
    for (std::optional<LimitUse>& use : worst_) {
      if (use) report.uses.push_back(*use);
    }
    return report;
  }

 private:
  void note(LimitKind kind, std::string_view what, std::string_view unit, std::size_t point, double value,
            double limit, double excess) {
    std::optional<LimitUse>& worst = worst_[static_cast<std::size_t>(kind)];
    if (worst && excess <= worst->excess) return;
    worst = LimitUse{kind,
                     std::string(what),
                     std::string(unit),
                     static_cast<double>(point) * facts::kSlot_s,
                     value,
                     limit,
                     excess};
  }
  void at_most(LimitKind kind, std::string_view what, std::string_view unit, std::size_t point, double value,
               double limit) {
    note(kind, what, unit, point, value, limit, value - limit - kSumRounding * std::abs(limit));
  }

  void check_point(std::size_t point);
  void check_joints(std::size_t point, const BodyLoad& load);
  void check_way(std::size_t point, std::size_t joint, const std::vector<double>& rows, double lower_rad,
                 double upper_rad);
  void check_stance(std::size_t point, const BodyLoad& load, const std::array<Eigen::Isometry3d, 2>& sole);
  void check_sole(std::size_t point, urdf::Side side, const Eigen::Isometry3d& sole);

  const urdf::RobotModel& robot_;
  const MotionPlan& plan_;
  MotionLimits limits_;
  JointLimits joints_;
  PlanLoads loads_;
  std::vector<std::optional<LimitUse>> worst_;  // [LimitKind]
  std::array<std::optional<Eigen::Isometry3d>, 2> stood_;
};

void PlanChecker::check_point(std::size_t point) {
  const BodyLoad& load = loads_.at(point);
  check_joints(point, load);
  if (plan_.contact[point] != Contact::none) check_stance(point, load, loads_.soles());
}

void PlanChecker::check_joints(std::size_t point, const BodyLoad& load) {
  for (std::size_t index = 0; index < plan_.joint_count; ++index) {
    const auto j = static_cast<Eigen::Index>(index);
    const urdf::Joint& joint = robot_.joints[index];
    check_way(point, index, plan_.joint_rad, joints_.lower_rad[j], joints_.upper_rad[j]);
    if (!plan_.reference_rad.empty()) {
      check_way(point, index, plan_.reference_rad, joint.lower_rad, joint.upper_rad);
    }
    at_most(LimitKind::acceleration, joint.name, "rad/s²", point, std::abs(load.acceleration_rad_per_s2[j]),
            joints_.acceleration_rad_per_s2[j]);
    if (plan_.contact[point] != Contact::none) {
      at_most(LimitKind::torque, joint.name, "N·m", point, std::abs(load.torque_Nm[j]),
              joints_.torque_Nm(j, load.speed_rad_per_s[j], load.torque_Nm[j]));
    }
  }
}

// Position and speed of a joint, or of its reference.
void PlanChecker::check_way(std::size_t point, std::size_t joint, const std::vector<double>& rows,
                            double lower_rad, double upper_rad) {
  const std::string& name = robot_.joints[joint].name;
  const std::size_t at = point * plan_.joint_count + joint;
  const double angle = rows[at], before = point == 0 ? angle : rows[at - plan_.joint_count];
  const double above = angle - upper_rad, below = lower_rad - angle;
  note(LimitKind::position, name, "rad", point, angle, above > below ? upper_rad : lower_rad,
       std::max(above, below) - kSumRounding);
  at_most(LimitKind::speed, name, "rad/s", point, std::abs(angle - before) / facts::kSlot_s,
          joints_.speed_rad_per_s[static_cast<Eigen::Index>(joint)]);
}

void PlanChecker::check_stance(std::size_t point, const BodyLoad& load,
                               const std::array<Eigen::Isometry3d, 2>& sole) {
  const double margin_m = support_area(robot_, plan_.contact[point], sole).margin_m(load.zmp_m);
  note(LimitKind::zmp, "margin of the ZMP inside the support", "mm", point, 1e3 * margin_m,
       1e3 * limits_.zmp_margin_m, 1e3 * (limits_.zmp_margin_m - margin_m));
  at_most(LimitKind::friction, "tangential over normal force", "1", point, load.friction_ratio,
          limits_.friction_share * robot_.contact.friction);
  const double share = load.normal_force_N / loads_.weight_N();
  note(LimitKind::weight, "share of the weight on the ground", "1", point, share, limits_.least_weight_share,
       limits_.least_weight_share - share);
  for (const urdf::Side side : urdf::kSides) check_sole(point, side, sole[static_cast<std::size_t>(side)]);
}

// A foot that stands is flat and stays where it is; the other one is not in the ground.
void PlanChecker::check_sole(std::size_t point, urdf::Side side, const Eigen::Isometry3d& sole) {
  const auto i = static_cast<std::size_t>(side);
  const std::string_view name = side == urdf::Side::left ? "left sole" : "right sole";
  const bool stands = stands_on(plan_.contact[point], side);
  if (!stands)
    stood_[i].reset();
  else if (!stood_[i])
    stood_[i] = sole;
  for (const Eigen::Vector2d& of_sole : robot_.feet[i].corners_m()) {
    const Eigen::Vector3d corner(of_sole.x(), of_sole.y(), 0.0);
    const Eigen::Vector3d place = sole * corner;
    const double off_m = stands ? std::max(std::abs(place.z()), (place - *stood_[i] * corner).norm())
                                : std::max(0.0, -place.z());
    at_most(LimitKind::foot_place, name, "mm", point, 1e3 * off_m, 1e3 * kPlaceLimit_m);
  }
}

}  // namespace

MotionLimits limits_of(const Motion& motion, MotionLimits limits) noexcept {
  if (motion.torque_share) limits.torque_share = std::min(limits.torque_share, *motion.torque_share);
  return limits;
}

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

const LimitUse* PlanReport::broken() const noexcept {
  const auto found = std::ranges::find_if(uses, [](const LimitUse& use) { return !(use.excess <= 0.0); });
  return found == uses.end() ? nullptr : &*found;
}

std::string_view name_of(LimitKind kind) noexcept {
  return kNames[static_cast<std::size_t>(kind)];
}

std::string describe(const LimitUse& use) {
  return fmt::format("{}: {} {:.3g} {} at {:.2f} s, limit {:.3g} {}", use.what, name_of(use.kind), use.value,
                     use.unit, use.time_s, use.limit, use.unit);
}

PlanReport check_plan(const urdf::RobotModel& robot, const MotionPlan& plan, const MotionLimits& limits) {
  return PlanChecker(robot, plan, limits).run();
}

}  // namespace gaitway::motion
