// The neck: by which joints the head looks aside and down, and how far.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

// One of its joints. Angles count from where the head looks ahead, which is the home posture: yaw to the
// left, pitch down.
struct NeckJoint {
  int joint = 0;      // index into RobotModel::joints
  double sign = 1.0;  // of the joint's angle, where the head turns that way
  double lowest_rad = 0.0, highest_rad = 0.0;
  double home_rad = 0.0;  // of the joint
  double most_rad_per_s = 0.0;
};

struct Neck {
  std::optional<NeckJoint> yaw, pitch;  // none: the head does not turn that way
  // Where its axes meet, or where its one axis is, in the base's frame at home.
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();

  // Yaw and pitch of the head with all of the robot's joints at these angles; 0 for what it does not turn.
  [[nodiscard]] std::array<double, 2> angles_rad(std::span<const double> joint_rad) const noexcept {
    const auto angle = [&](const std::optional<NeckJoint>& neck) {
      const bool known = neck && static_cast<std::size_t>(neck->joint) < joint_rad.size();
      return known ? neck->sign * (joint_rad[static_cast<std::size_t>(neck->joint)] - neck->home_rad) : 0.0;
    };
    return {angle(yaw), angle(pitch)};
  }
};

// `home`: at the home posture. Throws std::invalid_argument, as BodyJoints does.
[[nodiscard]] Neck neck_of(const RobotModel& model, const ForwardKinematics& home);

}  // namespace gaitway::urdf
