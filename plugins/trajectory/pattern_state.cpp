// The swing's share, and what the yaw feedback has turned.
#include "gaitway/trajectory/pattern_state.hpp"

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/gait_parameters.hpp"

namespace gaitway::trajectory {

Pose2 middle_of(const std::array<Pose2, 2>& feet) noexcept {
  return {0.5 * (feet[0].x_m + feet[1].x_m), 0.5 * (feet[0].y_m + feet[1].y_m),
          0.5 * (feet[0].yaw_rad + feet[1].yaw_rad)};
}

double PatternState::swing_share() const noexcept {
  const int in_swing = swing_points_done();
  return in_swing > 0 ? swing.share(in_swing * facts::kSlot_s) : 0.0;
}

void PatternState::aim_swing() noexcept {
  const int in_swing = swing_points_done();
  if (in_swing > 0) swing.aim(step.landing, in_swing * facts::kSlot_s, step.swing_points * facts::kSlot_s);
}

double PatternState::landing_yaw_correction_rad(double step_time_s) const noexcept {
  return yaw_correction_rad[index_of(other(step.swing))] +
         (step.velocity.turn_rad_per_s - step.commanded_turn_rad_per_s) * step_time_s;
}

double PatternState::base_yaw_correction_rad(double step_time_s) const noexcept {
  double sum_rad = yaw_correction_rad[0] + yaw_correction_rad[1];
  if (phase == Phase::walking) {
    sum_rad += smooth_share(swing_share()) *
               (landing_yaw_correction_rad(step_time_s) - yaw_correction_rad[index_of(step.swing)]);
  }
  return 0.5 * sum_rad;
}

}  // namespace gaitway::trajectory
