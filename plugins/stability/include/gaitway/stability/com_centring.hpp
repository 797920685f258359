// Brings the CoM of a standing robot to where it is planned.
#pragma once

#include <Eigen/Core>

#include "gaitway/stability/balance_parameters.hpp"

namespace gaitway::stability {

// A trunk that is heavier in front than its description says, and joints whose zeros are wrong, leave the CoM
// a centimetre off its place: a sixth of the way to the toes. The estimate learns that from the force cells;
// while the robot stands calmly, the CoM is brought to where the plan has it, and what that takes is added to
// all batches, also in the walk that follows.
class ComCentring {
 public:
  explicit ComCentring(const BalanceParameters& parameters) noexcept : parameters_(parameters) {}

  // One tick of a calm stand on both feet: the estimated CoM and DCM less the planned CoM, base axes.
  // Learns nothing while the body is being caught, and from what is not finite.
  void learn(const Eigen::Vector2d& com_error_m, const Eigen::Vector2d& dcm_error_m) noexcept;

  // To add to the planned CoM, base axes.
  [[nodiscard]] const Eigen::Vector2d& offset_m() const noexcept { return offset_m_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.offset_m_);
  }

 private:
  const BalanceParameters& parameters_;
  Eigen::Vector2d offset_m_ = Eigen::Vector2d::Zero();
};

}  // namespace gaitway::stability
