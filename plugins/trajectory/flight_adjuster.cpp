// The limits of the step in flight, and what its answer changes.
#include "gaitway/trajectory/flight_adjuster.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::trajectory {

StepInFlight FlightAdjuster::step_in_flight(const PatternState& state, const FootstepPlanner& planner,
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
    const Pose2 landing =
        planner.adjusted_landing(step.stance, step.swing, step.velocity_before, step.velocity, moved);
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
bool FlightAdjuster::adjust(PatternState& state, const StepSchedule& schedule, const WalkReference& walk,
                            const Eigen::Vector2d& dcm_deviation_m, ZmpReference& reference) const noexcept {
  if (state.phase != Phase::walking) return false;
  Step& step = state.step;
  const Eigen::Rotation2Dd to_plan(step.stance.yaw_rad);
  const Eigen::Vector2d excess = adjustment_.excess_m(to_plan.inverse() * dcm_deviation_m);
  if (excess.isZero() || state.swing_share() >= parameters_.adjust_until_share) return false;
  walk.lay_out(state, schedule, static_cast<int>(kBatchPoints) + parameters_.preview_points(), reference);
  const StepAnswer answer =
      adjustment_.answer(excess, step_in_flight(state, schedule.planner(), walk.absorber(), reference));
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

}  // namespace gaitway::trajectory
