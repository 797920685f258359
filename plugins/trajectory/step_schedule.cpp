// Steps that walk on, steps that bring the feet together; and the reference over the stance feet.
#include "gaitway/trajectory/step_schedule.hpp"

#include <algorithm>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::trajectory {
namespace {

constexpr int kRampPoints = 6;  // of the offset that absorbs a change of footsteps

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

Eigen::RowVector2d StepSchedule::stance_zmp(Side side, const Pose2& foot) const noexcept {
  return foot.transform(parameters_.zmp_forward_m, -sign_of(side) * parameters_.zmp_inward_m).transpose();
}

Step StepSchedule::closing_step_after(const Step& before) const noexcept {
  Step step;
  step.swing = other(before.swing);
  step.double_support_points = parameters_.double_support_points();
  step.swing_points = parameters_.swing_points();
  step.stance = before.landing;
  step.lift = before.stance;
  step.landing = planner_.beside(step.stance, step.swing);
  step.zmp_from = before.zmp_to;
  step.zmp_to = stance_zmp(before.swing, step.stance);
  return step;
}

void StepSchedule::aim(Step& step, const WantedWalk& wanted, const Eigen::Vector2d& offset_m) noexcept {
  step.number = 0;
  step.velocity = planner_.next_velocity(step.velocity_before, wanted.velocity, applied_);
  Velocity2 commanded = wanted.velocity, before = step.velocity_before;
  commanded.turn_rad_per_s = wanted.commanded_turn_rad_per_s;
  before.turn_rad_per_s = step.commanded_turn_before_rad_per_s;
  StepLimit ignored = StepLimit::none;  // what limits the commands is told of the velocity
  step.commanded_turn_rad_per_s = planner_.next_velocity(before, commanded, ignored).turn_rad_per_s;
  step.landing = step.adjustment_m.isZero() ? planner_.landing(step.stance, step.swing, step.velocity_before,
                                                               step.velocity, offset_m, applied_)
                                            : adjusted_landing(step, offset_m + step.adjustment_m);
}

Pose2 StepSchedule::adjusted_landing(const Step& step, const Eigen::Vector2d& offset_m) const noexcept {
  return step.number != 0 ? planner_.placed_landing(step.stance, step.swing, step.placed, offset_m)
                          : planner_.adjusted_landing(step.stance, step.swing, step.velocity_before,
                                                      step.velocity, offset_m);
}

bool StepSchedule::is_in_reach(const Pose2& stance, const PlannedSteps& steps,
                               std::uint32_t number) const noexcept {
  constexpr double kCorrected_m = 0.03, kCorrected_rad = 0.15;
  const PlannedSteps::Place* const place = steps.find(number);
  if (place == nullptr) return false;
  const Pose2 local = stance.relative_of(place->pose);
  const Pose2 limited =
      stance.relative_of(planner_.placed_landing(stance, place->side, local, Eigen::Vector2d::Zero()));
  return (local.position() - limited.position()).norm() <= kCorrected_m &&
         std::abs(local.yaw_rad - limited.yaw_rad) <= kCorrected_rad;
}

// The way's last step ends exactly beside the other foot, as every stand.
void StepSchedule::place(Step& step, const PlannedSteps& steps, double stance_correction_rad) noexcept {
  const PlannedSteps::Place& place = *steps.find(step.number);
  step.last = steps.is_last(step.number);
  step.landing = step.last
                     ? planner_.beside(step.stance, step.swing)
                     : planner_.placed_landing(step.stance, step.swing, step.stance.relative_of(place.pose),
                                               Eigen::Vector2d::Zero());
  step.placed = step.stance.relative_of(step.landing);
  const double time_s = parameters_.step_time_s;
  const Pose2 way = step.stance.relative_of(step.landing), from = step.stance.relative_of(step.lift);
  step.velocity = {0.5 * (way.x_m - from.x_m) / time_s, 0.5 * (way.y_m - from.y_m) / time_s,
                   way.yaw_rad / time_s};
  step.commanded_turn_rad_per_s =
      step.velocity.turn_rad_per_s - (steps.yaw_correction_rad - stance_correction_rad) / time_s;
}

void StepSchedule::follow_after(const Step& flying, int elapsed_points, const PlannedSteps& steps) noexcept {
  count_ = next_ = 0;
  ends_ = flying.last;
  const int wanted_points = static_cast<int>(kBatchPoints) + parameters_.preview_points();
  const Step* before = &flying;
  for (int points = flying.points() - elapsed_points; points <= wanted_points && count_ < kMaxSteps && !ends_;
       points += before->points()) {
    Step& next = steps_[static_cast<std::size_t>(count_++)];
    next = closing_step_after(*before);
    next.velocity_before = before->velocity;
    next.commanded_turn_before_rad_per_s = before->commanded_turn_rad_per_s;
    const PlannedSteps::Place* const place = before->number == 0 ? nullptr : steps.find(before->number + 1);
    if (place != nullptr && place->side == next.swing) {
      next.number = before->number + 1;
      this->place(next, steps, steps.yaw_correction_rad);
    } else {
      next.last = true;  // nothing more is known
    }
    ends_ = next.last;
    before = &next;
  }
}

void StepSchedule::walk_after(const Step& flying, int elapsed_points, const WantedWalk& wanted,
                              Eigen::Vector2d offset_m) noexcept {
  count_ = next_ = 0;
  ends_ = false;
  const int wanted_points = static_cast<int>(kBatchPoints) + parameters_.preview_points();
  const Step* before = &flying;
  for (int points = flying.points() - elapsed_points; points <= wanted_points && count_ < kMaxSteps;
       points += before->points()) {
    Step& next = steps_[static_cast<std::size_t>(count_++)];
    next = closing_step_after(*before);
    next.velocity_before = before->velocity;
    next.commanded_turn_before_rad_per_s = before->commanded_turn_rad_per_s;
    aim(next, wanted, offset_m);
    offset_m.setZero();
    before = &next;
  }
}

bool StepSchedule::stop_after(PatternState& state) noexcept {
  count_ = next_ = 0;
  ends_ = true;
  if (state.phase != Phase::walking) return true;
  Step& step = state.step;
  if (state.elapsed_points <= step.double_support_points && step.adjustment_m.isZero()) {
    if (planner_.is_beside(step.stance, step.swing, state.feet[index_of(step.swing)])) return false;
    step.landing = planner_.beside(step.stance, step.swing);
    step.velocity = {};
    if (!step.last) step.number = 0;  // it is not the plan's any more
  }
  step.last = planner_.is_beside(step.stance, step.swing, step.landing);
  if (step.last) return true;
  steps_[0] = closing_step_after(step);
  steps_[0].last = true;
  count_ = 1;
  return true;
}

WalkReference::WalkReference(const GaitParameters& parameters)
    : swing_moment_s2_(parameters.swing_moment_s2),
      swing_flatness_(parameters.swing_flatness),
      stand_com_forward_m_(parameters.stand_com_forward_m),
      settle_points_(parameters.settle_points()),
      absorber_(parameters.com_height_m, parameters.absorb_points(), kRampPoints) {}

Eigen::RowVector2d WalkReference::swing_zmp_m(const SwingFoot& swing, int in_swing) const noexcept {
  return swing_moment_s2_ * swing.acceleration_m_per_s2(in_swing * facts::kSlot_s);
}

Eigen::RowVector2d WalkReference::stand_com(const std::array<Pose2, 2>& feet) const noexcept {
  return middle_of(feet).transform(stand_com_forward_m_, 0.0).transpose();
}

void WalkReference::lay_out(const PatternState& state, const StepSchedule& schedule, int points,
                            ZmpReference& reference) const noexcept {
  reference.count = 0;
  if (state.phase != Phase::walking) return;
  const int most = std::min(points + 1, ZmpReference::kCapacity);
  int row = 0;
  std::array<Pose2, 2> feet = state.feet;  // where the last step left them
  const auto lay_out_step = [&](const Step& step, int elapsed, bool in_flight) {
    const SwingFoot swing = in_flight ? state.swing
                                      : SwingFoot(feet[index_of(step.swing)], step.landing,
                                                  step.swing_points * facts::kSlot_s, swing_flatness_);
    // What the leg in the air adds to the ZMP is left to it: the cart gets the rest.
    for (; elapsed < step.points() && row < most; ++elapsed) {
      reference.point.row(row) = zmp_in_step(step, elapsed);
      const int in_swing = elapsed - step.double_support_points;
      if (in_swing > 0) reference.point.row(row) -= swing_zmp_m(swing, in_swing);
      ++row;
    }
    feet = feet_after(step);
  };
  lay_out_step(state.step, state.elapsed_points, state.swing_points_done() > 0);
  const Step* last = &state.step;
  for (const Step& step : schedule.steps()) {
    if (row >= most) break;
    lay_out_step(step, 0, false);
    last = &step;
  }
  if (schedule.ends()) {
    const Eigen::RowVector2d end = stand_com(feet_after(*last));
    const int shift = settle_points_ / 2;
    for (int k = 0; k <= shift && row < most; ++k) {
      reference.point.row(row++) = last->zmp_to + static_cast<double>(k) / shift * (end - last->zmp_to);
    }
  }
  reference.count = row;
}

void WalkReference::fill(PatternState& state, const StepSchedule& schedule, int points,
                         ZmpReference& reference) const noexcept {
  lay_out(state, schedule, points, reference);
  if (state.phase != Phase::walking) return;
  absorber_.absorb(state.divergence, reference, state.zmp_offset);
}

void WalkReference::pass(PatternState& state, const ZmpReference& reference, int played) const noexcept {
  if (reference.count == 0) return;
  DivergenceAbsorber::shift(state.zmp_offset, played);
  state.divergence = absorber_.required_divergence(reference, played);
}

}  // namespace gaitway::trajectory
