// The state of the robot as ROS messages: joints, IMU, foot forces, motion, events. Messages of the sensors
// are made once, with all that never changes (names, frames, sizes), and filled for every value: filling does
// not allocate.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "gaitway/api/ros_messages.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {

[[nodiscard]] ros::JointState make_joint_state(const urdf::RobotModel& model);
// `message`: of make_joint_state().
void fill(ros::JointState& message, const JointStates& joints) noexcept;

// In the frame of the link that carries the sensors, whose axes they share.
[[nodiscard]] ros::Imu make_imu(const urdf::RobotModel& model);
// Orientation: roll and pitch of that link against gravity; the yaw is the gyro's, integrated since the
// start, and drifts against that of /odom. Without `estimate` (nullptr) it is not known, and
// orientation_covariance[0] is -1, as sensor_msgs/Imu has it. The other covariances are not known: 0.
void fill(ros::Imu& message, const gaitway::Imu& imu, const Estimate* estimate) noexcept;

// In the sole frame of that foot, about its origin.
[[nodiscard]] ros::WrenchStamped make_foot_wrench(const urdf::RobotModel& model, urdf::Side side);
// The cells measure vertical forces only: force z = Σ f, torque x = Σ y·f, torque y = −Σ x·f; the rest is 0.
void fill(ros::WrenchStamped& message, const FootForces& forces, const urdf::RobotModel& model,
          urdf::Side side) noexcept;

[[nodiscard]] ros::MotionState motion_state_of(const gaitway::MotionState& motion);
[[nodiscard]] ros::WayState way_state_of(const NavigationState& navigation);

[[nodiscard]] ros::BusSlot bus_slot_of(const gaitway::BusSlot& slot);

[[nodiscard]] ros::Log log_of(const Event& event);
// Of events that came faster than they were read.
[[nodiscard]] ros::Log log_of_missed(std::uint64_t count, std::int64_t stamp_ns);

template <std::size_t size>
[[nodiscard]] std::string text_of(const std::uint8_t (&bytes)[size]) {
  return {bytes, std::find(bytes, bytes + size, std::uint8_t{0})};
}

}  // namespace gaitway::api
