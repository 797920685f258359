// Where the camera was when a picture was taken: the robot's posture and place of the last second,
// remembered.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::vision {

struct CameraPose {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // of the camera's optical frame in odometry
  Eigen::Vector2d base_m = Eigen::Vector2d::Zero();        // of the robot's base, in odometry
  bool upright = true;  // the robot stands or walks; otherwise the pose says little
};

// Filled at each tick, asked at the stamps of pictures. Nothing allocates after construction.
class CameraHistory {
 public:
  // `camera`: pose of the optical frame in the link `link` (index) of the robot.
  CameraHistory(const urdf::RobotModel& robot, int link, const Eigen::Isometry3d& camera);

  // Joints and estimate of one tick. The joints measured at the edge of the slot in which their frames came.
  // Values that are not finite, of another robot, or no newer than the last ones are left out.
  void add(const JointStates& joints, const Estimate& estimate) noexcept;

  // Between the two moments around the stamp; nothing before the first, or after the last by more than 10 ms.
  [[nodiscard]] std::optional<CameraPose> at(std::int64_t stamp_ns) const noexcept;

 private:
  struct Moment {
    std::int64_t stamp_ns = 0;
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
    Eigen::Vector2d base_m = Eigen::Vector2d::Zero();
    bool upright = true;
  };
  static constexpr std::size_t kRemembered = 100;  // of 10 ms

  [[nodiscard]] const Moment& back(std::size_t steps) const noexcept {
    return moments_[(count_ - 1 - steps) % kRemembered];
  }

  urdf::ForwardKinematics kinematics_;
  std::size_t joint_count_;
  int link_, trunk_;
  Eigen::Isometry3d camera_;
  std::array<Moment, kRemembered> moments_{};
  std::size_t count_ = 0;  // since the start
};

}  // namespace gaitway::vision
