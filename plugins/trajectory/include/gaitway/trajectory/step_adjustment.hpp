// What a step does about a body that is not where the plan has it: where and when it lands instead, and how
// much of the deviation the plan takes over.
#pragma once

#include <Eigen/Core>

#include "gaitway/trajectory/gait_parameters.hpp"

namespace gaitway::trajectory {

// The step in flight as it is planned. All vectors are in the frame of the stance foot, m.
struct StepInFlight {
  int points = 0;                          // from now to the landing
  int fewest_points = 0, most_points = 0;  // which the swing foot can do it in
  int swing_points = 0;                    // of `points`, those in which the foot is in the air
  Eigen::Vector2d landing_dcm = Eigen::Vector2d::Zero();  // at the landing, from the stance foot's ZMP
  // How far the landing may move at most, by the limits of footsteps.
  Eigen::Vector2d lowest_shift = Eigen::Vector2d::Zero(), highest_shift = Eigen::Vector2d::Zero();
};

// What becomes of it.
struct StepAnswer {
  int points = 0;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();     // of the landing place
  Eigen::Vector2d answered = Eigen::Vector2d::Zero();  // by which the plan's DCM moves now, to the body's
};

// The divergent component of motion (DCM) ξ leaves the ZMP p with ξ̇ = ω (ξ − p): a deviation e of it has
// grown to e·e^(ωt) when the next foot takes over the load, in the time t. A landing place that has moved by
// as much puts the ZMP back under the body, and the walk goes on from there; so does, along the way that the
// DCM goes anyway, a landing that comes sooner or later (step adjustment by the DCM: Englsberger et al., T-RO
// 2015; of place and time: Khadiv et al., Humanoids 2016).
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

  // The part of a deviation that a landing moved by `shift_m` answers.
  [[nodiscard]] Eigen::Vector2d answered_m(const Eigen::Vector2d& shift_m, double landing_s) const noexcept {
    return decay(landing_s) * shift_m;
  }

  // The landing that leaves the least: of all the times that the foot can do it in, the one for which the
  // deviation left at the landing, the shift and the change of time together cost least. What no step
  // answers stays a deviation.
  [[nodiscard]] StepAnswer answer(const Eigen::Vector2d& excess_m, const StepInFlight& step) const noexcept;

 private:
  [[nodiscard]] double decay(double landing_s) const noexcept;

  Eigen::Vector2d threshold_m_, swing_speed_m_per_s_;
  double share_, time_cost_m_per_s_, omega_per_s_, half_double_support_s_;
};

}  // namespace gaitway::trajectory
