// A robot that stands, or glides along, with its head turned: what it says of itself, and where its camera
// is.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/camera_file.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::vision::testing {

class StandingRobot {
 public:
  enum class Pictures { small, large };  // 320 x 240, or the same lenses with 640 x 480
  explicit StandingRobot(Pictures pictures = Pictures::small);

  double head_pitch_rad = 0.35;                     // down
  Eigen::Vector3d speed = Eigen::Vector3d::Zero();  // of the whole robot: m/s ahead, to the left, rad/s
  double sway_m = 0.0, sway_Hz = 0.7;               // to either side, as walking does
  bool fallen = false;

  [[nodiscard]] const urdf::RobotModel& model() const noexcept { return model_; }
  [[nodiscard]] const urdf::StereoCamera& camera() const noexcept { return camera_; }
  // Of a slot's edge.
  [[nodiscard]] JointStates joints(std::int64_t now_ns) const;
  [[nodiscard]] Estimate estimate(std::int64_t now_ns) const;
  // Of the left camera's optical frame in odometry.
  [[nodiscard]] Eigen::Isometry3d camera_pose(std::int64_t now_ns) const;

 private:
  [[nodiscard]] Eigen::Isometry3d ground_pose(std::int64_t now_ns) const;  // of the point between the soles

  urdf::RobotModel model_;
  urdf::StereoCamera camera_;
};

}  // namespace gaitway::vision::testing
