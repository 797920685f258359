// Decides at each batch whether the plan goes on, waits, or begins anew from the stand, by what became of the
// batches handed over before.
#pragma once

#include <cstdint>

#include "gaitway/trajectory/footstep_planner.hpp"

namespace gaitway::trajectory {

// Values of NetworkState::mode.
enum class NetworkMode : std::uint32_t { batches = 0, safe_tail = 1, holding = 2, emergency = 3 };

enum class PlanDecision : std::uint8_t {
  wait,        // publish no plan: the robot plays a tail, or is in an emergency stop
  resume,      // plan on from the last batch
  begin_anew,  // reset the pattern to the stand at restart_stance(), then plan
};

// Order of calls in a batch tick: decide(), then, if a plan was made, published().
class PlanContinuity {
 public:
  // sequence: of the batch to be planned. accepted_sequence: the newest that the message controller accepted;
  // the batch published one cycle before must be among them, else the safe tail of an older one is about to
  // play.
  [[nodiscard]] PlanDecision decide(std::uint32_t sequence, NetworkMode mode,
                                    std::uint32_t accepted_sequence) noexcept;

  // final_stance: where the safe tail of that plan ends, the middle between the feet.
  void published(std::uint32_t sequence, const Pose2& final_stance) noexcept;

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
