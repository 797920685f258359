// Where the joints' references are when the next batch begins: on the batch that was accepted last, or on its
// safe tail.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/fall_posture.hpp"

namespace gaitway::trajectory {

class AcceptedReferences {
 public:
  // Once a batch, with the newest joint plan: it is kept if it is the one that was accepted. 5 us.
  void take(const JointPlan& newest, std::uint32_t accepted_sequence) noexcept {
    if (newest.sequence != 0 && newest.sequence == accepted_sequence) accepted_ = newest;
  }
  // At the two points before the batch of that sequence; nothing: the accepted plan is not known. Valid until
  // the next call.
  [[nodiscard]] std::optional<FallPosture::References> before(std::uint32_t sequence) noexcept;

 private:
  JointPlan accepted_{};
  std::array<double, kMaxJoints> before_rad_{}, at_rad_{};
};

}  // namespace gaitway::trajectory
