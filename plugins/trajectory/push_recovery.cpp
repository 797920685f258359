// The limits of the step in flight and what its answer changes; where the DCM of a stand is against the
// soles.
#include "gaitway/trajectory/push_recovery.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::trajectory {

StepInFlight PushRecovery::step_in_flight(const PatternState& state, const StepSchedule& schedule,
                                          const DivergenceAbsorber& absorber,
                                          const ZmpReference& reference) const noexcept {
  const Step& step = state.step;
  const Eigen::Rotation2Dd to_stance(-step.stance.yaw_rad);
  StepInFlight flight;
  flight.points = step.points() - state.elapsed_points;
  flight.swing_points = step.swing_points - std::max(state.swing_points_done(), 0);
  const double remaining_share = 1.0 - state.swing_share();
  const auto points_in = [&](double swing_s) {
    return flight.points - flight.swing_points +
           static_cast<int>(std::lround(remaining_share * swing_s / facts::kSlot_s));
  };
  flight.fewest_points = std::min(flight.points, points_in(parameters_.adjust_shortest_swing_s));
  flight.most_points = std::max(flight.points, points_in(parameters_.adjust_longest_swing_s));
  flight.landing_dcm =
      to_stance * (absorber.required_divergence(reference, flight.points) - step.zmp_to).transpose();
  const auto landing_moved = [&](double by_m) {
    Eigen::Vector2d moved = step.adjustment_m.array() + by_m;
    if (state.recovery_steps == kRecoverySteps) moved.x() = parameters_.limit_recovery_m(moved.x());
    const Pose2 landing = schedule.adjusted_landing(step, moved);
    return Eigen::Vector2d(step.stance.relative_of(landing).position() -
                           step.stance.relative_of(step.landing).position());
  };
  constexpr double kFar_m = 10.0;
  flight.lowest_shift = landing_moved(-kFar_m);
  flight.highest_shift = landing_moved(kFar_m);
  return flight;
}

// The plan's DCM moves to the body's by a change of the CoM's velocity: its place stays, and goes over to
// where the body is within 1/ω.
bool PushRecovery::adjust(PatternState& state, const StepSchedule& schedule, const WalkReference& walk,
                          const Eigen::Vector2d& dcm_deviation_m, ZmpReference& reference) const noexcept {
  if (state.phase != Phase::walking) return false;
  Step& step = state.step;
  const Eigen::Rotation2Dd to_plan(step.stance.yaw_rad);
  const Eigen::Vector2d excess = adjustment_.excess_m(to_plan.inverse() * dcm_deviation_m);
  if (excess.isZero() || state.swing_share() >= parameters_.adjust_until_share) return false;
  walk.lay_out(state, schedule, static_cast<int>(kBatchPoints) + parameters_.preview_points(), reference);
  const StepAnswer answer =
      adjustment_.answer(excess, step_in_flight(state, schedule, walk.absorber(), reference));
  step.swing_points += answer.points - (step.points() - state.elapsed_points);
  step.adjustment_m += answer.shift;
  const Pose2 shifted = step.stance.relative_of(step.landing);
  step.landing =
      step.stance.compose({shifted.x_m + answer.shift.x(), shifted.y_m + answer.shift.y(), shifted.yaw_rad});
  state.aim_swing();
  const Eigen::RowVector2d answered = (to_plan * answer.answered).transpose();
  state.cart.motion.row(1) += walk.absorber().omega_per_s() * answered;
  state.divergence += answered;
  return true;
}

bool PushRecovery::must_step(const PatternState& state, const Eigen::Vector2d& dcm_deviation_m,
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

double PushRecovery::side_to_step_to(const PatternState& state,
                                     const Eigen::Vector2d& dcm_deviation_m) const noexcept {
  return (Eigen::Rotation2Dd(-middle_of(state.feet).yaw_rad) * dcm_deviation_m).y();
}

// The step is as wide as the fall to its side asks for.
void PushRecovery::take_over(PatternState& state, StepSchedule& schedule, const WalkReference& walk,
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
double PushRecovery::hip_height_m(const Step& step, double bow_rad) const noexcept {
  const double ahead_m = step.adjustment_m.x();
  const double hips_behind_m =
      bow_rad * ahead_m > 0.0 ? parameters_.hips_in_bow_m_per_rad * std::abs(bow_rad) : 0.0;
  const double reach_m = 0.5 * std::abs(ahead_m) + hips_behind_m;
  return parameters_.hip_height_m - parameters_.recover_crouch * reach_m;
}

}  // namespace gaitway::trajectory
