// Roll and pitch of a body (rotation about z, then y, then x): from the direction of gravity, and on from its
// angular velocity.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace gaitway::geometry {

// Roll and pitch of a body at rest that feels this specific force, in its own axes.
[[nodiscard]] inline Eigen::Vector2d tilt_at_rest(const Eigen::Vector3d& specific_force) noexcept {
  const Eigen::Vector3d& f = specific_force;
  return {std::atan2(f.y(), f.z()), std::atan2(-f.x(), std::hypot(f.y(), f.z()))};
}

// Against gravity, in the axes of a body with this roll and pitch.
[[nodiscard]] inline Eigen::Vector3d up_at_tilt(const Eigen::Vector2d& roll_pitch) noexcept {
  const double roll = roll_pitch.x(), pitch = roll_pitch.y();
  return {-std::sin(pitch), std::sin(roll) * std::cos(pitch), std::cos(roll) * std::cos(pitch)};
}

// How fast roll, pitch and yaw change with an angular velocity in the body's own axes. Near a pitch of a
// quarter turn, where yaw means nothing, no faster than at 84 degrees.
[[nodiscard]] inline Eigen::Vector3d attitude_rate(const Eigen::Vector3d& roll_pitch_yaw,
                                                   const Eigen::Vector3d& angular_velocity) noexcept {
  constexpr double kLeastCosine = 0.1;
  const double sine = std::sin(roll_pitch_yaw.x()), cosine = std::cos(roll_pitch_yaw.x());
  const double cosine_pitch = std::max(std::cos(roll_pitch_yaw.y()), kLeastCosine);
  const double yaw_rate = (angular_velocity.y() * sine + angular_velocity.z() * cosine) / cosine_pitch;
  return {angular_velocity.x() + std::sin(roll_pitch_yaw.y()) * yaw_rate,
          angular_velocity.y() * cosine - angular_velocity.z() * sine, yaw_rate};
}

}  // namespace gaitway::geometry
