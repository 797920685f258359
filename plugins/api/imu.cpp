// Imu and Estimate -> sensor_msgs/Imu.
#include <Eigen/Geometry>

#include "gaitway/api/ros_time.hpp"
#include "gaitway/api/sensor_messages.hpp"

namespace gaitway::api {

ros::Imu make_imu(const urdf::RobotModel& model) {
  ros::Imu message;
  message.header.frame_id = model.links[static_cast<std::size_t>(model.imu.link)].name;
  return message;
}

void fill(ros::Imu& message, const gaitway::Imu& imu, const Estimate* estimate) noexcept {
  message.header.stamp = ros_time(imu.stamp_ns);
  message.angular_velocity = {imu.angular_velocity[0], imu.angular_velocity[1], imu.angular_velocity[2]};
  message.linear_acceleration = {imu.acceleration[0], imu.acceleration[1], imu.acceleration[2]};
  message.orientation = {};
  message.orientation_covariance[0] = estimate != nullptr ? 0.0 : -1.0;
  if (estimate == nullptr) return;
  const Eigen::Quaterniond turn = Eigen::AngleAxisd(estimate->attitude[2], Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(estimate->attitude[1], Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(estimate->attitude[0], Eigen::Vector3d::UnitX());
  message.orientation = {turn.x(), turn.y(), turn.z(), turn.w()};
}

}  // namespace gaitway::api
