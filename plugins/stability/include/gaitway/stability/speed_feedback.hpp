// Keeps the robot's speed at what was commanded: it walks somewhat faster than its plan says, since the
// ankles' trims carry the body on over the stance foot.
#pragma once

#include <Eigen/Core>

#include "gaitway/stability/balance_parameters.hpp"

namespace gaitway::stability {

// The plan contains the offset, so planned minus measured speed, averaged over some steps, is by how much the
// robot goes slower than it is told: that is what the command must be raised by.
class SpeedFeedback {
 public:
  explicit SpeedFeedback(const BalanceParameters& parameters) noexcept : parameters_(parameters) {}

  // One tick; CoM velocities forward and left of the base, of the plan at this time and estimated. Returns
  // the offset of the commanded velocity; while the robot does not walk it fades.
  Eigen::Vector2d update(const Eigen::Vector2d& planned_m_per_s, const Eigen::Vector2d& estimated_m_per_s,
                         bool walking) noexcept;
  void pause() noexcept { update(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), false); }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.offset_m_per_s_);
  }

 private:
  const BalanceParameters& parameters_;
  Eigen::Vector2d offset_m_per_s_ = Eigen::Vector2d::Zero();
};

}  // namespace gaitway::stability
