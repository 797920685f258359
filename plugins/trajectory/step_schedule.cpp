// Steps that walk on, and steps that bring the feet together.
#include "gaitway/trajectory/step_schedule.hpp"

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::trajectory {

Eigen::RowVector2d StepSchedule::stance_zmp(Side side, const Pose2& foot) const noexcept {
  return foot.transform(parameters_.zmp_forward_m, -sign_of(side) * parameters_.zmp_inward_m).transpose();
}

Step StepSchedule::closing_step_after(const Step& before) const noexcept {
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

void StepSchedule::aim(Step& step, const WantedWalk& wanted, const Eigen::Vector2d& offset_m) noexcept {
  step.velocity = planner_.next_velocity(step.velocity_before, wanted.velocity, applied_);
  Velocity2 commanded = wanted.velocity, before = step.velocity_before;
  commanded.turn_rad_per_s = wanted.commanded_turn_rad_per_s;
  before.turn_rad_per_s = step.commanded_turn_before_rad_per_s;
  StepLimit ignored = StepLimit::none;  // what limits the commands is told of the velocity
  step.commanded_turn_rad_per_s = planner_.next_velocity(before, commanded, ignored).turn_rad_per_s;
  step.landing =
      step.adjustment_m.isZero()
          ? planner_.landing(step.stance, step.swing, step.velocity_before, step.velocity, offset_m, applied_)
          : planner_.adjusted_landing(step.stance, step.swing, step.velocity_before, step.velocity,
                                      offset_m + step.adjustment_m);
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
  }
  step.last = planner_.is_beside(step.stance, step.swing, step.landing);
  if (step.last) return true;
  steps_[0] = closing_step_after(step);
  steps_[0].last = true;
  count_ = 1;
  return true;
}

}  // namespace gaitway::trajectory
