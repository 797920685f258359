// How the foot in the air and the hips move in a step: smooth, also when their goal changes on the way.
#pragma once

#include "gaitway/trajectory/footstep_planner.hpp"
#include "gaitway/trajectory/quintic.hpp"

namespace gaitway::trajectory {

// Height of the sole at share s ∈ [0, 1] of the swing: lift·64·s³(1−s)³. Velocity and acceleration vanish at
// both ends.
[[nodiscard]] double swing_height_m(double share, double lift_m) noexcept;

// The foot in the air: at rest at lift and at touch-down, and smooth when its target changes on the way.
//
// Its `flatness`, 0 to 1, is what share of a cubic there is in its way over the ground, beside least jerk. A
// flat swing is slower at its fastest, 1.5 against 1.875 times the mean, and between 0 and 1 it needs less
// acceleration than either (at 0.5: 4.8 against 5.8 times way / time²), which begins and ends with a jump.
class SwingFoot {
 public:
  SwingFoot() = default;

  // At rest on `lift`, heading for `landing` within swing_s.
  SwingFoot(const Pose2& lift, const Pose2& landing, double swing_s, double flatness) noexcept;

  // Aims at another landing place, and at another time of touch-down, from time_s of the swing on, without a
  // jump in position, velocity or acceleration. time_s < swing_s.
  void aim(const Pose2& landing, double time_s, double swing_s) noexcept;

  [[nodiscard]] Pose2 at(double time_s) const noexcept;
  // How much of the swing is done, 0 to 1: in proportion to time unless the time of touch-down has changed.
  [[nodiscard]] double share(double time_s) const noexcept { return share_.at(time_s - aimed_s_).position; }
  [[nodiscard]] Eigen::RowVector2d acceleration_m_per_s2(double time_s) const noexcept;

 private:
  [[nodiscard]] double end_acceleration(double way_m) const noexcept;
  [[nodiscard]] MotionState at_landing(double lift_m, double landing_m) const noexcept;

  Quintic x_, y_, yaw_, share_;
  double lift_x_m_ = 0.0, lift_y_m_ = 0.0;
  double flatness_ = 0.0;
  double aimed_s_ = 0.0;  // when the polynomials begin
  double swing_s_ = 1.0;
  double landing_rate_per_s_ = 1.0;  // of the share
};

// The hips' height above the ground, on its way from one to another.
class HipHeight {
 public:
  HipHeight() = default;
  // At rest at a height.
  explicit HipHeight(double height_m) noexcept : now_{height_m}, goal_m_(height_m) {}

  // Heads for another height, to be there after `points` points, without a jump in speed or acceleration.
  void aim(double goal_m, int points) noexcept;
  void advance() noexcept;  // by a point

  [[nodiscard]] double height_m() const noexcept { return now_.position; }
  [[nodiscard]] double goal_m() const noexcept { return goal_m_; }

  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.now_, self.goal_m_, self.path_, self.gone_points_, self.path_points_);
  }

 private:
  MotionState now_;
  double goal_m_ = 0.0;
  Quintic path_;  // to the goal
  int gone_points_ = 0, path_points_ = 0;
};

}  // namespace gaitway::trajectory
