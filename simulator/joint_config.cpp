// Copies one joint's part of the robot model into its local controller's configuration.
#include "gaitway/simulator/joint_config.hpp"

#include <cmath>

#include "gaitway/msgcontroller/network_profile.hpp"

namespace gaitway::simulator {

localcontroller::JointConfig joint_config(const urdf::RobotModel& robot, int joint) {
  const auto index = static_cast<std::size_t>(joint);
  const urdf::Joint& source = robot.joints[index];
  localcontroller::JointConfig config;
  config.profile = msgcontroller::network_profile(robot);
  config.node = source.node;
  config.count_rad = source.count_rad;
  config.encoder_count_rad = source.encoder_count_rad;
  config.encoder_zero_rad = source.encoder_zero_rad;
  config.stiffness_Nm_per_rad = source.servo.stiffness_Nm_per_rad;
  config.damping_Nms_per_rad = source.servo.damping_Nms_per_rad;
  config.torque_limit_Nm = source.motor.torque_limit_Nm;
  config.speed_limit_rad_per_s = source.motor.speed_limit_rad_per_s;
  config.lower_rad = source.lower_rad;
  config.upper_rad = source.upper_rad;
  config.initial_reference_count = static_cast<std::int32_t>(std::lround(source.home_rad / source.count_rad));
  config.trim_channel = source.trim_channel;
  config.trim_count_rad = robot.trim.count_rad;
  config.trim_slew_rad_per_s = robot.trim.slew_rad_per_s;
  config.trim_limit_rad = robot.trim.limit_rad;
  for (std::size_t channel = 0; channel < can::kFeedbackChannels; ++channel) {
    config.channel_scale[channel] = static_cast<float>(robot.channels[index][channel].scale);
  }
  return config;
}

}  // namespace gaitway::simulator
