// What a robot's steps and body need: how far, how high and on what it steps, and the room that it takes.
// Values alone; whoever knows the robot's gait fills them in.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace gaitway::planning {

enum class Side : std::uint8_t { left = 0, right = 1 };
[[nodiscard]] constexpr Side other(Side side) noexcept {
  return side == Side::left ? Side::right : Side::left;
}
// +1 for left, -1 for right: the sign of y on that side.
[[nodiscard]] constexpr double sign_of(Side side) noexcept {
  return side == Side::left ? 1.0 : -1.0;
}

// A place on the ground, in the world's frame unless something else is said. Of a foot: of its sole's origin,
// which lies below the ankle.
struct Pose {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;

  [[nodiscard]] Pose compose(const Pose& local) const noexcept;       // this · local
  [[nodiscard]] Pose relative_of(const Pose& placed) const noexcept;  // this⁻¹ · placed, yaw in (−π, π]
  [[nodiscard]] Eigen::Vector2d point(const Eigen::Vector2d& local_m) const noexcept;
};
[[nodiscard]] double wrapped(double angle_rad) noexcept;  // to (−π, π]
// Half of the way from one to the other, and of the shorter turn.
[[nodiscard]] Pose middle_of(const Pose& a, const Pose& b) noexcept;
[[nodiscard]] double way_m(const Pose& a, const Pose& b) noexcept;
[[nodiscard]] double turn_rad(const Pose& a, const Pose& b) noexcept;  // 0 to π

inline constexpr double kMostEffort = 1.0 + 1e-9;  // Limits::effort() of what can be stepped, with rounding

struct Sole {
  double length_m = 0.0, width_m = 0.0;
  double centre_forward_m = 0.0;  // of the rectangle, ahead of the sole's origin
};

// What of the robot is higher above its soles than `from_m` (and, if another band follows, lower than that
// one's): a convex outline as seen from above, counter-clockwise, in the frame of the body's middle: x ahead,
// y left, the origin midway between the soles' origins of the stand.
struct Band {
  double from_m = 0.0;
  std::vector<Eigen::Vector2d> outline_m;
};

struct Limits {
  Sole sole;
  double foot_spacing_m = 0.0;  // of the soles' origins in the stand
  // Of a landing against its stance foot.
  double max_step_forward_m = 0.0, max_step_backward_m = 0.0;
  double max_foot_spacing_m = 0.0;  // to the side
  double max_step_turn_rad = 0.0;
  double min_sole_gap_m = 0.0;
  double max_step_height_m = 0.0;  // up or down
  double sole_unevenness_m = 0.0;  // by which the ground under a sole may differ, and still counts as level
  double lift_m = 0.0;             // the swing foot clears what is so high, in the middle of its way
  // From low to high; the lowest begins at most at lift_m, so that nothing is neither stepped over nor met.
  std::vector<Band> bands;
  double height_m = 0.0;     // of the robot
  double clearance_m = 0.0;  // of the body from everything, for sway and errors

  // Throws std::invalid_argument naming the field, its value and the rule.
  void validate() const;

  // How much of what the gait can do a step takes: the norm of its shares of the longest step, the widest and
  // the largest turn, since no step can have all at once; infinite where it is beyond a limit of its own.
  // `landing` is in the stance foot's frame. At most 1 can be stepped.
  [[nodiscard]] double effort(const Pose& landing, Side swing) const noexcept;
  // Least lateral distance of the soles' origins that keeps the soles min_sole_gap apart, whatever the step's
  // length. `outward_rad`: by which the swing foot's toes are turned away from the stance foot.
  [[nodiscard]] double least_spacing_m(double outward_rad) const noexcept;

  // Of the foot beside `stance` in the stand, and of the body's middle there.
  [[nodiscard]] Pose beside(const Pose& stance, Side swing) const noexcept;
  [[nodiscard]] Pose middle_beside(const Pose& stance, Side stance_side) const noexcept;
  // The foot of a robot that stands at `middle`.
  [[nodiscard]] Pose foot_of(const Pose& middle, Side side) const noexcept;
};

}  // namespace gaitway::planning
