// Where the CoM and the feet are, seen from a sole, and how well the description of the robot knows it.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <span>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/zmp/attitude_filter.hpp"
#include "gaitway/zmp/estimator_parameters.hpp"

namespace gaitway::zmp {

// The level frame of a foot: origin in the origin of its sole frame, z against gravity, x in the vertical
// plane of the sole's x axis. It is the frame `support` of the topics. A sole that is tilted against gravity,
// because the ground or the foot is, is therefore tilted in its own level frame.
class SupportKinematics {
 public:
  explicit SupportKinematics(const urdf::RobotModel& model) : kinematics_(model), trunk_(model.imu.link) {
    level(Attitude{});
  }

  // position_rad: one angle a joint, in the model's order. Attitude of the link that carries the IMU.
  void update(std::span<const double> position_rad, const Attitude& attitude) noexcept {
    kinematics_.compute(position_rad);
    level(attitude);
  }
  // The same posture with another attitude.
  void level(const Attitude& attitude) noexcept;

  // CoM in the level frame of a foot, m.
  [[nodiscard]] Eigen::Vector3d com_m(urdf::Side foot) const noexcept;
  // A point of the sole `of` (in its sole frame, z = 0), in the level frame of `foot`, m.
  [[nodiscard]] Eigen::Vector3d sole_point_m(urdf::Side foot, urdf::Side of,
                                             const Eigen::Vector2d& point_m) const noexcept;
  // Origin and heading of the base in the level frame of a foot.
  struct BasePlace {
    Eigen::Vector2d place_m;
    double yaw_rad;
  };
  [[nodiscard]] BasePlace base(urdf::Side foot) const noexcept;
  // Heading of a sole (of its x axis) against the trunk's heading.
  [[nodiscard]] double heading_rad(urdf::Side foot) const noexcept {
    return heading_rad_[static_cast<std::size_t>(foot)];
  }
  // The same in the world, since the start: not continuous while the sole's x axis passes the vertical.
  [[nodiscard]] double world_heading_rad(urdf::Side foot) const noexcept {
    return yaw_rad_ + heading_rad(foot);
  }
  // From a sole frame to its level frame.
  [[nodiscard]] Eigen::Matrix3d sole_tilt(urdf::Side foot) const noexcept {
    const auto i = static_cast<std::size_t>(foot);
    return level_from_base_[i] * base_from_sole_[i].linear();
  }
  // Roll and pitch that the trunk has if both soles, taken together, are level.
  [[nodiscard]] Eigen::Vector2d tilt_on_level_soles() const noexcept;
  // Rotation from the level frame of one foot to that of another: a turn about the vertical.
  [[nodiscard]] Eigen::Matrix3d turn(urdf::Side to, urdf::Side from) const noexcept;

 private:
  urdf::ForwardKinematics kinematics_;
  int trunk_;
  std::array<Eigen::Isometry3d, 2> base_from_sole_;
  std::array<Eigen::Matrix3d, 2> level_from_base_;
  std::array<double, 2> heading_rad_{};
  double yaw_rad_ = 0.0;  // of the trunk, with which the headings were computed
};

// What the robot's description does not know about the robot, and what that does to CoM and feet.
// Standard deviations at the home posture, in the level frame of a foot. No filter makes them smaller: they
// are the same in every sample.
struct ModelUncertainty {
  Eigen::Vector3d com_m = Eigen::Vector3d::Zero();   // from joint zeros, link masses, the trunk's CoM
  Eigen::Vector3d foot_m = Eigen::Vector3d::Zero();  // of the other foot's sole, from joint zeros
};

// Perturbs one joint zero after another, and adds up the squares. Not for real-time paths.
[[nodiscard]] ModelUncertainty model_uncertainty(const urdf::RobotModel& model,
                                                 const EstimatorParameters& parameters);

}  // namespace gaitway::zmp
