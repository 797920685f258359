// Decoded feedback into SI units, channel by channel as the network file maps them.
#include "gaitway/msgcontroller/feedback_collector.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/tilt.hpp"

namespace gaitway::msgcontroller {
namespace {

constexpr double kPositionCount_rad = 2.0 * std::numbers::pi / 65536.0;
constexpr double kCurrentCount_Nm = 0.125;
constexpr double kTiltTime_s = 0.5;       // gyro in less, accelerometer in more
constexpr double kAtRest_m_per_s2 = 1.0;  // of a specific force's length from gravity's
constexpr std::uint32_t kLongestGap_slots = 10;
using facts::kSlot_s;

}  // namespace

FeedbackCollector::FeedbackCollector(const urdf::RobotModel& robot, std::span<const can::NodeId> nodes)
    : joint_count_(static_cast<int>(robot.joints.size())),
      channels_(robot.channels),
      feet_(robot.feet),
      has_inclinometer_(robot.carries(urdf::SensorKind::inclination)),
      tells_tilt_(robot.senses_tilt()),
      sensor_(robot.imu) {
  joint_states_.joint_count = static_cast<std::uint32_t>(joint_count_);
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    joint_states_.position[joint] = robot.joints[joint].home_rad;
    joint_states_.reference_position[joint] = robot.joints[joint].home_rad;
    on_bus_ |= nodes[joint] != 0 ? std::uint64_t{1} << joint : 0U;
  }
}

void FeedbackCollector::begin_slot(std::uint32_t slot_since_start) noexcept {
  slot_ = slot_since_start;
  awaited_ = on_bus_ & ~missing();
}

void FeedbackCollector::take(int joint, const can::Feedback& feedback, std::int64_t now_ns) noexcept {
  const auto j = static_cast<std::size_t>(joint);
  const double position = feedback.position * kPositionCount_rad;
  const std::uint32_t slots = slot_ - last_slot_[j];
  if (slots > 0) {
    joint_states_.velocity[j] =
        last_slot_[j] == 0 ? 0.0
                           : (position - joint_states_.position[j]) / (kSlot_s * static_cast<double>(slots));
    last_slot_[j] = slot_;
  }
  joint_states_.position[j] = position;
  joint_states_.torque[j] = feedback.current * kCurrentCount_Nm;
  joint_states_.stamp_ns = now_ns;
  joint_states_.slot = slot_;
  for (std::size_t channel = 0; channel < 2; ++channel) {
    const urdf::SensorChannel& description = channels_[j][channel];
    take_channel(description, feedback.channel[channel] * description.scale / description.gain, now_ns);
  }
  awaited_ &= ~(std::uint64_t{1} << static_cast<unsigned>(joint));
}

void FeedbackCollector::take_channel(const urdf::SensorChannel& channel, double value,
                                     std::int64_t now_ns) noexcept {
  const auto side = static_cast<std::size_t>(channel.side);
  const auto index = static_cast<std::size_t>(channel.index);
  using Sensor = urdf::SensorKind;
  switch (channel.kind) {
    case Sensor::none:
      return;
    case Sensor::force_cell:
      foot_forces_.force[side][index] = value;
      foot_forces_.stamp_ns = now_ns;
      return;
    case Sensor::foot_acceleration:
      foot_forces_.acceleration[side][index] = value;
      foot_forces_.stamp_ns = now_ns;
      return;
    case Sensor::foot_wrench:
      take_wrench(channel, value);
      foot_forces_.stamp_ns = now_ns;
      return;
    case Sensor::angular_velocity:
      sensed_.angular_velocity[channel.index] = value;
      Eigen::Map<Eigen::Vector3d>(imu_.angular_velocity) =
          sensor_.angular_velocity_in_link(sensed_.angular_velocity);
      derive_tilt(channel);
      break;
    case Sensor::acceleration:
      sensed_.acceleration[channel.index] = value;
      Eigen::Map<Eigen::Vector3d>(imu_.acceleration) = sensor_.specific_force_in_link(sensed_.acceleration);
      derive_tilt(channel);
      break;
    case Sensor::inclination:
      sensed_.inclination[channel.index] = value;
      Eigen::Map<Eigen::Vector2d>(imu_.inclination) = sensor_.tilt_in_link(sensed_.inclination);
      if (tells_tilt_) tilt_rad_ = Eigen::Map<Eigen::Vector2d>(imu_.inclination);
      break;
  }
  imu_.stamp_ns = now_ns;
}

void FeedbackCollector::take_wrench(const urdf::SensorChannel& channel, double value) noexcept {
  const std::size_t side = index_of(channel.side);
  wrench_[side][channel.index] = value;
  std::ranges::copy(feet_[side].cell_forces_N(wrench_[side]), foot_forces_.force[side]);
}

// By the gyro, and slowly towards what the accelerometer says while the robot is about at rest.
void FeedbackCollector::derive_tilt(const urdf::SensorChannel& channel) noexcept {
  constexpr unsigned kAll = 0x3F;
  if (tells_tilt_) return;
  const int first = channel.kind == urdf::SensorKind::acceleration ? 3 : 0;
  imu_channels_ |= 1U << static_cast<unsigned>(first + channel.index);
  if (imu_channels_ != kAll) return;
  imu_channels_ = 0;
  const Eigen::Map<const Eigen::Vector3d> rate(imu_.angular_velocity), force(imu_.acceleration);
  const bool at_rest = std::abs(force.norm() - facts::kGravity_m_per_s2) <= kAtRest_m_per_s2;
  const Eigen::Vector2d felt = geometry::tilt_at_rest(force);
  if (tilt_slot_ == 0) {
    if (!at_rest) return;
    tilt_rad_ = felt;
  } else {
    const double dt_s = kSlot_s * static_cast<double>(std::min(slot_ - tilt_slot_, kLongestGap_slots));
    const Eigen::Vector3d attitude(tilt_rad_.x(), tilt_rad_.y(), 0.0);
    tilt_rad_ += dt_s * geometry::attitude_rate(attitude, rate).head<2>();
    const double share = at_rest ? dt_s / (kTiltTime_s + dt_s) : 0.0;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      tilt_rad_[axis] += share * std::remainder(felt[axis] - tilt_rad_[axis], 2.0 * std::numbers::pi);
    }
  }
  tilt_slot_ = std::max(slot_, 1U);
  if (!has_inclinometer_) Eigen::Map<Eigen::Vector2d>(imu_.inclination) = tilt_rad_;
}

std::uint64_t FeedbackCollector::missing() const noexcept {
  std::uint64_t mask = 0;
  for (int joint = 0; joint < joint_count_; ++joint) {
    const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(joint);
    if ((on_bus_ & bit) != 0 && slot_ - last_slot_[static_cast<std::size_t>(joint)] >= 2) {
      mask |= bit;
    }
  }
  return mask;
}

}  // namespace gaitway::msgcontroller
