// A small ring of excerpts.
#include "gaitway/stability/plan_timeline.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::stability {
namespace {

// A trunk that leans less may be balanced as if it were upright: the trims for it are small.
constexpr double kUpright_rad = 0.05;
constexpr std::uint32_t kKeyFrameMotion = 1;  // MotionPlan::motion
constexpr std::size_t kMostSupport = 2;       // both feet; beyond it neither is meant to carry

}  // namespace

void PlanTimeline::take(const MotionPlan& plan) noexcept {
  if (plan.sequence == 0) return;
  const std::uint32_t count = kBatchPoints + std::min<std::uint32_t>(plan.tail_count, kMaxTailPoints);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!std::isfinite(plan.commanded_yaw[i] + plan.base_yaw[i] + plan.com_velocity[i][0] +
                       plan.com_velocity[i][1] + plan.trunk_attitude[i][0] + plan.trunk_attitude[i][1]))
      return;
  }
  if (kept_[newest_].sequence != plan.sequence) newest_ = (newest_ + 1) % kKept;
  Excerpt& excerpt = kept_[newest_];
  excerpt.sequence = plan.sequence;
  excerpt.count = count;
  excerpt.start_ns = plan.start_ns;
  excerpt.walking = plan.footstep_count > 0;
  excerpt.motion = plan.motion == kKeyFrameMotion;
  excerpt.fall_posture = plan.motion == kFallPostureMotion;
  upright_ = !excerpt.fall_posture;
  std::copy_n(plan.support, count, excerpt.support.begin());
  std::copy_n(plan.commanded_yaw, count, excerpt.commanded_yaw_rad.begin());
  for (std::uint32_t i = 0; i < count; ++i) {
    const Eigen::Rotation2Dd to_base(-plan.base_yaw[i]);
    const Eigen::Vector2d velocity =
        to_base * Eigen::Vector2d(plan.com_velocity[i][0], plan.com_velocity[i][1]);
    excerpt.com_velocity_m_per_s[i] = {velocity.x(), velocity.y()};
    excerpt.foot_turn_rad[i] = {plan.foot_yaw[i][0] - plan.base_yaw[i],
                                plan.foot_yaw[i][1] - plan.base_yaw[i]};
    excerpt.trunk_attitude_rad[i] = {plan.trunk_attitude[i][0], plan.trunk_attitude[i][1]};
    upright_ = upright_ && std::hypot(plan.trunk_attitude[i][0], plan.trunk_attitude[i][1]) < kUpright_rad;
  }
  const std::uint32_t last = count - 1;
  for (std::size_t side = 0; side < excerpt.com_in_foot.size(); ++side) {
    const Eigen::Rotation2Dd to_foot(-plan.foot_yaw[last][side]);
    const auto& foot = plan.foot_position[last][side];
    const Eigen::Vector2d com =
        to_foot * Eigen::Vector2d(plan.com[last][0] - foot[0], plan.com[last][1] - foot[1]);
    excerpt.com_in_foot[side] = {com.x(), com.y(), plan.foot_yaw[last][side] - plan.base_yaw[last]};
  }
}

std::optional<PlanMoment> PlanTimeline::at(std::int64_t now_ns,
                                           std::optional<std::uint32_t> accepted_sequence) const noexcept {
  for (std::size_t back = 0; back < kKept; ++back) {
    const Excerpt& excerpt = kept_[(newest_ + kKept - back) % kKept];
    if (excerpt.sequence == 0) break;
    if (excerpt.start_ns > now_ns || (accepted_sequence && excerpt.sequence > *accepted_sequence)) continue;
    const std::int64_t last = static_cast<std::int64_t>(excerpt.count) - 1;
    const std::int64_t slot =
        (now_ns - excerpt.start_ns) / facts::kSlot_ns;  // point i is reached at the end of slot i
    PlanMoment moment;
    moment.sequence = excerpt.sequence;
    moment.since_start_s = 1e-9 * static_cast<double>(now_ns - excerpt.start_ns);
    const std::size_t support = excerpt.support[static_cast<std::size_t>(std::min(slot, last))];
    moment.support = std::min(support, kMostSupport + 1);
    moment.fall_posture = excerpt.fall_posture;
    moment.on_ground = !excerpt.fall_posture && support > kMostSupport && slot <= last;
    const auto reached = static_cast<std::size_t>(std::clamp<std::int64_t>(slot - 1, 0, last));
    moment.commanded_yaw_rad = excerpt.commanded_yaw_rad[reached];
    moment.com_velocity_m_per_s = Eigen::Vector2d(excerpt.com_velocity_m_per_s[reached].data());
    moment.foot_turn_rad = excerpt.foot_turn_rad[reached];
    for (std::size_t side = 0; side < 2; ++side) {
      const std::array<double, 3>& com = excerpt.com_in_foot[side];
      moment.com_in_foot_m[side] = {com[0], com[1]};
      moment.foot_from_base_rad[side] = com[2];
    }
    moment.walking = excerpt.walking && slot <= last;
    moment.motion = excerpt.motion && slot <= last;
    moment.trunk_attitude_rad = Eigen::Vector2d(excerpt.trunk_attitude_rad[reached].data());
    const std::size_t before = reached == 0 ? 0 : reached - 1;
    moment.trunk_rate_rad_per_s =
        (moment.trunk_attitude_rad - Eigen::Vector2d(excerpt.trunk_attitude_rad[before].data())) /
        facts::kSlot_s;
    return moment;
  }
  return std::nullopt;
}

}  // namespace gaitway::stability
