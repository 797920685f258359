// The state machine of stand, steps and settling, and the plan that it writes: batch, footsteps, safe tail.
#include "gaitway/trajectory/walking_pattern.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::trajectory {
namespace {

constexpr double kSameHeight_m = 1e-4;
constexpr auto kBatch = static_cast<int>(kBatchPoints);
constexpr int kShortestTail = 6 * kBatch;

GaitParameters checked(GaitParameters parameters) {
  parameters.validate();
  parameters.step_time_s = parameters.step_points() * facts::kSlot_s;
  return parameters;
}

PreviewParameters preview_of(const GaitParameters& parameters) {
  return {parameters.com_height_m, facts::kSlot_s, parameters.preview_points(), parameters.zmp_error_weight,
          parameters.jerk_weight};
}

// The last step has begun: the CoM is on its way to rest, and to walk on would throw the ZMP off the foot.
// The walk begins anew while the robot settles.
bool must_finish_stop(const PatternState& state) noexcept {
  return state.phase == Phase::walking && state.step.last;
}

// The foot towards which the robot is to move steps first, else the left one.
Side first_swing(const Velocity2& wanted) noexcept {
  const double direction = wanted.left_m_per_s != 0.0 ? wanted.left_m_per_s : wanted.turn_rad_per_s;
  return direction < 0.0 ? Side::right : Side::left;
}

}  // namespace

WalkingPattern::WalkingPattern(const GaitParameters& parameters)
    : parameters_(checked(parameters)),
      controller_(preview_of(parameters_)),
      schedule_(parameters_),
      walk_(parameters_),
      recovery_(parameters_, walk_.absorber().omega_per_s()) {
  reset_to_stand({});
}

void WalkingPattern::tune(const GaitParameters& changed) noexcept {
  parameters_.tune(changed);
  schedule_.tune(parameters_);
  recovery_ = PushRecovery(parameters_, walk_.absorber().omega_per_s());
}

void WalkingPattern::reset_to_stand(const Pose2& middle) noexcept {
  const std::uint32_t landed = state_.landed;
  state_ = PatternState{};
  state_.landed = landed;
  const double half = 0.5 * parameters_.foot_spacing_m;
  state_.feet = {middle.compose({0.0, half, 0.0}), middle.compose({0.0, -half, 0.0})};
  state_.cart.motion.row(0) = walk_.stand_com(state_.feet);
  state_.hips = HipHeight(parameters_.hip_height_m);
  final_stance_ = middle;
  batch_reference_.count = 0;
}

void WalkingPattern::plan(std::uint32_t sequence, std::int64_t start_ns, const WalkCommand& command,
                          const Correction& correction, MotionPlan& plan,
                          const Eigen::Vector2d& dcm_deviation_m, const PlannedSteps& steps) noexcept {
  plan.sequence = sequence;
  plan.start_ns = start_ns;
  plan.motion = 0;
  plan.arm_swing = parameters_.arm_swing_rad_per_m;
  plan.toe_up = parameters_.toe_up_rad_per_m;
  schedule(command, correction, dcm_deviation_m, steps);
  write_batch(plan);
  write_tail(plan);
}

void WalkingPattern::schedule(const WalkCommand& command, const Correction& correction,
                              const Eigen::Vector2d& dcm_deviation_m, const PlannedSteps& steps) noexcept {
  schedule_.forget_limits();
  const Eigen::RowVector2d before = walk_.absorber().divergence(state_.cart);
  Eigen::Vector2d deviation_m = dcm_deviation_m;
  const double bow_rad = std::isfinite(correction.bow[1]) ? correction.bow[1] : 0.0;
  if (recovery_.must_step(state_, deviation_m, bow_rad, walk_.absorber())) {
    begin_walking(state_, first_swing({0.0, recovery_.side_to_step_to(state_, deviation_m), 0.0}));
    recovery_.take_over(state_, schedule_, walk_, deviation_m, bow_rad, batch_reference_);
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
  } else if (command.walk == 0 && steps.count > 0 && !must_finish_stop(state_)) {
    schedule_planned(state_, steps, deviation_m);
  } else {
    stop(deviation_m);
  }
  answered_m_ = (walk_.absorber().divergence(state_.cart) - before).transpose();
}

bool WalkingPattern::is_open(const PatternState& state) const noexcept {
  return state.elapsed_points < state.step.double_support_points ||
         state.swing_share() < parameters_.freeze_share;
}

void WalkingPattern::stop(const Eigen::Vector2d& dcm_deviation_m) noexcept {
  schedule_stop(state_);
  if (recovery_.adjust(state_, schedule_, walk_, dcm_deviation_m, batch_reference_)) schedule_stop(state_);
}

// A step that the balance has moved stays where it is; those after it are the plan's again, if they are in
// reach of it.
void WalkingPattern::schedule_planned(PatternState& state, const PlannedSteps& steps,
                                      const Eigen::Vector2d& dcm_deviation_m) noexcept {
  const bool begins = state.phase != Phase::walking;
  const std::uint32_t number = begins ? steps.next_after(state.landed) : state.step.number;
  const PlannedSteps::Place* const place = steps.find(number);
  const Pose2& stance =
      begins && place != nullptr ? state.feet[index_of(other(place->side))] : state.step.stance;
  if (begins && steps.is_last(number) &&
      schedule_.planner().is_beside(stance, place->side, state.feet[index_of(place->side)])) {
    state.landed = number;  // a stop has brought the feet together already
  }
  if (number == 0 || state.landed == number || (begins && !schedule_.is_in_reach(stance, steps, number))) {
    stop(dcm_deviation_m);
    return;
  }
  if (begins) begin_walking(state, place->side);
  Step& step = state.step;
  step.number = number;
  if (is_open(state) && step.adjustment_m.isZero() && place != nullptr && place->side == step.swing) {
    schedule_.place(step, steps, state.yaw_correction_rad[index_of(other(step.swing))]);
    state.aim_swing();
  }
  aim_hips(state, parameters_.hip_height_at_m(std::abs(step.velocity.forward_m_per_s)));
  schedule_.follow_after(step, state.elapsed_points, steps);
  if (recovery_.adjust(state, schedule_, walk_, dcm_deviation_m, batch_reference_))
    schedule_.follow_after(step, state.elapsed_points, steps);
}

// The first step.
void WalkingPattern::begin_walking(PatternState& state, Side swing) noexcept {
  Step step;
  step.swing = swing;
  step.double_support_points = parameters_.lead_in_points();
  step.swing_points = parameters_.swing_points();
  step.lead_in = true;
  step.stance = state.feet[index_of(other(step.swing))];
  step.lift = state.feet[index_of(step.swing)];
  step.zmp_from = controller_.zmp(state.cart);
  step.zmp_to = schedule_.stance_zmp(other(step.swing), step.stance);
  state.step = step;
  state.phase = Phase::walking;
  state.elapsed_points = 0;
  state.cart.error_sum.setZero();
  state.yaw_correction_rad = {};
  state.zmp_offset = {};
  state.divergence = walk_.absorber().divergence(state.cart);
}

// The CoM comes to rest above the stand's point by least jerk; exactly, in a fixed time.
void WalkingPattern::begin_settling(PatternState& state) const noexcept {
  const Eigen::RowVector2d end = walk_.stand_com(state.feet);
  const auto& now = state.cart.motion;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    state.settle[static_cast<std::size_t>(axis)] =
        Quintic({now(0, axis), now(1, axis), now(2, axis)}, {end(axis)},
                parameters_.settle_points() * facts::kSlot_s);
  }
  state.phase = Phase::settling;
  state.elapsed_points = 0;
  aim_hips(state, parameters_.hip_height_m);
}

// It takes as long as the settling, so that every stop ends at the stand's height.
void WalkingPattern::aim_hips(PatternState& state, double goal_m) const noexcept {
  const bool same = goal_m == state.hips.goal_m();
  const bool about_the_same = std::abs(goal_m - state.hips.goal_m()) < kSameHeight_m;
  if (same || (about_the_same && goal_m != parameters_.hip_height_m)) return;  // the stand's height is exact
  state.hips.aim(goal_m, parameters_.settle_points());
}

void WalkingPattern::schedule_walk(PatternState& state, const WantedWalk& wanted,
                                   const Eigen::Vector2d& offset_m,
                                   const Eigen::Vector2d& dcm_deviation_m) noexcept {
  if (state.phase != Phase::walking) begin_walking(state, first_swing(wanted.velocity));
  Step& step = state.step;
  Eigen::Vector2d remaining_offset_m = offset_m;
  if (is_open(state)) {
    schedule_.aim(step, wanted, offset_m);
    remaining_offset_m.setZero();
    state.aim_swing();
  }
  if (state.recovery_steps == 0) {
    aim_hips(state, parameters_.hip_height_at_m(std::max(std::abs(step.velocity.forward_m_per_s),
                                                         std::abs(wanted.velocity.forward_m_per_s))));
  }
  schedule_.walk_after(step, state.elapsed_points, wanted, remaining_offset_m);
  if (recovery_.adjust(state, schedule_, walk_, dcm_deviation_m, batch_reference_))
    schedule_.walk_after(step, state.elapsed_points, wanted, remaining_offset_m);
}

// Feet side by side settle at once.
void WalkingPattern::schedule_stop(PatternState& state) noexcept {
  const bool walks = state.phase == Phase::walking;
  if (walks && state.recovery_steps == 0) aim_hips(state, parameters_.hip_height_m);
  if (!schedule_.stop_after(state)) begin_settling(state);
}

void WalkingPattern::advance(PatternState& state, const ZmpReference& reference, int index) noexcept {
  state.hips.advance();
  if (state.phase == Phase::walking) {
    controller_.step(state.cart, reference, index);
    advance_step(state);
  } else if (state.phase == Phase::settling) {
    advance_settling(state);
  }
}

void WalkingPattern::advance_step(PatternState& state) noexcept {
  const Step& step = state.step;
  const std::size_t foot = index_of(step.swing);
  if (state.elapsed_points == step.double_support_points) {
    state.swing = SwingFoot(state.feet[foot], step.landing, step.swing_points * facts::kSlot_s,
                            parameters_.swing_flatness);
  }
  ++state.elapsed_points;
  const int in_swing = state.swing_points_done();
  if (in_swing <= 0) return;
  if (in_swing < step.swing_points) {
    state.feet[foot] = state.swing.at(in_swing * facts::kSlot_s);
    state.foot_height_m[foot] = swing_height_m(state.swing_share(), parameters_.lift_m);
    return;
  }
  if (state.recovery_steps > 0) --state.recovery_steps;
  if (step.number != 0) state.landed = step.number;
  state.feet[foot] = step.landing;
  state.yaw_correction_rad[foot] = state.landing_yaw_correction_rad(parameters_.step_time_s);
  state.foot_height_m[foot] = 0.0;
  if (const Step* const next = schedule_.begin_next()) {
    state.step = *next;
    state.elapsed_points = 0;
  } else {
    begin_settling(state);
  }
}

void WalkingPattern::advance_settling(PatternState& state) const noexcept {
  ++state.elapsed_points;
  if (state.elapsed_points >= parameters_.settle_points()) {
    state.cart = Cart{};
    state.cart.motion.row(0) = walk_.stand_com(state.feet);
    state.phase = Phase::stand;
    state.elapsed_points = 0;
    return;
  }
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const MotionState com =
        state.settle[static_cast<std::size_t>(axis)].at(state.elapsed_points * facts::kSlot_s);
    state.cart.motion.col(axis) << com.position, com.velocity, com.acceleration;
  }
}

void WalkingPattern::write_batch(MotionPlan& plan) noexcept {
  walk_.fill(state_, schedule_, kBatch + parameters_.preview_points(), batch_reference_);
  write_footsteps(plan);
  for (int i = 0; i < kBatch; ++i) {
    advance(state_, batch_reference_, i);
    write_point(state_, static_cast<std::size_t>(i), plan);
  }
  walk_.pass(state_, batch_reference_, kBatch);
}

// Until the stand is reached, in whole batches, and long enough for a bow to end in it.
void WalkingPattern::write_tail(MotionPlan& plan) noexcept {
  tail_state_ = state_;
  schedule_stop(tail_state_);
  walk_.fill(tail_state_, schedule_, ZmpReference::kCapacity - 1, tail_reference_);
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
  const bool in_the_air = state.phase == Phase::walking && state.swing_points_done() > 0;
  Eigen::RowVector2d zmp = controller_.zmp(state.cart);
  if (in_the_air) zmp += walk_.swing_zmp_m(state.swing, state.swing_points_done());
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
  plan.commanded_yaw[i] = plan.base_yaw[i] - state.base_yaw_correction_rad(parameters_.step_time_s);
  plan.support[i] = in_the_air ? static_cast<std::uint8_t>(other(state.step.swing)) : std::uint8_t{2};
}

void WalkingPattern::write_footsteps(MotionPlan& plan) const noexcept {
  plan.footstep_count = 0;
  if (state_.phase != Phase::walking) return;
  int points = -state_.elapsed_points;
  const auto write = [&](const Step& step) {
    if (plan.footstep_count == kMaxFootsteps) return;
    points += step.points();
    const std::size_t k = plan.footstep_count++;
    plan.footstep_side[k] = static_cast<std::uint32_t>(step.swing);
    plan.footstep[k][0] = step.landing.x_m;
    plan.footstep[k][1] = step.landing.y_m;
    plan.footstep[k][2] = step.landing.yaw_rad;
    plan.footstep_landing_ns[k] = plan.start_ns + points * facts::kSlot_ns;
  };
  write(state_.step);
  for (const Step& step : schedule_.steps()) write(step);
}

}  // namespace gaitway::trajectory
