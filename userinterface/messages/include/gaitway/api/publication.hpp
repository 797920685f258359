// What the robot publishes: the table of topics, and the forms in which their messages go out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "gaitway/api/command_messages.hpp"
#include "gaitway/api/ros_messages.hpp"

namespace gaitway::api {

enum class Topic : std::uint8_t {
  joint_states,
  imu,
  left_wrench,
  right_wrench,
  zmp,
  reference_zmp,
  com,
  odometry,
  transforms,
  footsteps,
  motion_state,
  way_state,
  robot_state,
  walk_command,
  commander,
  link_state,
  certificate_state,
  robot_description,
  clock,
  diagnostics,
  bus_slot,
  events,
  rosout,
  simulation_state,
  twin_state,
  command_state,
  behaviour_state,
  behaviour_nodes
};

struct TopicRow {
  Topic topic;
  std::string_view name;
  std::string_view type;
  double rate_hz;          // 0: on change
  bool latched;            // a new subscriber gets the last message at once
  std::string_view frame;  // its name, or what it is where the robot's description names it
  std::string_view doc;
  bool of_simulation = false;  // a real robot does not publish it
};

inline constexpr std::array kTopics{
    TopicRow{Topic::joint_states, "/joint_states", ros::JointState::kName, 100.0, false, "",
             "Measured position [rad], velocity [rad/s] and motor torque [N m] of every joint"},
    TopicRow{Topic::imu, "/imu/data", ros::Imu::kName, 100.0, false, "the IMU's link",
             "Of the link that bears the IMU: angular velocity [rad/s], specific force [m/s^2]; orientation "
             "as estimated"},
    TopicRow{
        Topic::left_wrench, "/foot/left/wrench", ros::WrenchStamped::kName, 100.0, false, "left_sole",
        "Force [N] and torque [N m] that the force cells of the left foot measure, about its sole frame"},
    TopicRow{Topic::right_wrench, "/foot/right/wrench", ros::WrenchStamped::kName, 100.0, false, "right_sole",
             "The same of the right foot"},
    TopicRow{Topic::zmp, "/zmp", ros::PointStamped::kName, 100.0, false, "odom",
             "Measured zero-moment point [m]"},
    TopicRow{Topic::reference_zmp, "/zmp/reference", ros::PointStamped::kName, 100.0, false, "odom",
             "Planned zero-moment point [m] at this instant"},
    TopicRow{Topic::com, "/com", ros::PointStamped::kName, 100.0, false, "odom",
             "Estimated centre of mass [m]"},
    TopicRow{Topic::odometry, "/odom", ros::Odometry::kName, 100.0, false, "odom",
             "Pose of the base, by dead reckoning with feet, joints and gyro; twist in the base's frame"},
    TopicRow{Topic::transforms, "/tf", ros::TFMessage::kName, 100.0, false, "",
             "odom to base, and base to every link, from the measured joints"},
    TopicRow{Topic::footsteps, "/footsteps", ros::PoseArray::kName, 0.0, true, "odom",
             "Planned footsteps that have not landed yet"},
    TopicRow{Topic::motion_state, "/motion_state", ros::MotionState::kName, 0.0, true, "",
             "Which key-frame motion plays, how far it is [s], and how the last one ended"},
    TopicRow{
        Topic::way_state, "/walk_to/state", ros::WayState::kName, 0.0, true, "",
        "How far the robot is on its way to a place, where it thinks that it is in the world, and how the "
        "last way ended; with each batch while there is one, else as that or its place changes"},
    TopicRow{Topic::robot_state, "/robot_state", ros::RobotState::kName, 0.0, true, "",
             "What the robot does: \"stands\", \"walks\", \"plays\" a motion, \"stops\" by its safe tail, is "
             "\"stopped\" by an emergency stop, \"falls\", has \"fallen\", or is \"gone\""},
    TopicRow{Topic::walk_command, "/walk/command", ros::TwistStamped::kName, 0.0, true, "",
             "Velocity that the robot was told to walk with over this API (/cmd_vel), at each change, and 0 "
             "when it holds no more: 0.5 s without a word, a stop, another order. What the robot makes of it "
             "is on /odom"},
    TopicRow{Topic::commander, "/commander", ros::String::kName, 0.0, true, "",
             "Name of who has the command; empty: nobody"},
    TopicRow{Topic::link_state, "/link_state", ros::LinkState::kName, 0.0, true, "",
             "Whether the module has the main controller at the other end of its link, since when, and if "
             "not, why; "
             "each second while it has not"},
    TopicRow{
        Topic::certificate_state, "/certificate_state", ros::String::kName, 0.0, true, "",
        "What is wrong with the dates of the module's certificate, from two weeks before its end; empty: "
        "nothing"},
    TopicRow{Topic::robot_description, "/robot_description", ros::String::kName, 0.0, true, "",
             "The robot's URDF"},
    TopicRow{Topic::clock, "/clock", ros::Clock::kName, 100.0, false, "", "The robot's clock"},
    TopicRow{Topic::diagnostics, "/diagnostics", ros::DiagnosticArray::kName, 1.0, true, "",
             "Plug-ins, bus, nodes and loop"},
    TopicRow{
        Topic::bus_slot, "/bus_slot", ros::BusSlot::kName, 4.0, false, "",
        "What was on the bus in one time slot of 25: of each frame its identifier (bit 31: extended, bit 30: "
        "remote; bit 29 alone: an error was signalled), its last bit from the slot's edge, and its length. "
        "The page's "
        "`/bus.json` says what is meant to be there"},
    TopicRow{
        Topic::events, "/events", ros::Log::kName, 0.0, false, "",
        "The main controller's events, as they happen; what is said again within 10 s is told once for all"},
    TopicRow{Topic::rosout, "/rosout", ros::Log::kName, 0.0, false, "",
             "The same as /events, where tools of ROS look for it"},
    TopicRow{
        Topic::simulation_state, "/simulation/state", ros::SimulationState::kName, 10.0, false,
        "the simulator's world",
        "Where the simulation is in its time, whether it plays, where the robot truly is, and what is in "
        "its world. By the computer's clock, so it comes while the simulation is paused, too; of a "
        "simulator that takes orders (`gaitway simulator`) alone",
        true},
    TopicRow{Topic::twin_state, "/simulation/twin", ros::TwinState::kName, 10.0, false,
             "the simulator's world",
             "The real robot whose twin this simulation is (`gaitway simulator --robot ws://...`): what it "
             "measures, how the simulated one differs from it, and what is being sent to it. By the "
             "computer's clock",
             true},
    TopicRow{
        Topic::command_state, "/command/state", ros::CommandState::kName, 0.0, true, "",
        "Who commands the robot, why and since when: emergency stop before person before behaviour before "
        "nobody. A person's order, stop or /command/take makes it the person; /command/let_go gives it "
        "back. Not which client of this API has its command: that is /commander"},
    TopicRow{
        Topic::behaviour_state, "/behaviour/state", ros::BehaviourState::kName, 0.0, true, "",
        "The behaviour tree: its mission, what each node was at its last tick, and the newest transitions; "
        "as it changes, and each second. Of a robot with the plug-in `behaviour` alone"},
    TopicRow{Topic::behaviour_nodes, "/behaviour/nodes", ros::BehaviourNodes::kName, 0.0, true, "",
             "How the behaviour tree is built, once for each tree, when all of it is known"},
};
inline constexpr std::size_t kTopicCount = kTopics.size();

[[nodiscard]] constexpr const TopicRow& row(Topic topic) noexcept {
  return kTopics[static_cast<std::size_t>(topic)];
}

enum class Encoding : std::uint8_t {
  json,
  cbor,
  cbor_raw  // an envelope of CBOR around the message in ROS 2's own encoding (CDR)
};
inline constexpr std::size_t kEncodings = 3;

[[nodiscard]] constexpr bool is_binary(Encoding encoding) noexcept {
  return encoding != Encoding::json;
}

}  // namespace gaitway::api
