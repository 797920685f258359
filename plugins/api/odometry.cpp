// RobotFrames -> nav_msgs/Odometry.
#include "gaitway/api/frame_messages.hpp"
#include "gaitway/api/frame_names.hpp"
#include "gaitway/api/ros_time.hpp"

namespace gaitway::api {

ros::Odometry make_odometry(const urdf::RobotModel& model) {
  ros::Odometry message;
  message.header.frame_id = kOdomFrame;
  message.child_frame_id = model.links.front().name;
  return message;
}

void fill(ros::Odometry& message, const RobotFrames& frames, std::int64_t stamp_ns) noexcept {
  const Eigen::Vector3d& place = frames.odom_from_base().translation();
  const Eigen::Quaterniond turn(frames.odom_from_base().linear());
  const Eigen::Vector3d& linear = frames.linear_velocity_m_per_s();
  const Eigen::Vector3d& angular = frames.angular_velocity_rad_per_s();
  message.header.stamp = ros_time(stamp_ns);
  message.pose.pose.position = {place.x(), place.y(), place.z()};
  message.pose.pose.orientation = {turn.x(), turn.y(), turn.z(), turn.w()};
  message.twist.twist.linear = {linear.x(), linear.y(), linear.z()};
  message.twist.twist.angular = {angular.x(), angular.y(), angular.z()};
}

}  // namespace gaitway::api
