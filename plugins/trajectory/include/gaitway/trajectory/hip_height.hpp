// The hips' height above the ground, on its way from one to another.
#pragma once

#include "gaitway/trajectory/quintic.hpp"

namespace gaitway::trajectory {

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
