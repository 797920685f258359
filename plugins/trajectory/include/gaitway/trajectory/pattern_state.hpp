// What the walk is doing: the step in flight, the cart, the feet.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/divergence_absorber.hpp"
#include "gaitway/trajectory/footstep_planner.hpp"
#include "gaitway/trajectory/preview_controller.hpp"
#include "gaitway/trajectory/quintic.hpp"
#include "gaitway/trajectory/step_motion.hpp"

namespace gaitway::trajectory {

[[nodiscard]] constexpr std::size_t index_of(Side side) noexcept {
  return static_cast<std::size_t>(side);
}

[[nodiscard]] constexpr double smooth_share(double share) noexcept {
  return share * share * (3.0 - 2.0 * share);
}

enum class Phase : std::uint8_t {
  stand,     // at rest in the nominal stand
  walking,   // in a step: double support, then swing
  settling,  // feet side by side, the CoM comes to rest
};

// One step: double support, in which the reference ZMP moves to the stance foot, then the swing.
struct Step {
  Side swing = Side::left;
  int double_support_points = 0;
  int swing_points = 0;
  bool last = false;         // the robot settles after it
  bool lead_in = false;      // first step from the stand: the ZMP moves smoothly, not linearly
  std::uint32_t number = 0;  // of the footstep plan's step that it is; 0: it follows a velocity
  Pose2 placed;              // of such a step: where the plan has it, in the stance foot's frame
  Pose2 lift;                // where the swing foot stood
  Pose2 stance;
  Pose2 landing;
  Eigen::Vector2d adjustment_m = Eigen::Vector2d::Zero();  // of the landing by StepAdjustment, stance frame
  Velocity2 velocity_before, velocity;  // of the step before, and with which this one was planned
  // The turn rate that the commands alone would have, without the yaw feedback.
  double commanded_turn_before_rad_per_s = 0.0, commanded_turn_rad_per_s = 0.0;
  Eigen::RowVector2d zmp_from = Eigen::RowVector2d::Zero(), zmp_to = Eigen::RowVector2d::Zero();

  [[nodiscard]] int points() const noexcept { return double_support_points + swing_points; }
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.swing, self.double_support_points, self.swing_points, self.last, self.lead_in, self.number,
            self.placed, self.lift, self.stance, self.landing, self.adjustment_m, self.velocity_before,
            self.velocity, self.commanded_turn_before_rad_per_s, self.commanded_turn_rad_per_s, self.zmp_from,
            self.zmp_to);
  }
};

// All that a plan depends on; copied to make the safe tail.
struct PatternState {
  Phase phase = Phase::stand;
  int elapsed_points = 0;  // of the step, or of the settling
  Cart cart;
  Eigen::RowVector2d divergence = Eigen::RowVector2d::Zero();  // that the reference in force asks for now, m
  ZmpOffset zmp_offset;                                        // absorbs changes of footsteps
  std::array<Pose2, 2> feet;  // [Side], on the ground or where the swing foot is
  std::array<double, 2> foot_height_m{};
  Step step;  // in flight while walking
  SwingFoot swing;
  std::array<Quintic, 2> settle;  // x, y of the CoM
  HipHeight hips;
  std::uint32_t landed = 0;                    // number of the footstep plan's step that landed last
  int recovery_steps = 0;                      // to be taken in place before the robot stands again
  std::array<double, 2> yaw_correction_rad{};  // [Side]: by which the yaw feedback has turned the foot so far
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.phase, self.elapsed_points, self.cart, self.divergence, self.zmp_offset, self.feet,
            self.foot_height_m, self.step, self.swing, self.settle, self.hips, self.landed,
            self.recovery_steps, self.yaw_correction_rad);
  }

  // Of the step in flight: points since the lift, 0 or less in the double support.
  [[nodiscard]] int swing_points_done() const noexcept { return elapsed_points - step.double_support_points; }
  // Of the swing, what is done: 0 in the double support.
  [[nodiscard]] double swing_share() const noexcept {
    const int in_swing = swing_points_done();
    return in_swing > 0 ? swing.share(in_swing * facts::kSlot_s) : 0.0;
  }
  // Aims the foot at the step's landing place, if it is in the air.
  void aim_swing() noexcept {
    const int in_swing = swing_points_done();
    if (in_swing > 0) swing.aim(step.landing, in_swing * facts::kSlot_s, step.swing_points * facts::kSlot_s);
  }
  // By how much the yaw feedback will have turned the foot in the air when it has landed.
  [[nodiscard]] double landing_yaw_correction_rad(double step_time_s) const noexcept {
    return yaw_correction_rad[index_of(other(step.swing))] +
           (step.velocity.turn_rad_per_s - step.commanded_turn_rad_per_s) * step_time_s;
  }
  // The same of the base, now: its yaw is the mean of the feet's.
  [[nodiscard]] double base_yaw_correction_rad(double step_time_s) const noexcept {
    double sum_rad = yaw_correction_rad[0] + yaw_correction_rad[1];
    if (phase == Phase::walking) {
      sum_rad += smooth_share(swing_share()) *
                 (landing_yaw_correction_rad(step_time_s) - yaw_correction_rad[index_of(step.swing)]);
    }
    return 0.5 * sum_rad;
  }
};

// The middle between two feet.
[[nodiscard]] inline Pose2 middle_of(const std::array<Pose2, 2>& feet) noexcept {
  return {0.5 * (feet[0].x_m + feet[1].x_m), 0.5 * (feet[0].y_m + feet[1].y_m),
          0.5 * (feet[0].yaw_rad + feet[1].yaw_rad)};
}

}  // namespace gaitway::trajectory
