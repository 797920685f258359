// Both arms as they swing against the legs: by which joints, how far, and what their masses do.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

struct ArmSwing {
  // Up to here the arms go as far as they are asked to.
  [[nodiscard]] double free_rad() const noexcept { return kFree * most_rad; }
  // How far they go for what they are asked: beyond free_rad() less and less towards most_rad, without a
  // jerk.
  [[nodiscard]] double limited_rad(double asked_rad) const noexcept {
    const double beyond_rad = std::abs(asked_rad) - free_rad(), rest_rad = most_rad - free_rad();
    if (beyond_rad <= 0.0) return asked_rad;
    return std::copysign(free_rad() + rest_rad * std::tanh(beyond_rad / rest_rad), asked_rad);
  }

  std::array<int, 2> joint{};    // [Side]: the shoulder's pitch; an index into RobotModel::joints
  std::array<double, 2> sign{};  // of the joint's angle, where the arm goes back
  double most_rad = 0.0;         // ahead and back from home, within both joints' limits; above 0
  double most_rad_per_s = 0.0;   // of the slower joint
  // Sum of mass x way ahead x distance to the left of the base, for each radian by which the left arm goes
  // ahead and the right one back.
  double moment_kg_m2 = 0.0;

 private:
  static constexpr double kFree = 0.8;
};

// `home`: at the home posture. Nothing: one of the arms is missing, or has no shoulder that pitches, is at
// one of its limits, or hangs no lower than its shoulder.
[[nodiscard]] std::optional<ArmSwing> arm_swing(const RobotModel& model, const ForwardKinematics& home);

}  // namespace gaitway::urdf
