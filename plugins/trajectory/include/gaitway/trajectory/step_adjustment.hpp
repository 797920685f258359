// What a step does about a body that is not where the plan has it: by how much its landing place moves, and
// how much of the deviation the plan takes over.
#pragma once

#include <Eigen/Core>

#include "gaitway/trajectory/gait_parameters.hpp"

namespace gaitway::trajectory {

// The divergent component of motion (DCM) ξ leaves the ZMP p with ξ̇ = ω (ξ − p): a deviation e of it has
// grown to e·e^(ωt) when the next foot takes over the load, in the time t. A landing place that has moved by
// as much puts the ZMP back under the body, and the walk goes on from there (step adjustment by the DCM:
// Englsberger et al., T-RO 2015; Khadiv et al., Humanoids 2016). All vectors are in the frame of the stance
// foot, m.
class StepAdjustment {
 public:
  StepAdjustment(const GaitParameters& parameters, double omega_per_s) noexcept;

  // Of a deviation, what is beyond the thresholds: the rest is left to the trims and to the feet's own edges.
  [[nodiscard]] Eigen::Vector2d excess_m(const Eigen::Vector2d& deviation_m) const noexcept;

  // By how much a landing `landing_s` from now is to move so that nothing of a deviation is left.
  [[nodiscard]] Eigen::Vector2d full_shift_m(const Eigen::Vector2d& deviation_m,
                                             double landing_s) const noexcept {
    return deviation_m / decay(landing_s);
  }

  // By how much the landing is to move for it, `landing_s` before the foot lands: the chosen share of the
  // full adjustment, and no more than the swing foot gets there. Not yet limited by where a foot may land.
  [[nodiscard]] Eigen::Vector2d shift_m(const Eigen::Vector2d& excess_m, double landing_s,
                                        double swing_left_s) const noexcept;

  // The part of the deviation that a landing moved by `shift_m` answers: by it, the plan's DCM moves to the
  // body's. What no step answers stays a deviation.
  [[nodiscard]] Eigen::Vector2d answered_m(const Eigen::Vector2d& shift_m, double landing_s) const noexcept {
    return decay(landing_s) * shift_m;
  }

 private:
  [[nodiscard]] double decay(double landing_s) const noexcept;

  Eigen::Vector2d threshold_m_;
  double share_, swing_speed_m_per_s_, omega_per_s_, half_double_support_s_;
};

}  // namespace gaitway::trajectory
