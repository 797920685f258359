// Where the robot is in the frame `odom`, by dead reckoning: the support foot (the estimate's) stands still
// on flat ground, the next one comes to stand where the measured joints have it, and the heading is the
// gyro's.
//
// On the support foot stands its *level frame*, in which the estimate's ZMP and CoM are: origin in the
// sole's, x along the sole, z up. Roll and pitch of the base are the estimate's (trunk against gravity, over
// the waist's joints); its yaw is what the trunk has turned since the start, so that a foot that turns on the
// ground is seen. (Walking in curves, the planner's own heading is soon wrong by tens of degrees: it takes
// the feet not to turn.) It begins where the robot's own odometry is: whoever looks on from later on, or
// anew, sees the robot where it was. (Without one, the middle between the feet is the origin, and x points
// ahead.) The pose has no jumps; it drifts by what feet slide.
//
// The planner's frame `plan` is laid over it so that the support foot is where it was planned to stand:
// footsteps and reference ZMP then lie at the feet in the picture.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {

// After construction nothing allocates.
class RobotFrames {
 public:
  explicit RobotFrames(const urdf::RobotModel& model);

  // position_rad, velocity_rad_per_s: one value a joint, measured at `instant_ns`. `planned`: at that
  // instant; nullptr without a plan.
  void update(std::int64_t instant_ns, std::span<const double> position_rad,
              std::span<const double> velocity_rad_per_s, const Estimate& estimate,
              const PlannedState* planned) noexcept;
  // The robot's clock began anew: nothing is known.
  void reset() noexcept;

  [[nodiscard]] bool known() const noexcept { return support_.has_value(); }
  [[nodiscard]] const Eigen::Isometry3d& odom_from_base() const noexcept { return odom_from_base_; }
  // The planner's frame `plan` in `odom`.
  [[nodiscard]] const Eigen::Isometry3d& odom_from_plan() const noexcept { return odom_from_plan_; }
  // The frame `support` of the estimate in `odom`.
  [[nodiscard]] const Eigen::Isometry3d& odom_from_support() const noexcept { return odom_from_support_; }
  // Of the base, in the base's frame. Linear: difference of poses against the support foot over one slot,
  // through a low-pass of 30 ms. Angular: the estimate's of the trunk, less what the waist's joints turn.
  [[nodiscard]] const Eigen::Vector3d& linear_velocity_m_per_s() const noexcept { return velocity_m_per_s_; }
  [[nodiscard]] const Eigen::Vector3d& angular_velocity_rad_per_s() const noexcept { return turn_rad_per_s_; }

 private:
  void update_levels(const Estimate& estimate) noexcept;
  void place_support(std::size_t side, const Estimate& estimate) noexcept;
  void update_velocity(std::int64_t instant_ns, std::size_t side,
                       const std::array<Eigen::Isometry3d, 2>& last) noexcept;
  void update_turn(std::span<const double> velocity_rad_per_s, const Estimate& estimate) noexcept;

  struct WaistJoint {
    std::size_t joint = 0;
    int child_link = 0;
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  };

  urdf::ForwardKinematics kinematics_;
  int trunk_;
  std::vector<WaistJoint> waist_;                     // between base and trunk
  std::array<Eigen::Isometry3d, 2> level_from_base_;  // [Side]
  std::array<double, 2> sole_heading_rad_{};          // [Side] against the trunk
  double trunk_heading_rad_ = 0.0;                    // in odom
  double gyro_yaw_rad_ = 0.0;                         // the estimate's, at the last update
  Eigen::Isometry3d odom_from_plan_ = Eigen::Isometry3d::Identity();
  std::optional<std::size_t> support_;  // side; none: not known yet
  std::int64_t instant_ns_ = 0;         // of the last update
  Eigen::Isometry3d odom_from_support_ = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d odom_from_base_ = Eigen::Isometry3d::Identity();
  Eigen::Vector3d velocity_m_per_s_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn_rad_per_s_ = Eigen::Vector3d::Zero();
};

}  // namespace gaitway::api
