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

  // Aims at another landing place from time_s of the swing on, without a jump in position, velocity or
  // acceleration. The time of touch-down stays. time_s < swing_s.
  void aim(const Pose2& landing, double time_s) noexcept;

  [[nodiscard]] Pose2 at(double time_s) const noexcept;
  [[nodiscard]] Eigen::RowVector2d acceleration_m_per_s2(double time_s) const noexcept;

 private:
  Quintic x_, y_, yaw_;
  double aimed_s_ = 0.0;  // when the polynomials begin
  double swing_s_ = 1.0;
};

}  // namespace gaitway::trajectory
