// Looks up points of plans: point i is reached at start + (i + 1) * 10 ms.
#include "gaitway/api/planned_motion.hpp"

#include <algorithm>

#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

// The point that is reached at the instant, or the one before; -1 before the first.
std::int64_t point_before(const MotionPlan& plan, std::int64_t instant_ns) noexcept {
  const std::int64_t last = kBatchPoints + std::min<std::int64_t>(plan.tail_count, kMaxTailPoints) - 1;
  return std::clamp<std::int64_t>((instant_ns - plan.start_ns) / facts::kSlot_ns - 1, -1, last);
}

PlannedMoment moment_of(const MotionPlan& plan, std::size_t point) noexcept {
  PlannedMoment moment;
  for (std::size_t side = 0; side < moment.feet.size(); ++side) {
    const double* foot = plan.foot_position[point][side];
    moment.feet[side].position_m = {foot[0], foot[1], foot[2]};
    moment.feet[side].yaw_rad = plan.foot_yaw[point][side];
    moment.feet[side].on_ground = plan.support[point] == 2 || plan.support[point] == side;
  }
  moment.zmp_m = {plan.zmp[point][0], plan.zmp[point][1]};
  return moment;
}

// `share`: 0 at `from`, 1 at `to`. A foot is on the ground where both points have it there.
PlannedMoment between(const PlannedMoment& from, const PlannedMoment& to, double share) noexcept {
  PlannedMoment moment;
  for (std::size_t side = 0; side < moment.feet.size(); ++side) {
    const PlannedFoot& a = from.feet[side];
    const PlannedFoot& b = to.feet[side];
    moment.feet[side] = {a.position_m + share * (b.position_m - a.position_m),
                         a.yaw_rad + share * (b.yaw_rad - a.yaw_rad), a.on_ground && b.on_ground};
  }
  moment.zmp_m = from.zmp_m + share * (to.zmp_m - from.zmp_m);
  return moment;
}

}  // namespace

void PlannedMotion::take(const MotionPlan& plan) noexcept {
  if (plan.sequence == 0) return;
  auto place = std::ranges::find(kept_, plan.sequence, &MotionPlan::sequence);
  if (place == kept_.end()) {
    place = std::ranges::min_element(kept_, [](const MotionPlan& a, const MotionPlan& b) {
      return a.sequence == 0 || (b.sequence != 0 && a.start_ns < b.start_ns);
    });
  }
  *place = plan;
}

const MotionPlan* PlannedMotion::before(const MotionPlan& plan) const noexcept {
  const MotionPlan* found = nullptr;
  for (const MotionPlan& kept : kept_) {
    if (kept.sequence == 0 || kept.start_ns >= plan.start_ns) continue;
    if (found == nullptr || kept.start_ns > found->start_ns) found = &kept;
  }
  return found;
}

std::optional<PlannedMoment> PlannedMotion::at(
    std::int64_t instant_ns, std::optional<std::uint32_t> accepted_sequence) const noexcept {
  const MotionPlan* plan = nullptr;
  for (const MotionPlan& kept : kept_) {
    if (kept.sequence == 0 || kept.start_ns > instant_ns) continue;
    if (accepted_sequence && kept.sequence > *accepted_sequence) continue;
    if (plan == nullptr || kept.start_ns > plan->start_ns) plan = &kept;
  }
  if (plan == nullptr) return std::nullopt;

  const std::int64_t point = point_before(*plan, instant_ns);
  const std::int64_t next = std::min(point + 1, point_before(*plan, INT64_MAX / 2));
  PlannedMoment from = moment_of(*plan, static_cast<std::size_t>(std::max<std::int64_t>(point, 0)));
  const MotionPlan* predecessor = point < 0 ? before(*plan) : nullptr;
  if (predecessor != nullptr) {
    const std::int64_t last = point_before(*predecessor, plan->start_ns);
    from = moment_of(*predecessor, static_cast<std::size_t>(std::max<std::int64_t>(last, 0)));
  }
  const std::int64_t since_ns = instant_ns - plan->start_ns - (point + 1) * facts::kSlot_ns;
  const double share = std::min(static_cast<double>(since_ns) / facts::kSlot_ns, 1.0);
  PlannedMoment moment =
      share > 0.0 ? between(from, moment_of(*plan, static_cast<std::size_t>(next)), share) : from;
  moment.plan = plan;
  return moment;
}

}  // namespace gaitway::api
