// The walking pattern's state machine: stand, steps, settling.
#include "gaitway/trajectory/walking_pattern.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::trajectory {
namespace {

constexpr double kSameHeight_m = 1e-4;
constexpr int kRampPoints = 6;  // of the offset that absorbs a change of footsteps
constexpr auto kBatch = static_cast<int>(kBatchPoints);

constexpr std::size_t index_of(Side side) noexcept {
  return static_cast<std::size_t>(side);
}

GaitParameters checked(GaitParameters parameters) {
  parameters.validate();
  parameters.step_time_s = parameters.step_points() * facts::kSlot_s;
  return parameters;
}

PreviewParameters preview_of(const GaitParameters& parameters) {
  return {parameters.com_height_m, facts::kSlot_s, parameters.preview_points(), parameters.zmp_error_weight,
          parameters.jerk_weight};
}

double smooth_share(double s) noexcept {
  return s * s * (3.0 - 2.0 * s);
}

// Reference ZMP in the step, `elapsed` points after its beginning.
Eigen::RowVector2d zmp_in_step(const Step& step, int elapsed) noexcept {
  if (elapsed >= step.double_support_points) return step.zmp_to;
  const double share = static_cast<double>(elapsed) / step.double_support_points;
  return step.zmp_from + (step.lead_in ? smooth_share(share) : share) * (step.zmp_to - step.zmp_from);
}

std::array<Pose2, 2> feet_after(const Step& step) noexcept {
  std::array<Pose2, 2> feet;
  feet[index_of(step.swing)] = step.landing;
  feet[index_of(other(step.swing))] = step.stance;
  return feet;
}

}  // namespace

Pose2 middle_of(const std::array<Pose2, 2>& feet) noexcept {
  return {0.5 * (feet[0].x_m + feet[1].x_m), 0.5 * (feet[0].y_m + feet[1].y_m),
          0.5 * (feet[0].yaw_rad + feet[1].yaw_rad)};
}

WalkingPattern::WalkingPattern(const GaitParameters& parameters)
    : parameters_(checked(parameters)),
      controller_(preview_of(parameters_)),
      absorber_(parameters_.com_height_m, parameters_.absorb_points(), kRampPoints),
      planner_(parameters_),
      adjustment_(parameters_, absorber_.omega_per_s()) {
  reset_to_stand({});
}

void WalkingPattern::reset_to_stand(const Pose2& middle) noexcept {
  state_ = PatternState{};
  const double half = 0.5 * parameters_.foot_spacing_m;
  state_.feet = {middle.compose({0.0, half, 0.0}), middle.compose({0.0, -half, 0.0})};
  state_.cart.motion.row(0) = stand_com(state_.feet);
  state_.hips = HipHeight(parameters_.hip_height_m);
  final_stance_ = middle;
  batch_reference_.count = 0;
}

Eigen::RowVector2d WalkingPattern::stance_zmp(Side side, const Pose2& foot) const noexcept {
  return foot.transform(parameters_.zmp_forward_m, -sign_of(side) * parameters_.zmp_inward_m).transpose();
}

Eigen::RowVector2d WalkingPattern::stand_com(const std::array<Pose2, 2>& feet) const noexcept {
  return middle_of(feet).transform(parameters_.stand_com_forward_m, 0.0).transpose();
}

double WalkingPattern::swing_share(const PatternState& state) noexcept {
  const int in_swing = state.elapsed_points - state.step.double_support_points;
  return in_swing > 0 ? state.swing.share(in_swing * facts::kSlot_s) : 0.0;
}

bool WalkingPattern::is_open(const PatternState& state) const noexcept {
  return state.elapsed_points < state.step.double_support_points ||
         swing_share(state) < parameters_.freeze_share;
}

// The last step has begun: the CoM is on its way to rest, and to walk on would throw the ZMP off the foot.
// The walk begins anew while the robot settles.
bool WalkingPattern::must_finish_stop(const PatternState& state) noexcept {
  return state.phase == Phase::walking && state.step.last;
}

// The first step. It begins with the foot towards which the robot is to move, else with the left one.
void WalkingPattern::begin_walking(PatternState& state, const Velocity2& wanted) noexcept {
  const double direction = wanted.left_m_per_s != 0.0 ? wanted.left_m_per_s : wanted.turn_rad_per_s;
  Step step;
  step.swing = direction < 0.0 ? Side::right : Side::left;
  step.double_support_points = parameters_.lead_in_points();
  step.swing_points = parameters_.swing_points();
  step.lead_in = true;
  step.stance = state.feet[index_of(other(step.swing))];
  step.zmp_from = controller_.zmp(state.cart);
  step.zmp_to = stance_zmp(other(step.swing), step.stance);
  state.step = step;
  state.phase = Phase::walking;
  state.elapsed_points = 0;
  state.cart.error_sum.setZero();
  state.yaw_correction_rad = {};
  state.zmp_offset = {};
  state.divergence = absorber_.divergence(state.cart);
}

// The CoM comes to rest above the stand's point by least jerk; exactly, in a fixed time.
void WalkingPattern::begin_settling(PatternState& state) const noexcept {
  const Eigen::RowVector2d end = stand_com(state.feet);
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

Eigen::RowVector2d WalkingPattern::swing_zmp_m(const SwingFoot& swing, int in_swing) const noexcept {
  return parameters_.swing_moment_s2 * swing.acceleration_m_per_s2(in_swing * facts::kSlot_s);
}

Step WalkingPattern::closing_step_after(const Step& before) const noexcept {
  Step step;
  step.swing = other(before.swing);
  step.double_support_points = parameters_.double_support_points();
  step.swing_points = parameters_.swing_points();
  step.stance = before.landing;
  step.landing = planner_.beside(step.stance, step.swing);
  step.zmp_from = before.zmp_to;
  step.zmp_to = stance_zmp(before.swing, step.stance);
  return step;
}

void WalkingPattern::aim_step(Step& step, const Wanted& wanted, const Eigen::Vector2d& offset_m) noexcept {
  step.velocity = planner_.next_velocity(step.velocity_before, wanted.velocity, applied_);
  Velocity2 commanded = wanted.velocity, before = step.velocity_before;
  commanded.turn_rad_per_s = wanted.commanded_turn_rad_per_s;
  before.turn_rad_per_s = step.commanded_turn_before_rad_per_s;
  StepLimit ignored = StepLimit::none;  // what limits the commands is told of the velocity
  step.commanded_turn_rad_per_s = planner_.next_velocity(before, commanded, ignored).turn_rad_per_s;
  step.landing = planner_.landing(step.stance, step.swing, step.velocity_before, step.velocity,
                                  offset_m + step.adjustment_m, applied_);
}

Step WalkingPattern::step_after(const Step& before, const Wanted& wanted,
                                const Eigen::Vector2d& offset_m) noexcept {
  Step step = closing_step_after(before);
  step.velocity_before = before.velocity;
  step.commanded_turn_before_rad_per_s = before.commanded_turn_rad_per_s;
  aim_step(step, wanted, offset_m);
  return step;
}

double WalkingPattern::landing_yaw_correction_rad(const PatternState& state) const noexcept {
  const Step& step = state.step;
  return state.yaw_correction_rad[index_of(other(step.swing))] +
         (step.velocity.turn_rad_per_s - step.commanded_turn_rad_per_s) * parameters_.step_time_s;
}

// Of the base, whose yaw is the mean of the feet's.
double WalkingPattern::yaw_correction_rad(const PatternState& state) const noexcept {
  double sum_rad = state.yaw_correction_rad[0] + state.yaw_correction_rad[1];
  if (state.phase == Phase::walking) {
    sum_rad += smooth_share(swing_share(state)) *
               (landing_yaw_correction_rad(state) - state.yaw_correction_rad[index_of(state.step.swing)]);
  }
  return 0.5 * sum_rad;
}

void WalkingPattern::schedule_walk(PatternState& state, const Wanted& wanted, const Eigen::Vector2d& offset_m,
                                   const Eigen::Vector2d& dcm_deviation_m) noexcept {
  if (state.phase != Phase::walking) begin_walking(state, wanted.velocity);
  Step& step = state.step;
  Eigen::Vector2d offset_left = offset_m;
  if (is_open(state)) {
    aim_step(step, wanted, offset_m);
    offset_left.setZero();
    const int in_swing = state.elapsed_points - step.double_support_points;
    if (in_swing > 0)
      state.swing.aim(step.landing, in_swing * facts::kSlot_s, step.swing_points * facts::kSlot_s);
  }
  if (state.recovery_steps == 0) {
    aim_hips(state, parameters_.hip_height_at_m(std::max(std::abs(step.velocity.forward_m_per_s),
                                                         std::abs(wanted.velocity.forward_m_per_s))));
  }
  schedule_steps_after(step, state.elapsed_points, wanted, offset_left);
  if (adjust_step(state, dcm_deviation_m))
    schedule_steps_after(step, state.elapsed_points, wanted, offset_left);
}

void WalkingPattern::schedule_steps_after(const Step& flying, int elapsed_points, const Wanted& wanted,
                                          Eigen::Vector2d offset_m) noexcept {
  schedule_.count = schedule_.next = 0;
  schedule_.ends = false;
  const int wanted_points = kBatch + parameters_.preview_points();
  const Step* before = &flying;
  for (int points = flying.points() - elapsed_points; points <= wanted_points && schedule_.count < kMaxSteps;
       points += before->points()) {
    Step& next = schedule_.steps[static_cast<std::size_t>(schedule_.count++)];
    next = step_after(*before, wanted, offset_m);
    offset_m.setZero();
    before = &next;
  }
}

// A foot on the ground becomes the closing foot; a foot in the air lands where it was to land, and the other
// closes. Feet side by side settle at once. A step that has been adjusted stays so.
void WalkingPattern::schedule_stop(PatternState& state) noexcept {
  schedule_.count = schedule_.next = 0;
  schedule_.ends = true;
  if (state.phase != Phase::walking) return;
  if (state.recovery_steps == 0) aim_hips(state, parameters_.hip_height_m);
  Step& step = state.step;
  if (state.elapsed_points <= step.double_support_points && step.adjustment_m.isZero()) {
    if (planner_.is_beside(step.stance, step.swing, state.feet[index_of(step.swing)])) {
      begin_settling(state);
      return;
    }
    step.landing = planner_.beside(step.stance, step.swing);
    step.velocity = {};
  }
  step.last = planner_.is_beside(step.stance, step.swing, step.landing);
  if (step.last) return;
  schedule_.steps[0] = closing_step_after(step);
  schedule_.steps[0].last = true;
  schedule_.count = 1;
}

void WalkingPattern::lay_out_reference(const PatternState& state, int points,
                                       ZmpReference& reference) const noexcept {
  reference.count = 0;
  if (state.phase != Phase::walking) return;
  const int most = std::min(points + 1, ZmpReference::kCapacity);
  int row = 0;
  const Step* step = &state.step;
  int elapsed = state.elapsed_points;
  std::array<Pose2, 2> feet = state.feet;  // where the last step left them
  for (int i = -1; i < schedule_.count && row < most; ++i, elapsed = 0) {
    if (i >= 0) step = &schedule_.steps[static_cast<std::size_t>(i)];
    const bool swings = i < 0 && elapsed > step->double_support_points;
    const SwingFoot swing =
        swings ? state.swing
               : SwingFoot(feet[index_of(step->swing)], step->landing, step->swing_points * facts::kSlot_s);
    // What the leg in the air adds to the ZMP is left to it: the cart gets the rest.
    for (; elapsed < step->points() && row < most; ++elapsed) {
      reference.point.row(row) = zmp_in_step(*step, elapsed);
      const int in_swing = elapsed - step->double_support_points;
      if (in_swing > 0) reference.point.row(row) -= swing_zmp_m(swing, in_swing);
      ++row;
    }
    feet = feet_after(*step);
  }
  if (schedule_.ends) {
    const Eigen::RowVector2d end = stand_com(feet_after(*step));
    const int shift = parameters_.settle_points() / 2;
    for (int k = 0; k <= shift && row < most; ++k) {
      reference.point.row(row++) = step->zmp_to + static_cast<double>(k) / shift * (end - step->zmp_to);
    }
  }
  reference.count = row;
}

void WalkingPattern::fill_reference(PatternState& state, int points, ZmpReference& reference) const noexcept {
  lay_out_reference(state, points, reference);
  if (state.phase != Phase::walking) return;
  absorber_.absorb(state.divergence, reference, state.zmp_offset);
}

void WalkingPattern::pass(PatternState& state, const ZmpReference& reference, int played) const noexcept {
  if (reference.count == 0) return;
  DivergenceAbsorber::shift(state.zmp_offset, played);
  state.divergence = absorber_.required_divergence(reference, played);
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
    state.swing = SwingFoot(state.feet[foot], step.landing, step.swing_points * facts::kSlot_s);
  }
  ++state.elapsed_points;
  const int in_swing = state.elapsed_points - step.double_support_points;
  if (in_swing <= 0) return;
  if (in_swing < step.swing_points) {
    state.feet[foot] = state.swing.at(in_swing * facts::kSlot_s);
    state.foot_height_m[foot] = swing_height_m(swing_share(state), parameters_.lift_m);
    return;
  }
  if (state.recovery_steps > 0) --state.recovery_steps;
  state.feet[foot] = step.landing;
  state.yaw_correction_rad[foot] = landing_yaw_correction_rad(state);
  state.foot_height_m[foot] = 0.0;
  if (schedule_.next < schedule_.count) {
    state.step = schedule_.steps[static_cast<std::size_t>(schedule_.next++)];
    state.elapsed_points = 0;
  } else {
    begin_settling(state);
  }
}

void WalkingPattern::advance_settling(PatternState& state) const noexcept {
  ++state.elapsed_points;
  if (state.elapsed_points >= parameters_.settle_points()) {
    state.cart = Cart{};
    state.cart.motion.row(0) = stand_com(state.feet);
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

}  // namespace gaitway::trajectory
