// The motion of the foot in the air: at rest at lift and at touch-down, and smooth when its target changes on
// the way.
#pragma once

#include "gaitway/trajectory/footstep_planner.hpp"
#include "gaitway/trajectory/quintic.hpp"

namespace gaitway::trajectory {

// Height of the sole at share s ∈ [0, 1] of the swing: lift·64·s³(1−s)³. Velocity and acceleration vanish at
// both ends.
[[nodiscard]] double swing_height_m(double share, double lift_m) noexcept;

class SwingFoot {
 public:
  SwingFoot() = default;

  // At rest on `lift`, heading for `landing` within swing_s.
  SwingFoot(const Pose2& lift, const Pose2& landing, double swing_s) noexcept;

  // Aims at another landing place, and at another time of touch-down, from time_s of the swing on, without a
  // jump in position, velocity or acceleration. time_s < swing_s.
  void aim(const Pose2& landing, double time_s, double swing_s) noexcept;

  [[nodiscard]] Pose2 at(double time_s) const noexcept;
  // How much of the swing is done, 0 to 1: in proportion to time unless the time of touch-down has changed.
  [[nodiscard]] double share(double time_s) const noexcept { return share_.at(time_s - aimed_s_).position; }
  [[nodiscard]] Eigen::RowVector2d acceleration_m_per_s2(double time_s) const noexcept;

 private:
  Quintic x_, y_, yaw_, share_;
  double aimed_s_ = 0.0;  // when the polynomials begin
  double swing_s_ = 1.0;
  double landing_rate_per_s_ = 1.0;  // of the share
};

}  // namespace gaitway::trajectory
