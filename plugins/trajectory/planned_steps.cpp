// Carries footsteps over the foot that stands, which both frames know.
#include "gaitway/trajectory/planned_steps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gaitway::trajectory {
namespace {

Pose2 measured(const Estimate& estimate, Side side) noexcept {
  const double* const foot = estimate.odometry_foot[index_of(side)];
  return {foot[0], foot[1], foot[2]};
}

Side stance_of(const PatternState& state, Side first_swing) noexcept {
  return other(state.phase == Phase::walking ? state.step.swing : first_swing);
}

Pose2 planned(const PatternState& state, Side stance) noexcept {
  return state.phase == Phase::walking ? state.step.stance : state.feet[index_of(stance)];
}

double wrapped(double angle_rad) noexcept {
  return std::remainder(angle_rad, 2.0 * std::numbers::pi);
}

bool is_valid(const FootstepPlan& plan, std::int64_t now_ns) noexcept {
  if (plan.first == 0 || plan.step_count == 0 || plan.step_count > kMaxPlannedSteps ||
      now_ns >= plan.valid_until_ns) {
    return false;
  }
  for (std::uint32_t i = 0; i < plan.step_count; ++i) {
    const double* const step = plan.step[i];
    if (plan.side[i] > 1 || (i > 0 && plan.side[i] == plan.side[i - 1]) ||
        !std::isfinite(step[0] + step[1] + step[2])) {
      return false;
    }
  }
  return true;
}

}  // namespace

PlannedSteps planned_steps(const FootstepPlan& plan, const Estimate& estimate, const PatternState& state,
                           std::int64_t now_ns) noexcept {
  PlannedSteps steps;
  if (!is_valid(plan, now_ns)) return steps;
  const Side stance = stance_of(state, static_cast<Side>(plan.side[0]));
  const Pose2 inside = planned(state, stance), outside = measured(estimate, stance);
  if (!std::isfinite(outside.x_m + outside.y_m + outside.yaw_rad)) return steps;
  steps.first = plan.first;
  steps.count = plan.step_count;
  steps.ends = plan.ends != 0;
  steps.yaw_correction_rad = wrapped(inside.yaw_rad - outside.yaw_rad);
  for (std::uint32_t i = 0; i < plan.step_count; ++i) {
    const double* const step = plan.step[i];
    const Pose2 local =
        outside.relative_of({step[0], step[1], outside.yaw_rad + wrapped(step[2] - outside.yaw_rad)});
    steps.place[i] = {static_cast<Side>(plan.side[i]), inside.compose(local)};
  }
  return steps;
}

bool describe(const PatternState& state, const Estimate& estimate, bool free, FootstepState& to) noexcept {
  namespace states = footstep_state::state;
  const bool walks = state.phase == Phase::walking;
  to.step = walks ? state.step.number : 0;
  to.landed = state.landed;
  to.state = !free                                       ? states::other
             : state.phase == Phase::stand               ? states::stands
             : to.step != 0 || !walks || state.step.last ? states::follows
                                                         : states::other;
  const Side stance = stance_of(state, Side::right);
  const Pose2 local = planned(state, stance).relative_of(walks ? state.step.landing : state.feet[0]);
  const Pose2 landing = measured(estimate, stance).compose(local);
  to.landing[0] = landing.x_m;
  to.landing[1] = landing.y_m;
  to.landing[2] = landing.yaw_rad;
  return std::isfinite(landing.x_m + landing.y_m + landing.yaw_rad);
}

}  // namespace gaitway::trajectory
