// Gathers one time slot's feedback frames into the topics that everybody reads: joint states, foot forces,
// IMU. What comes from other sensors than the topics speak of is turned into theirs here, so that nobody else
// need know: a six-axis sensor speaks as four force cells, gyro and accelerometer as an inclinometer, an IMU
// that is turned in its link along the link's axes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gaitway/can/messages.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::msgcontroller {

class FeedbackCollector {
 public:
  // `nodes`: of all joints; 0 for joints that are not on the bus and hold still.
  FeedbackCollector(const urdf::RobotModel& robot, std::span<const can::NodeId> nodes);

  // A new time slot begins: from now on its feedback is awaited, but for that of joints that are missing.
  void begin_slot(std::uint32_t slot_since_start) noexcept;
  // Takes one joint's feedback into the topics' values.
  void take(int joint, const can::Feedback& feedback, std::int64_t now_ns) noexcept;

  [[nodiscard]] bool complete() const noexcept { return awaited_ == 0; }
  // Bit i: joint i has sent nothing for two slots or more.
  [[nodiscard]] std::uint64_t missing() const noexcept;

  [[nodiscard]] JointStates& joint_states() noexcept { return joint_states_; }
  [[nodiscard]] const FootForces& foot_forces() const noexcept { return foot_forces_; }
  [[nodiscard]] const Imu& imu() const noexcept { return imu_; }
  // Roll and pitch of the trunk against gravity: of an inclinometer that tells them, else by gyro and
  // accelerometer.
  [[nodiscard]] const Eigen::Vector2d& tilt_rad() const noexcept { return tilt_rad_; }

 private:
  void take_wrench(const urdf::SensorChannel& channel, double value) noexcept;
  void derive_tilt(const urdf::SensorChannel& channel) noexcept;
  void take_channel(const urdf::SensorChannel& channel, double value, std::int64_t now_ns) noexcept;

  int joint_count_;
  std::vector<std::array<urdf::SensorChannel, 2>> channels_;
  std::uint32_t slot_ = 0;
  std::uint64_t on_bus_ = 0;                           // bit i: joint i sends feedback
  std::uint64_t awaited_ = 0;                          // of these, in this slot
  std::array<std::uint32_t, kMaxJoints> last_slot_{};  // in which the joint was heard last
  JointStates joint_states_{};
  std::array<urdf::Foot, 2> feet_;  // [Side]
  std::array<urdf::Wrench, 2> wrench_{urdf::Wrench::Zero(), urdf::Wrench::Zero()};
  bool has_inclinometer_;  // without one the topic has what is derived from gyro and accelerometer
  bool tells_tilt_;        // and not apparent gravity
  Eigen::Vector2d tilt_rad_ = Eigen::Vector2d::Zero();
  unsigned imu_channels_ = 0;    // of the gyro and the accelerometer, that have come since the last time
  std::uint32_t tilt_slot_ = 0;  // in which they were derived; 0: never
  FootForces foot_forces_{};
  // The IMU's channels come along its own axes, one joint's after the other; the topic has the link's.
  struct Sensed {
    Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero(), acceleration = Eigen::Vector3d::Zero();
    Eigen::Vector2d inclination = Eigen::Vector2d::Zero();
  };
  urdf::Imu sensor_;
  Sensed sensed_;
  Imu imu_{};
};

}  // namespace gaitway::msgcontroller
