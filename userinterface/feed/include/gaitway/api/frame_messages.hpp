// Poses and points in the frame `odom` as ROS messages. Messages are made once and filled for every value.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/robot_frames.hpp"
#include "gaitway/api/ros_messages.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {

// Fixed to the ground, z = 0 on it; origin between the feet at the start (robot_frames.hpp).
inline constexpr std::string_view kOdomFrame = "odom";
// [Side]: below the ankle on the sole, as the robot's description has it; children of the feet's links.
inline constexpr std::array<std::string_view, 2> kSoleFrames{"left_sole", "right_sole"};
// So they are called, unless a link of the robot is: then with "_frame" behind it.
[[nodiscard]] std::string sole_frame(const urdf::RobotModel& model, urdf::Side side);

[[nodiscard]] ros::Odometry make_odometry(const urdf::RobotModel& model);
// Covariances are not known: 0.
void fill(ros::Odometry& message, const RobotFrames& frames, std::int64_t stamp_ns) noexcept;

// /tf: odom to base, each joint from its parent link to its child, each sole from its foot's link.
class LinkTransforms {
 public:
  explicit LinkTransforms(const urdf::RobotModel& model);
  // position_rad: one angle a joint. `odom_from_base`: nullptr when it is not known; the robot's own tree
  // alone is then in the message. Allocates only when that changes.
  void fill(std::span<const double> position_rad, const Eigen::Isometry3d* odom_from_base,
            std::int64_t stamp_ns);
  [[nodiscard]] const ros::TFMessage& message() const noexcept { return message_; }

 private:
  struct JointFrame {
    Eigen::Vector3d place_m;
    Eigen::Quaterniond turn;  // of the joint's frame in the parent link
    Eigen::Vector3d axis;
  };
  std::vector<JointFrame> joints_;
  ros::TransformStamped base_;  // as it comes last in the message, if it does
  ros::TFMessage message_;
};

[[nodiscard]] ros::PointStamped make_ground_point();
// A point of another frame in `odom`.
void fill(ros::PointStamped& message, const Eigen::Isometry3d& odom_from_frame,
          const Eigen::Vector3d& point_m, std::int64_t stamp_ns) noexcept;

// The planned footsteps that have not landed yet.
class Footsteps {
 public:
  Footsteps();
  // Tells whether the footsteps differ from those of the last call, in the frame `plan`; the message is made
  // anew in that case alone.
  [[nodiscard]] bool update(const PlannedState& planned, const Eigen::Isometry3d& odom_from_plan);
  [[nodiscard]] const ros::PoseArray& message() const noexcept { return message_; }

 private:
  std::vector<Eigen::Vector3d> steps_;  // x, y, yaw in `plan`
  ros::PoseArray message_;
};

}  // namespace gaitway::api
