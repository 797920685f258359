// Batches from a bus log: its frames are fed to the joints' own controllers, and what these play is read once
// a slot, in counts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gaitway/can/message_layout.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/simulator/joint_network.hpp"
#include "tools/bus/log_input.hpp"
#include "tools/simulate/trajectory_source.hpp"

namespace gaitway::tools {
namespace {

constexpr int kCountHalfWindow = 5;

// Joints that are where their references are: then no servo saturates, and no encoder is implausible.
void follow_references(const urdf::RobotModel& robot, const simulator::JointNetwork& joints,
                       simulator::PlantSensors& sensors) {
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const urdf::Joint& joint = robot.joints[j];
    sensors.encoder_count[j] = static_cast<std::int32_t>(
        std::lround((joints.joint(static_cast<int>(j)).reference_rad() + joint.encoder_zero_rad) /
                    joint.encoder_count_rad));
  }
}

bool from_a_joint(const can::Profile& profile, const can::Frame& frame) {
  const auto message = frame.extended || frame.remote ? std::nullopt : profile.identify(frame.id);
  return message && can::layout(message->kind).sender == can::Sender::local_controller;
}

}  // namespace

kinematic::Trajectory read_bus_log_trajectory(const urdf::RobotModel& robot,
                                              const std::filesystem::path& file) {
  const can::Profile profile = msgcontroller::network_profile(robot);
  const RobotLog log = read_robot_log(file, profile);
  kinematic::Trajectory trajectory{.name = file.filename().string(),
                                   .kind = "bus log",
                                   .joint_count = robot.joints.size(),
                                   .start_s = facts::kSlot_s};
  trajectory.half_window = kCountHalfWindow;
  trajectory.rounding_counts = 0.5;
  trajectory.points_of_wire = trajectory.leads_joints = true;
  trajectory.notes.emplace_back(
      "what is played are the batches' points, without trims; they lead the joints by what the load takes, "
      "so soles "
      "and ZMPs that are made of them are told, not judged");
  simulator::JointNetwork joints(robot, 0, 0.0);
  simulator::PlantSensors sensors;
  sensors.encoder_count.assign(robot.joints.size(), 0);
  auto next = log.frames.begin();
  for (std::int64_t now_ns = 0; next != log.frames.end(); now_ns += facts::kMillisecond_ns) {
    follow_references(robot, joints, sensors);
    joints.step(now_ns, sensors);
    for (; next != log.frames.end() && next->time_ns <= now_ns + facts::kMillisecond_ns; ++next) {
      if (next->error || from_a_joint(profile, next->frame)) continue;
      for (int joint = 0; joint < joints.size(); ++joint) joints.on_frame(joint, next->frame, next->time_ns);
    }
    // In a slot's last millisecond a joint's count is that of the slot's end.
    if ((now_ns + facts::kMillisecond_ns) % facts::kSlot_ns != 0) continue;
    for (std::size_t j = 0; j < robot.joints.size(); ++j)
      trajectory.joint_rad.push_back(joints.joint(static_cast<int>(j)).reference_count() *
                                     robot.joints[j].count_rad);
  }
  if (log.shift_ns != 0) {
    trajectory.notes.push_back(fmt::format("the log does not begin at time 0: {:.3f} s taken off its times",
                                           static_cast<double>(log.shift_ns) * 1e-9));
  }
  return trajectory;
}

}  // namespace gaitway::tools
