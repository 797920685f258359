// Topics of the memory block -> ROS messages.
#include "gaitway/api/state_messages.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <string_view>

#include "gaitway/api/frame_messages.hpp"

namespace gaitway::api {
namespace {

constexpr std::array<std::string_view, 5> kStates{"none", "approaching", "playing", "leaving", "unknown"};
constexpr std::array<std::string_view, 5> kResults{"none", "finished", "left", "broken off", "unknown"};
constexpr std::array<std::string_view, 5> kWayStates{"idle", "plans", "walks", "waits", "unknown"};
constexpr std::array<std::string_view, 5> kWayResults{"none", "arrived", "cancelled", "refused", "failed"};

std::string name_in(const std::array<std::string_view, 5>& names, std::uint32_t value) {
  return std::string(names[std::min<std::size_t>(value, names.size() - 1)]);
}

constexpr std::uint8_t kInfo = 20, kWarning = 30, kError = 40;
// [core::EventKind]: info, warning, error, fault, refusal.
constexpr std::array<std::uint8_t, 5> kLevels{kInfo, kWarning, kError, kError, kWarning};

}  // namespace

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

ros::WrenchStamped make_foot_wrench(const urdf::RobotModel& model, urdf::Side side) {
  ros::WrenchStamped message;
  message.header.frame_id = sole_frame(model, side);
  return message;
}

void fill(ros::WrenchStamped& message, const FootForces& forces, const urdf::RobotModel& model,
          urdf::Side side) noexcept {
  const auto foot = static_cast<std::size_t>(side);
  message.header.stamp = ros_time(forces.stamp_ns);
  message.wrench = {};
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    const double force_N = forces.force[foot][cell];
    const Eigen::Vector2d& place_m = model.feet[foot].cell_m[cell];
    message.wrench.force.z += force_N;
    message.wrench.torque.x += place_m.y() * force_N;
    message.wrench.torque.y -= place_m.x() * force_N;
  }
}

ros::MotionState motion_state_of(const gaitway::MotionState& motion) {
  ros::MotionState message;
  message.header.stamp = ros_time(motion.stamp_ns);
  message.motion = text_of(motion.name);
  message.state = name_in(kStates, motion.state);
  message.time = motion.time;
  message.duration = motion.duration;
  message.ended = motion.ended;
  message.result = name_in(kResults, motion.result);
  return message;
}

ros::WayState way_state_of(const NavigationState& navigation) {
  ros::WayState message;
  message.header.stamp = ros_time(navigation.stamp_ns);
  message.state = name_in(kWayStates, navigation.state);
  message.result = name_in(kWayResults, navigation.result);
  message.text = text_of(navigation.text);
  message.steps_left = navigation.steps_left;
  message.replans = navigation.replans;
  message.distance_left = navigation.distance_left;
  message.goal.assign(std::begin(navigation.goal), std::end(navigation.goal));
  message.pose.assign(std::begin(navigation.pose), std::end(navigation.pose));
  message.pose_deviation.assign(std::begin(navigation.pose_deviation), std::end(navigation.pose_deviation));
  return message;
}

ros::BusSlot bus_slot_of(const gaitway::BusSlot& slot) {
  ros::BusSlot message;
  message.header.stamp = ros_time(slot.stamp_ns);
  message.cycle = slot.cycle;
  message.slot = static_cast<std::uint8_t>(slot.slot);
  const std::size_t count = std::min<std::size_t>(slot.frame_count, kSlotFrames);
  message.id.assign(slot.id, slot.id + count);
  message.end_us.assign(slot.end_us, slot.end_us + count);
  message.length_us.assign(slot.length_us, slot.length_us + count);
  message.left_out = slot.left_out;
  return message;
}

ros::Log log_of(const Event& event) {
  ros::Log log;
  log.stamp = ros_time(event.stamp_ns);
  log.level = kLevels[std::min<std::size_t>(event.kind, kLevels.size() - 1)];
  log.name = text_of(event.source);
  log.msg = text_of(event.text);
  return log;
}

ros::Log log_of_missed(std::uint64_t count, std::int64_t stamp_ns) {
  ros::Log log;
  log.stamp = ros_time(stamp_ns);
  log.level = kWarning;
  log.name = "api";
  log.msg = fmt::format("{} events came faster than they were read, and were missed", count);
  return log;
}

}  // namespace gaitway::api
