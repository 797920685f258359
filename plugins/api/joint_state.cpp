// JointStates -> sensor_msgs/JointState.
#include <algorithm>

#include "gaitway/api/ros_time.hpp"
#include "gaitway/api/sensor_messages.hpp"

namespace gaitway::api {

ros::JointState make_joint_state(const urdf::RobotModel& model) {
  ros::JointState message;
  for (const urdf::Joint& joint : model.joints) message.name.push_back(joint.name);
  message.position.resize(model.joints.size());
  message.velocity.resize(model.joints.size());
  message.effort.resize(model.joints.size());
  return message;
}

void fill(ros::JointState& message, const JointStates& joints) noexcept {
  message.header.stamp = ros_time(joints.stamp_ns);
  const std::size_t count = std::min<std::size_t>(message.name.size(), kMaxJoints);
  std::copy_n(joints.position, count, message.position.begin());
  std::copy_n(joints.velocity, count, message.velocity.begin());
  std::copy_n(joints.torque, count, message.effort.begin());
}

}  // namespace gaitway::api
