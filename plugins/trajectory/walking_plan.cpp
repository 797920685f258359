// The plan that the walking pattern writes: the batch, its footsteps and its safe tail.
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"

namespace gaitway::trajectory {
namespace {

constexpr auto kBatch = static_cast<int>(kBatchPoints);
constexpr int kShortestTail = 6 * kBatch;

}  // namespace

void WalkingPattern::plan(std::uint32_t sequence, std::int64_t start_ns, const WalkCommand& command,
                          const Correction& correction, MotionPlan& plan,
                          const Eigen::Vector2d& dcm_deviation_m) noexcept {
  plan.sequence = sequence;
  plan.start_ns = start_ns;
  plan.motion = 0;
  schedule(command, correction, dcm_deviation_m);
  write_batch(0, plan);
  write_tail(plan);
  revisable_sequence_ = first_revised_ > 0 ? sequence : 0;
}

bool WalkingPattern::revise(const WalkCommand& command, const Correction& correction, MotionPlan& plan,
                            const Eigen::Vector2d& dcm_deviation_m) noexcept {
  if (revisable_sequence_ == 0 || plan.sequence != revisable_sequence_ || plan.motion != 0) return false;
  revisable_sequence_ = 0;
  unrevised_state_ = state_;
  unrevised_final_stance_ = final_stance_;
  state_ = revisable_state_;
  schedule(command, correction, dcm_deviation_m);
  write_batch(first_revised_, plan);
  write_tail(plan);
  return true;
}

void WalkingPattern::take_revision_back() noexcept {
  state_ = unrevised_state_;
  final_stance_ = unrevised_final_stance_;
}

void WalkingPattern::schedule(const WalkCommand& command, const Correction& correction,
                              const Eigen::Vector2d& dcm_deviation_m) noexcept {
  applied_ = StepLimit::none;
  const Eigen::RowVector2d before = absorber_.divergence(state_.cart);
  Eigen::Vector2d deviation_m = dcm_deviation_m;
  const double bow_rad = std::isfinite(correction.bow[1]) ? correction.bow[1] : 0.0;
  if (must_recover(state_, deviation_m, bow_rad)) {
    begin_recovery(state_, deviation_m, bow_rad);
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
    if (adjust_step(state_, deviation_m)) schedule_stop(state_);
  }
  answered_m_ = (absorber_.divergence(state_.cart) - before).transpose();
}

void WalkingPattern::write_batch(int first, MotionPlan& plan) noexcept {
  const int points = kBatch - first;
  fill_reference(state_, points + parameters_.preview_points(), batch_reference_);
  write_footsteps(state_, first, plan);
  for (int i = 0; i < points; ++i) {
    if (first == 0 && i > 0 && i == first_revised_) {
      revisable_state_ = state_;
      pass(revisable_state_, batch_reference_, i);
    }
    advance(state_, batch_reference_, i);
    write_point(state_, static_cast<std::size_t>(first) + static_cast<std::size_t>(i), plan);
  }
  pass(state_, batch_reference_, points);
}

// Until the stand is reached, in whole batches, and long enough for a bow to end in it.
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
  } while ((tail_state_.phase != Phase::stand || count < kShortestTail) &&
           count + kBatch <= static_cast<int>(kMaxTailPoints));
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

void WalkingPattern::write_footsteps(const PatternState& state, int first, MotionPlan& plan) const noexcept {
  plan.footstep_count = 0;
  if (state.phase != Phase::walking) return;
  int points = first - state.elapsed_points;
  for (int i = -1; i < schedule_.count && plan.footstep_count < kMaxFootsteps; ++i) {
    const Step& step = i < 0 ? state.step : schedule_.steps[static_cast<std::size_t>(i)];
    points += step.points();
    const std::size_t k = plan.footstep_count++;
    plan.footstep_side[k] = static_cast<std::uint32_t>(step.swing);
    plan.footstep[k][0] = step.landing.x_m;
    plan.footstep[k][1] = step.landing.y_m;
    plan.footstep[k][2] = step.landing.yaw_rad;
    plan.footstep_landing_ns[k] = plan.start_ns + points * facts::kSlot_ns;
  }
}

}  // namespace gaitway::trajectory
