// Point by point, joint by joint.
#include "gaitway/core/joint_plan_check.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::core {
namespace {

using facts::kSlot_s;
constexpr double kFloatRounding_rad = 1e-6;  // positions travel as 32-bit floats

struct RuleText {
  std::string_view text, unit;
};
constexpr std::array<RuleText, 9> kRules{{
    {"fine", ""},
    {"number of joints must be the robot's", ""},
    {"points of the safe tail must fit the plan", ""},
    {"support must be left, right or both", ""},
    {"must be a finite number", ""},
    {"must lie within the joint's limits", "rad"},
    {"must go on from the joint's reference within its velocity limit", "rad/s"},
    {"must change within the joint's velocity limit", "rad/s"},
    {"must change within one time slot by what a trajectory frame holds", "counts"},
}};

const RuleText& text_of(JointPlanRule rule) noexcept {
  return kRules[static_cast<std::size_t>(rule)];
}

}  // namespace

JointPlanCheck::JointPlanCheck(const urdf::RobotModel& robot) {
  for (const urdf::Joint& joint : robot.joints) {
    joints_.push_back(
        {joint.name, joint.lower_rad, joint.upper_rad, joint.velocity_limit_rad_per_s, joint.count_rad});
  }
}

JointPlanVerdict JointPlanCheck::check(const JointPlan& plan,
                                       std::span<const double> start_rad) const noexcept {
  const auto count_problem = [](JointPlanRule rule, double value, double highest) {
    return JointPlanVerdict{.rule = rule, .value = value, .highest = highest, .refused_points = 1};
  };
  if (plan.joint_count != joints_.size()) {
    return count_problem(JointPlanRule::joint_count, plan.joint_count, static_cast<double>(joints_.size()));
  }
  if (plan.tail_count > static_cast<std::uint32_t>(kMaxTailPoints)) {
    return count_problem(JointPlanRule::tail_count, plan.tail_count, kMaxTailPoints);
  }
  JointPlanVerdict first;
  std::uint64_t refused = 0;
  const auto note = [&](const JointPlanVerdict& verdict) {
    refused += verdict.accepted() ? 0U : 1U;
    first = first.accepted() ? verdict : first;
  };
  const int points = kBatchPoints + static_cast<int>(plan.tail_count);
  for (int point = 0; point < points; ++point) {
    if (plan.support[point] >= kSupports) {
      note({.rule = JointPlanRule::support,
            .point = point,
            .value = static_cast<double>(plan.support[point]),
            .highest = kSupports - 1});
    }
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
      const double to = static_cast<double>(plan.position[point][joint]);
      const bool starts_unknown = point == 0 && joint >= start_rad.size();
      const double from = starts_unknown ? to
                          : point == 0   ? start_rad[joint]
                                         : static_cast<double>(plan.position[point - 1][joint]);
      note(check_step(joint, point, from, to));
    }
  }
  first.refused_points = refused;
  return first;
}

JointPlanVerdict JointPlanCheck::check_step(std::size_t joint, int point, double from_rad,
                                            double to_rad) const noexcept {
  const Limits& limits = joints_[joint];
  const auto refuse = [&](JointPlanRule rule, double value, double lowest, double highest) {
    return JointPlanVerdict{rule, static_cast<int>(joint), point, value, lowest, highest, 0};
  };
  if (!std::isfinite(to_rad)) {
    return refuse(JointPlanRule::finite, to_rad, limits.lower_rad, limits.upper_rad);
  }
  if (to_rad < limits.lower_rad - kFloatRounding_rad || to_rad > limits.upper_rad + kFloatRounding_rad) {
    return refuse(JointPlanRule::position_limit, to_rad, limits.lower_rad, limits.upper_rad);
  }
  if (!std::isfinite(from_rad)) {
    return {};  // the point before was refused for it
  }
  const double velocity = (to_rad - from_rad) / kSlot_s;
  if (std::abs(to_rad - from_rad) > limits.velocity_rad_per_s * kSlot_s + limits.count_rad) {
    return refuse(point == 0 ? JointPlanRule::continuity : JointPlanRule::velocity_limit, velocity,
                  -limits.velocity_rad_per_s, limits.velocity_rad_per_s);
  }
  const double counts = std::round(to_rad / limits.count_rad) - std::round(from_rad / limits.count_rad);
  if (std::abs(counts) > facts::kLargestByte_counts) {
    return refuse(JointPlanRule::count_range, counts, -facts::kLargestByte_counts,
                  facts::kLargestByte_counts);
  }
  return {};
}

std::string_view JointPlanCheck::describe(const JointPlanVerdict& verdict,
                                          std::span<char> to) const noexcept {
  const bool has_joint = verdict.joint >= 0 && static_cast<std::size_t>(verdict.joint) < joints_.size();
  const std::string_view joint = has_joint
                                     ? std::string_view(joints_[static_cast<std::size_t>(verdict.joint)].name)
                                     : std::string_view("all");
  const std::string_view part = verdict.point < kBatchPoints ? "batch" : "safe tail";
  const auto written =
      verdict.point < 0
          ? fmt::format_to_n(to.data(), to.size(), "{:g}: {} (at most {:g})", verdict.value,
                             text_of(verdict.rule).text, verdict.highest)
          : fmt::format_to_n(to.data(), to.size(), "joint '{}', point {} ({}): {:g} {}: {} ({:g}..{:g})",
                             joint, verdict.point, part, verdict.value, text_of(verdict.rule).unit,
                             text_of(verdict.rule).text, verdict.lowest, verdict.highest);
  return {to.data(), std::min(written.size, to.size())};
}

}  // namespace gaitway::core
