// Polynomials of fifth degree to each new goal.
#include "gaitway/trajectory/step_motion.hpp"

#include "gaitway/facts/facts.hpp"

namespace gaitway::trajectory {

double swing_height_m(double share, double lift_m) noexcept {
  const double product = share * (1.0 - share);
  return lift_m * 64.0 * product * product * product;
}

SwingFoot::SwingFoot(const Pose2& lift, const Pose2& landing, double swing_s, double flatness) noexcept
    : yaw_({lift.yaw_rad}, {landing.yaw_rad}, swing_s),
      share_({0.0, 1.0 / swing_s}, {1.0, 1.0 / swing_s}, swing_s),
      lift_x_m_(lift.x_m),
      lift_y_m_(lift.y_m),
      flatness_(flatness),
      swing_s_(swing_s),
      landing_rate_per_s_(1.0 / swing_s) {
  x_ = Quintic({lift.x_m, 0.0, end_acceleration(landing.x_m - lift.x_m)}, at_landing(lift.x_m, landing.x_m),
               swing_s);
  y_ = Quintic({lift.y_m, 0.0, end_acceleration(landing.y_m - lift.y_m)}, at_landing(lift.y_m, landing.y_m),
               swing_s);
}

// What a cubic over the whole swing begins with, and ends with the other way round.
double SwingFoot::end_acceleration(double way_m) const noexcept {
  return flatness_ * 6.0 * way_m / (swing_s_ * swing_s_);
}

MotionState SwingFoot::at_landing(double lift_m, double landing_m) const noexcept {
  return {landing_m, 0.0, -end_acceleration(landing_m - lift_m)};
}

void SwingFoot::aim(const Pose2& landing, double time_s, double swing_s) noexcept {
  const double since = time_s - aimed_s_;
  const double left = swing_s - time_s;
  const MotionState share = share_.at(since);
  if (swing_s != swing_s_) landing_rate_per_s_ = (1.0 - share.position) / left;
  swing_s_ = swing_s;
  share_ = Quintic(share, {1.0, landing_rate_per_s_}, left);
  x_ = Quintic(x_.at(since), at_landing(lift_x_m_, landing.x_m), left);
  y_ = Quintic(y_.at(since), at_landing(lift_y_m_, landing.y_m), left);
  yaw_ = Quintic(yaw_.at(since), {landing.yaw_rad}, left);
  aimed_s_ = time_s;
}

Pose2 SwingFoot::at(double time_s) const noexcept {
  const double since = time_s - aimed_s_;
  return {x_.at(since).position, y_.at(since).position, yaw_.at(since).position};
}

Eigen::RowVector2d SwingFoot::acceleration_m_per_s2(double time_s) const noexcept {
  const double since = time_s - aimed_s_;
  return {x_.at(since).acceleration, y_.at(since).acceleration};
}

void HipHeight::aim(double goal_m, int points) noexcept {
  goal_m_ = goal_m;
  path_ = Quintic(now_, {goal_m}, points * facts::kSlot_s);
  gone_points_ = 0;
  path_points_ = points;
}

void HipHeight::advance() noexcept {
  if (now_.position == goal_m_) return;
  ++gone_points_;
  now_ = gone_points_ < path_points_ ? path_.at(gone_points_ * facts::kSlot_s) : MotionState{goal_m_};
}

}  // namespace gaitway::trajectory
