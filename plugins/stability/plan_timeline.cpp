// A small ring of excerpts.
#include "gaitway/stability/plan_timeline.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::stability {
namespace {

constexpr std::int64_t kPoint_ns = 10'000'000;

}  // namespace

void PlanTimeline::take(const MotionPlan& plan) noexcept {
  if (plan.sequence == 0) return;
  const std::uint32_t count = kBatchPoints + std::min<std::uint32_t>(plan.tail_count, kMaxTailPoints);
  if (!std::all_of(plan.base_yaw, plan.base_yaw + count, [](double yaw) { return std::isfinite(yaw); }))
    return;
  if (kept_[newest_].sequence != plan.sequence) newest_ = (newest_ + 1) % kKept;
  Excerpt& excerpt = kept_[newest_];
  excerpt.sequence = plan.sequence;
  excerpt.count = count;
  excerpt.start_ns = plan.start_ns;
  excerpt.walking = plan.footstep_count > 0;
  std::copy_n(plan.support, count, excerpt.support.begin());
  std::copy_n(plan.base_yaw, count, excerpt.base_yaw_rad.begin());
}

std::optional<PlanMoment> PlanTimeline::at(std::int64_t now_ns,
                                           std::optional<std::uint32_t> accepted_sequence) const noexcept {
  for (std::size_t back = 0; back < kKept; ++back) {
    const Excerpt& excerpt = kept_[(newest_ + kKept - back) % kKept];
    if (excerpt.sequence == 0) break;
    if (excerpt.start_ns > now_ns || (accepted_sequence && excerpt.sequence > *accepted_sequence)) continue;
    const std::int64_t last = static_cast<std::int64_t>(excerpt.count) - 1;
    const std::int64_t slot =
        (now_ns - excerpt.start_ns) / kPoint_ns;  // point i is reached at the end of slot i
    PlanMoment moment;
    moment.support =
        std::min<std::size_t>(excerpt.support[static_cast<std::size_t>(std::min(slot, last))], 2);
    moment.base_yaw_rad =
        excerpt.base_yaw_rad[static_cast<std::size_t>(std::clamp<std::int64_t>(slot - 1, 0, last))];
    moment.walking = excerpt.walking && slot <= last;
    return moment;
  }
  return std::nullopt;
}

}  // namespace gaitway::stability
