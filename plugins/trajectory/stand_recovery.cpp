// Where the DCM is against the soles, and the first step after it.
#include "gaitway/trajectory/stand_recovery.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/flight_adjuster.hpp"

namespace gaitway::trajectory {

bool StandRecovery::must_step(const PatternState& state, const Eigen::Vector2d& dcm_deviation_m,
                              double bow_rad, const DivergenceAbsorber& absorber) const noexcept {
  if (state.phase == Phase::walking || dcm_deviation_m.isZero()) return false;
  const Pose2 middle = middle_of(state.feet);
  const Eigen::Vector2d dcm = absorber.divergence(state.cart).transpose() + dcm_deviation_m;
  const Pose2 seen = middle.relative_of({dcm.x(), dcm.y(), 0.0});
  const Sole& sole = parameters_.sole;
  const Pose2 left = middle.relative_of(state.feet[0]);
  const double from_middle_m = seen.x_m - sole.centre_forward_m;
  const bool ahead = from_middle_m > 0.0;
  const double caught_m =
      (ahead ? parameters_.recover_ahead_m : parameters_.recover_behind_m) -
      (ahead ? parameters_.recover_bow_ahead_m_per_rad : parameters_.recover_bow_behind_m_per_rad) *
          std::abs(bow_rad);
  const double along = std::abs(from_middle_m) - 0.5 * sole.length_m - caught_m;
  const double aside = std::abs(seen.y_m) - (std::abs(left.y_m) + 0.5 * sole.width_m);
  return std::max(along, aside) > 0.0;
}

double StandRecovery::side_to_step_to(const PatternState& state,
                                      const Eigen::Vector2d& dcm_deviation_m) const noexcept {
  return (Eigen::Rotation2Dd(-middle_of(state.feet).yaw_rad) * dcm_deviation_m).y();
}

// The step is as wide as the fall to its side asks for.
void StandRecovery::take_over(PatternState& state, StepSchedule& schedule, const WalkReference& walk,
                              const Eigen::Vector2d& dcm_deviation_m, double bow_rad,
                              ZmpReference& reference) const noexcept {
  const DivergenceAbsorber& absorber = walk.absorber();
  const FootstepPlanner& planner = schedule.planner();
  state.recovery_steps = kRecoverySteps;
  Step& step = state.step;
  step.double_support_points = parameters_.recover_lead_in_points();
  step.swing_points = parameters_.recover_swing_points();
  step.landing = planner.beside(step.stance, step.swing);
  schedule.walk_after(step, 0, {}, Eigen::Vector2d::Zero());
  walk.lay_out(state, schedule, static_cast<int>(kBatchPoints) + parameters_.preview_points(), reference);

  const Eigen::RowVector2d dcm = absorber.divergence(state.cart) + dcm_deviation_m.transpose();
  const Eigen::RowVector2d asked = absorber.required_divergence(reference, 0);
  const Eigen::Rotation2Dd to_plan(step.stance.yaw_rad);
  const Eigen::Vector2d gap = to_plan.inverse() * (dcm - asked).transpose();
  const double landing_s = step.points() * facts::kSlot_s;
  Eigen::Vector2d shift = adjustment_.full_shift_m(gap, landing_s);
  shift.x() = parameters_.limit_recovery_m(shift.x());
  step.landing = planner.adjusted_landing(step.stance, step.swing, {}, {}, shift);
  step.adjustment_m = step.stance.relative_of(step.landing).position() -
                      step.stance.relative_of(planner.beside(step.stance, step.swing)).position();
  state.hips.aim(hip_height_m(step, bow_rad), step.points());
  const Eigen::RowVector2d taken =
      asked + (to_plan * adjustment_.answered_m(step.adjustment_m, landing_s)).transpose();
  state.cart.motion.row(1) += absorber.omega_per_s() * (taken - absorber.divergence(state.cart));
  state.divergence = taken;
}

// The CoM gets half way to the landing place meanwhile; a bow to the same side leaves the hips behind it.
// With one to the other side, the stance leg is as long at the end as the swing leg without.
double StandRecovery::hip_height_m(const Step& step, double bow_rad) const noexcept {
  const double ahead_m = step.adjustment_m.x();
  const double hips_behind_m =
      bow_rad * ahead_m > 0.0 ? parameters_.hips_in_bow_m_per_rad * std::abs(bow_rad) : 0.0;
  const double reach_m = 0.5 * std::abs(ahead_m) + hips_behind_m;
  return parameters_.hip_height_m - parameters_.recover_crouch * reach_m;
}

}  // namespace gaitway::trajectory
