// What each joint of a leg does, told by its axis and its place, never by its name or number: hips turn in
// any order of yaw, roll and pitch, ankles in either.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

enum class LegJoint : std::uint8_t { hip_yaw, hip_roll, hip_pitch, knee, ankle_pitch, ankle_roll };

[[nodiscard]] std::string_view leg_joint_name(LegJoint which) noexcept;  // "hip yaw"

// Indices into RobotModel::joints.
class LegJoints {
 public:
  // `home`: at the home posture. The knee is the leg's fourth joint. Of the three before it and the two
  // behind it those do what they do whose axes lie nearest to the base's axes x (roll), y (pitch) and z
  // (yaw), taken together. Throws std::invalid_argument that says what the leg lacks if some axis is more
  // than 50 deg away.
  LegJoints(const RobotModel& model, const ForwardKinematics& home, Side side);

  [[nodiscard]] int operator[](LegJoint which) const noexcept {
    return index_[static_cast<std::size_t>(which)];
  }

 private:
  std::array<int, 6> index_{};
};

// The least velocity limit of the legs' joints, which all share a turn of the base; those that have none do
// not count.
[[nodiscard]] double slowest_leg_joint_rad_per_s(const RobotModel& model) noexcept;

}  // namespace gaitway::urdf
