// The least-jerk way from one to zero, for all joints alike.
#include "gaitway/kinematics/held_start.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::kinematics {
namespace {

// Of a body like humanoid22: a bow that goes back faster throws the body to where it came from.
constexpr double kFastest_rad_per_s = 0.5;
constexpr double kShare = 0.5;       // of a joint's speed at most: the plan wants some, too
constexpr double kSteepest = 1.875;  // of the least-jerk way, times its mean
constexpr double kNoticeable = 0.5;  // of what a joint may turn in a slot: less is a plan's own first step

double what_is_left(double share) noexcept {
  const double s = std::clamp(share, 0.0, 1.0);
  return 1.0 - s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

}  // namespace

HeldStart::HeldStart(const urdf::RobotModel& model) {
  const double fastest_rad_per_s = kFastest_rad_per_s * model.body_scale().factor("rad/s");
  for (const urdf::Joint& joint : model.joints) {
    noticeable_rad_.push_back(kNoticeable * joint.velocity_limit_rad_per_s * facts::kSlot_s);
    most_rad_per_s_.push_back(std::min(kShare * joint.velocity_limit_rad_per_s, fastest_rad_per_s));
  }
}

bool HeldStart::apply(std::span<const double> held_rad, JointPlan& plan, Detour& detour) noexcept {
  way_before_ = way_;
  const bool held = held_rad.size() >= most_rad_per_s_.size() && plan.joint_count == most_rad_per_s_.size();
  if (held) way_ = begin(held_rad, plan, detour);
  if (way_.points == 0) return false;
  const std::uint32_t count = kBatchPoints + std::min<std::uint32_t>(plan.tail_count, kMaxTailPoints);
  for (std::uint32_t point = 0; point < count; ++point) {
    const double left = what_is_left(static_cast<double>(way_.played + point + 1) / way_.points);
    for (std::size_t joint = 0; joint < most_rad_per_s_.size(); ++joint) {
      plan.position[point][joint] += static_cast<float>(left * way_.beside_rad[joint]);
    }
  }
  way_.played += kBatchPoints;
  if (way_.played >= way_.points) way_.points = 0;
  return held;
}

HeldStart::Way HeldStart::begin(std::span<const double> held_rad, const JointPlan& plan,
                                Detour& detour) const noexcept {
  Way way;
  double longest_s = 0.0;
  bool jumps = false;
  for (std::size_t joint = 0; joint < most_rad_per_s_.size(); ++joint) {
    const double beside_rad = held_rad[joint] - static_cast<double>(plan.position[0][joint]);
    if (!std::isfinite(beside_rad)) return {};
    way.beside_rad[joint] = beside_rad;
    jumps = jumps || std::abs(beside_rad) > noticeable_rad_[joint];
    const double time_s = kSteepest * std::abs(beside_rad) / most_rad_per_s_[joint];
    if (time_s > longest_s) {
      longest_s = time_s;
      detour = {joint, std::abs(beside_rad), time_s};
    }
  }
  if (!jumps) return {};
  way.points = std::max<std::uint32_t>(kBatchPoints,
                                       static_cast<std::uint32_t>(std::ceil(longest_s / facts::kSlot_s)));
  return way;
}

}  // namespace gaitway::kinematics
