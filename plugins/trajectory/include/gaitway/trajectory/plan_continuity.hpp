// Decides at each batch whether the plan goes on, waits, or begins anew from the stand, by what became of the
// batches handed over before.
#pragma once

#include <cstdint>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/footstep_planner.hpp"

namespace gaitway::trajectory {

enum class PlanDecision : std::uint8_t {
  wait,        // publish no plan: the robot plays a tail, or is in an emergency stop
  resume,      // plan on from the last batch
  begin_anew,  // reset the pattern to the stand at restart_stance(), then plan
};

// Order of calls in a batch tick: decide(), then, if a plan was made, published().
class PlanContinuity {
 public:
  // sequence: of the batch to be planned. The batch published one cycle before must be the newest that the
  // message controller accepted, else the safe tail of an older one is about to play.
  [[nodiscard]] PlanDecision decide(std::uint32_t sequence, const NetworkState& network) noexcept {
    namespace mode = network_state::mode;
    if (published_sequence_ != 0) {
      if (network.accepted_sequence == published_sequence_) {
        accepted_stance_ = published_stance_;
        if (published_sequence_ + 1 != sequence) broken_ = true;  // cycles were missed: its tail has begun
      } else {
        broken_ = true;
      }
      published_sequence_ = 0;
    } else {
      broken_ = true;  // the cycle before had no plan
    }
    if (network.mode == mode::safe_tail || network.mode == mode::emergency_stop) broken_ = true;
    if (!broken_)
      return PlanDecision::resume;  // also when holding: the first batch is accepted but not begun
    return network.mode == mode::holding ? PlanDecision::begin_anew : PlanDecision::wait;
  }

  // final_stance: where the safe tail of that plan ends, the middle between the feet.
  void published(std::uint32_t sequence, const Pose2& final_stance) noexcept {
    published_sequence_ = sequence;
    published_stance_ = final_stance;
    broken_ = false;
  }

  // Where the tail of the last accepted batch ends; the origin when there was none.
  [[nodiscard]] const Pose2& restart_stance() const noexcept { return accepted_stance_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.published_sequence_, self.published_stance_, self.accepted_stance_, self.broken_);
  }

 private:
  std::uint32_t published_sequence_ = 0;  // 0: none, or its fate is settled
  Pose2 published_stance_, accepted_stance_;
  bool broken_ = true;  // the next plan must begin from the stand
};

}  // namespace gaitway::trajectory
