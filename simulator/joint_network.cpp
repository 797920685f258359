// Feeds the plant's sensors to the local controllers and collects their torques.
#include "gaitway/simulator/joint_network.hpp"

#include <cmath>
#include <random>

#include "gaitway/msgcontroller/network_profile.hpp"
#include "motor_model.hpp"

namespace gaitway::simulator {
namespace {

float channel_value(const urdf::SensorChannel& channel, const PlantSensors& sensors) noexcept {
  const auto side = static_cast<std::size_t>(channel.side);
  const auto index = static_cast<std::size_t>(channel.index);
  const auto axis = static_cast<Eigen::Index>(channel.index);
  using Kind = urdf::SensorKind;
  switch (channel.kind) {
    case Kind::none:
      return 0.0F;
    case Kind::force_cell:
      return static_cast<float>(sensors.force_N[side][index]);
    case Kind::foot_acceleration:
      return static_cast<float>(sensors.foot_acceleration_m_per_s2[side][axis]);
    case Kind::angular_velocity:
      return static_cast<float>(sensors.angular_velocity_rad_per_s[axis]);
    case Kind::acceleration:
      return static_cast<float>(sensors.acceleration_m_per_s2[axis]);
    case Kind::inclination:
      return static_cast<float>(sensors.inclination_rad[axis]);
    case Kind::foot_wrench:
      return static_cast<float>(sensors.foot_wrench[side][axis]);
  }
  return 0.0F;
}

}  // namespace

JointNetwork::JointNetwork(const urdf::RobotModel& robot, std::uint64_t seed, double largest_drift_ppm,
                           double mismatch)
    : channels_(robot.channels) {
  std::mt19937_64 random(seed ^ 0xC10C'D21F'7000'0001ULL);
  const ServoFactors servos = draw_servo_factors(robot, seed, mismatch * robot.parts_deviation);
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    configs_.push_back(joint_config(robot, static_cast<int>(joint)));
    configs_.back().stiffness_Nm_per_rad *= servos.stiffness[joint];
    configs_.back().damping_Nms_per_rad *= servos.damping[joint];
    joints_.emplace_back(configs_.back());
    const double unit = static_cast<double>(random() >> 11U) * 0x1.0p-53;  // [0, 1)
    clock_rate_.push_back(1.0 + (2.0 * unit - 1.0) * largest_drift_ppm * 1e-6);
  }
  torque_Nm_.assign(robot.joints.size(), 0.0);
  powered_.assign(robot.joints.size(), true);
}

std::int64_t JointNetwork::local_time_ns(int joint, std::int64_t now_ns) const noexcept {
  return static_cast<std::int64_t>(static_cast<double>(now_ns) *
                                   clock_rate_[static_cast<std::size_t>(joint)]);
}

localcontroller::JointSensors JointNetwork::sensors(int joint, const PlantSensors& plant) const noexcept {
  const auto j = static_cast<std::size_t>(joint);
  localcontroller::JointSensors sensors;
  sensors.encoder_count = plant.encoder_count[j];
  sensors.channel[0] = channel_value(channels_[j][0], plant);
  sensors.channel[1] = channel_value(channels_[j][1], plant);
  if (j < plant.motor_current_Nm.size()) {  // none without a body, when a log alone is played
    sensors.motor_current_Nm = static_cast<float>(plant.motor_current_Nm[j]);
  }
  return sensors;
}

void JointNetwork::step(std::int64_t now_ns, const PlantSensors& plant) noexcept {
  for (int joint = 0; joint < size(); ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    torque_Nm_[j] = powered_[j] ? joints_[j].step(local_time_ns(joint, now_ns), sensors(joint, plant)) : 0.0;
  }
}

void JointNetwork::on_frame(int joint, const can::Frame& frame, std::int64_t now_ns) noexcept {
  if (powered_[static_cast<std::size_t>(joint)]) {
    joints_[static_cast<std::size_t>(joint)].on_frame(frame, local_time_ns(joint, now_ns));
  }
}

void JointNetwork::offer(int joint, can::StationTransmitter& transmitter, can::SimulatedBus& bus,
                         std::int64_t now_ns) noexcept {
  if (powered_[static_cast<std::size_t>(joint)] &&
      bus.state(transmitter.station()) < can::BusState::bus_off) {
    transmitter.offer(bus, joints_[static_cast<std::size_t>(joint)], now_ns);
  }
}

bool JointNetwork::take_frame(int joint, can::Frame& frame) noexcept {
  return powered_[static_cast<std::size_t>(joint)] &&
         joints_[static_cast<std::size_t>(joint)].take_frame(frame);
}

void JointNetwork::power_off(int joint) noexcept {
  powered_[static_cast<std::size_t>(joint)] = false;
}

void JointNetwork::power_on(int joint, const PlantSensors& sensors) noexcept {
  const auto j = static_cast<std::size_t>(joint);
  localcontroller::JointConfig config = configs_[j];
  const double position_rad = sensors.encoder_count[j] * config.encoder_count_rad - config.encoder_zero_rad;
  config.initial_reference_count = static_cast<std::int32_t>(std::lround(position_rad / config.count_rad));
  joints_[j] = localcontroller::JointController(config);
  powered_[j] = true;
}

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
  config.senses_current = robot.parts_deviation > 0.0;
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
