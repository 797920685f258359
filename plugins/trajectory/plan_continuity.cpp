// The decision whether a plan goes on.
#include "gaitway/trajectory/plan_continuity.hpp"

namespace gaitway::trajectory {

PlanDecision PlanContinuity::decide(std::uint32_t sequence, NetworkMode mode,
                                    std::uint32_t accepted_sequence) noexcept {
  if (published_sequence_ != 0) {
    if (accepted_sequence == published_sequence_) {
      accepted_stance_ = published_stance_;
      if (published_sequence_ + 1 != sequence) broken_ = true;  // cycles were missed: its tail has begun
    } else {
      broken_ = true;
    }
    published_sequence_ = 0;
  } else {
    broken_ = true;  // the cycle before had no plan
  }
  if (mode == NetworkMode::safe_tail || mode == NetworkMode::emergency) broken_ = true;
  if (!broken_) return PlanDecision::resume;  // also when holding: the first batch is accepted but not begun
  return mode == NetworkMode::holding ? PlanDecision::begin_anew : PlanDecision::wait;
}

void PlanContinuity::published(std::uint32_t sequence, const Pose2& final_stance) noexcept {
  published_sequence_ = sequence;
  published_stance_ = final_stance;
  broken_ = false;
}

}  // namespace gaitway::trajectory
