// The plan that the walking pattern writes: the batch, its footsteps and its safe tail.
#include <cmath>

#include "gaitway/trajectory/walking_pattern.hpp"

namespace gaitway::trajectory {
namespace {

constexpr std::int64_t kPointPeriod_ns = 10'000'000;
constexpr auto kBatch = static_cast<int>(kBatchPoints);

}  // namespace

void WalkingPattern::plan(std::uint32_t sequence, std::int64_t start_ns, const WalkCommand& command,
                          const Correction& correction, MotionPlan& plan,
                          const Eigen::Vector2d& dcm_deviation_m) noexcept {
  applied_ = StepLimit::none;
  plan.sequence = sequence;
  plan.start_ns = start_ns;
  plan.motion = 0;
  Eigen::Vector2d deviation_m = dcm_deviation_m;
  if (must_recover(state_, deviation_m)) {
    begin_recovery(state_, deviation_m);
    deviation_m.setZero();  // it is the plan's now
  }
  Velocity2 wanted{command.velocity[0], command.velocity[1], command.turn_rate};
  const bool finite = std::isfinite(wanted.forward_m_per_s) && std::isfinite(wanted.left_m_per_s) &&
                      std::isfinite(wanted.turn_rad_per_s);
  if (command.walk != 0 && finite && !must_finish_stop(state_)) {
    const double commanded_turn_rad_per_s = wanted.turn_rad_per_s;
    if (std::isfinite(correction.turn_rate_offset)) wanted.turn_rad_per_s += correction.turn_rate_offset;
    if (std::isfinite(correction.velocity_offset[0] + correction.velocity_offset[1])) {
      wanted.forward_m_per_s += correction.velocity_offset[0];
      wanted.left_m_per_s += correction.velocity_offset[1];
    }
    Eigen::Vector2d offset_m(correction.step_offset[0], correction.step_offset[1]);
    if (!offset_m.allFinite()) offset_m.setZero();
    schedule_walk(state_, {wanted, commanded_turn_rad_per_s}, offset_m, deviation_m);
  } else if (state_.recovery_steps > 0) {
    schedule_walk(state_, {}, Eigen::Vector2d::Zero(), deviation_m);
  } else {
    schedule_stop(state_);
  }
  fill_reference(state_, kBatch + parameters_.preview_points(), batch_reference_);
  write_footsteps(state_, plan);
  for (int i = 0; i < kBatch; ++i) {
    advance(state_, batch_reference_, i);
    write_point(state_, static_cast<std::size_t>(i), plan);
  }
  write_tail(plan);
}

// Until the stand is reached, in whole batches; one batch at least.
void WalkingPattern::write_tail(MotionPlan& plan) noexcept {
  tail_state_ = state_;
  schedule_stop(tail_state_);
  fill_reference(tail_state_, ZmpReference::kCapacity - 1, tail_reference_);
  int count = 0;
  do {
    for (int i = 0; i < kBatch; ++i, ++count) {
      advance(tail_state_, tail_reference_, count);
      write_point(tail_state_, static_cast<std::size_t>(kBatch) + static_cast<std::size_t>(count), plan);
    }
  } while (tail_state_.phase != Phase::stand && count + kBatch <= static_cast<int>(kMaxTailPoints));
  plan.tail_count = static_cast<std::uint32_t>(count);
  final_stance_ = middle_of(tail_state_.feet);
}

void WalkingPattern::write_point(const PatternState& state, std::size_t i, MotionPlan& plan) const noexcept {
  const bool in_the_air =
      state.phase == Phase::walking && state.elapsed_points > state.step.double_support_points;
  Eigen::RowVector2d zmp = controller_.zmp(state.cart);
  if (in_the_air) zmp += swing_zmp_m(state.swing, state.elapsed_points - state.step.double_support_points);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto column = static_cast<Eigen::Index>(axis);
    plan.com[i][axis] = state.cart.motion(0, column);
    plan.com_velocity[i][axis] = state.cart.motion(1, column);
    plan.zmp[i][axis] = zmp(column);
    plan.trunk_attitude[i][axis] = 0.0;
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const Pose2& foot = state.feet[side];
    plan.foot_position[i][side][0] = foot.x_m;
    plan.foot_position[i][side][1] = foot.y_m;
    plan.foot_position[i][side][2] = state.foot_height_m[side];
    plan.foot_yaw[i][side] = foot.yaw_rad;
  }
  plan.hip_height[i] = state.hips.height_m();
  plan.base_yaw[i] = 0.5 * (state.feet[0].yaw_rad + state.feet[1].yaw_rad);
  plan.commanded_yaw[i] = plan.base_yaw[i] - yaw_correction_rad(state);
  plan.support[i] = in_the_air ? static_cast<std::uint8_t>(other(state.step.swing)) : std::uint8_t{2};
}

void WalkingPattern::write_footsteps(const PatternState& state, MotionPlan& plan) const noexcept {
  plan.footstep_count = 0;
  if (state.phase != Phase::walking) return;
  int points = -state.elapsed_points;
  for (int i = -1; i < schedule_.count && plan.footstep_count < kMaxFootsteps; ++i) {
    const Step& step = i < 0 ? state.step : schedule_.steps[static_cast<std::size_t>(i)];
    points += step.points();
    const std::size_t k = plan.footstep_count++;
    plan.footstep_side[k] = static_cast<std::uint32_t>(step.swing);
    plan.footstep[k][0] = step.landing.x_m;
    plan.footstep[k][1] = step.landing.y_m;
    plan.footstep[k][2] = step.landing.yaw_rad;
    plan.footstep_landing_ns[k] = plan.start_ns + points * kPointPeriod_ns;
  }
}

}  // namespace gaitway::trajectory
