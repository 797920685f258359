// The ROS message types that the API speaks, as plain structs. Each names its fields once: the codecs (JSON,
// CBOR, CDR), the message definitions, the JSON schemas and the reference all come from there.
//
// A field is a bool, an integer or floating-point number of fixed size, a std::string, another message, or a
// std::vector or std::array of one of these. Names and order are those of the published definitions (ROS 2).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "gaitway/api/message_fields.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::api::ros {

struct Time {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  GAITWAY_ROS_MESSAGE("builtin_interfaces/msg/Time", sec, nanosec);
};

struct Header {
  Time stamp;
  std::string frame_id;
  GAITWAY_ROS_MESSAGE("std_msgs/msg/Header", stamp, frame_id);
};

struct String {
  std::string data;
  GAITWAY_ROS_MESSAGE("std_msgs/msg/String", data);
};

struct Clock {
  Time clock;
  GAITWAY_ROS_MESSAGE("rosgraph_msgs/msg/Clock", clock);
};

struct Point {
  double x = 0.0, y = 0.0, z = 0.0;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Point", x, y, z);
};

struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Vector3", x, y, z);
};

struct Quaternion {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Quaternion", x, y, z, w);
};

struct Pose {
  Point position;
  Quaternion orientation;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Pose", position, orientation);
};

struct PoseStamped {
  Header header;
  Pose pose;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/PoseStamped", header, pose);
};

struct PoseArray {
  Header header;
  std::vector<Pose> poses;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/PoseArray", header, poses);
};

struct PointStamped {
  Header header;
  Point point;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/PointStamped", header, point);
};

struct Twist {
  Vector3 linear, angular;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Twist", linear, angular);
};

struct TwistStamped {
  Header header;
  Twist twist;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/TwistStamped", header, twist);
};

struct Accel {
  Vector3 linear, angular;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Accel", linear, angular);
};

struct Wrench {
  Vector3 force, torque;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Wrench", force, torque);
};

struct WrenchStamped {
  Header header;
  Wrench wrench;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/WrenchStamped", header, wrench);
};

struct Transform {
  Vector3 translation;
  Quaternion rotation;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Transform", translation, rotation);
};

struct TransformStamped {
  Header header;
  std::string child_frame_id;
  Transform transform;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/TransformStamped", header, child_frame_id, transform);
};

struct TFMessage {
  std::vector<TransformStamped> transforms;
  GAITWAY_ROS_MESSAGE("tf2_msgs/msg/TFMessage", transforms);
};

struct PoseWithCovariance {
  Pose pose;
  std::array<double, 36> covariance{};
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/PoseWithCovariance", pose, covariance);
};

struct TwistWithCovariance {
  Twist twist;
  std::array<double, 36> covariance{};
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/TwistWithCovariance", twist, covariance);
};

struct Odometry {
  Header header;
  std::string child_frame_id;
  PoseWithCovariance pose;
  TwistWithCovariance twist;
  GAITWAY_ROS_MESSAGE("nav_msgs/msg/Odometry", header, child_frame_id, pose, twist);
};

struct JointState {
  Header header;
  std::vector<std::string> name;
  std::vector<double> position, velocity, effort;
  GAITWAY_ROS_MESSAGE("sensor_msgs/msg/JointState", header, name, position, velocity, effort);
};

struct Imu {
  Header header;
  Quaternion orientation;
  std::array<double, 9> orientation_covariance{};
  Vector3 angular_velocity;
  std::array<double, 9> angular_velocity_covariance{};
  Vector3 linear_acceleration;
  std::array<double, 9> linear_acceleration_covariance{};
  GAITWAY_ROS_MESSAGE("sensor_msgs/msg/Imu", header, orientation, orientation_covariance, angular_velocity,
                      angular_velocity_covariance, linear_acceleration, linear_acceleration_covariance);
};

struct KeyValue {
  std::string key, value;
  GAITWAY_ROS_MESSAGE("diagnostic_msgs/msg/KeyValue", key, value);
};

struct DiagnosticStatus {
  std::uint8_t level = 0;  // 0 OK, 1 WARN, 2 ERROR, 3 STALE
  std::string name, message, hardware_id;
  std::vector<KeyValue> values;
  GAITWAY_ROS_MESSAGE("diagnostic_msgs/msg/DiagnosticStatus", level, name, message, hardware_id, values);
};

struct DiagnosticArray {
  Header header;
  std::vector<DiagnosticStatus> status;
  GAITWAY_ROS_MESSAGE("diagnostic_msgs/msg/DiagnosticArray", header, status);
};

// Which key-frame motion plays, or played last.
struct MotionState {
  Header header;
  std::string motion;
  std::string state;        // "none", "approaching", "playing" or "leaving"
  double time = 0.0;        // s since it began
  double duration = 0.0;    // s, of the whole
  std::uint32_t ended = 0;  // how many motions have ended since the robot's start
  std::string result;       // of the last one that ended: "none", "finished", "left" or "broken off"
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/MotionState", header, motion, state, time, duration, ended, result);
};

// How far the robot is on its way to a place, or what became of the last one.
struct WayState {
  Header header;
  std::string state;  // "idle", "plans", "walks" or "waits"
  std::string
      result;        // of the newest way that has ended: "none", "arrived", "cancelled", "refused", "failed"
  std::string text;  // why it was refused or has failed
  std::uint32_t steps_left = 0;
  std::uint32_t replans = 0;           // of this way
  double distance_left = 0.0;          // m, along the planned footsteps
  std::vector<double> goal;            // x m, y m, yaw rad, in the world
  std::vector<double> pose;            // of the middle between the feet, likewise, estimated
  std::vector<double> pose_deviation;  // standard deviation of its place, m, and heading, rad
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/WayState", header, state, result, text, steps_left, replans,
                      distance_left, goal, pose, pose_deviation);
};

// What the robot does, in a word.
struct RobotState {
  Header header;
  std::string state;
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/RobotState", header, state);
};

// What was on the bus in one time slot.
struct BusSlot {
  Header header;  // the slot's edge
  std::uint32_t cycle = 0;
  std::uint8_t slot = 0;
  // Of each frame: its identifier (bit 31: an extended one, bit 30: a remote frame; bit 29 alone: no frame,
  // but an error); its last bit, since the slot's edge, or when the error was signalled; its length, 0 of an
  // error.
  std::vector<std::uint32_t> id;
  std::vector<std::uint16_t> end_us, length_us;
  std::uint32_t left_out = 0;  // further frames
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/BusSlot", header, cycle, slot, id, end_us, length_us, left_out);
};

// Whether the module has the main controller at the other end of its link.
struct LinkState {
  std::string state;     // "up", "down", or "refused": that lasts until somebody does something about it
  std::string text;      // for people: what is wrong, with values, and what to do; empty: nothing
  std::string link;      // as the module's option --link has it
  double seconds = 0.0;  // for so long
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/LinkState", state, text, link, seconds);
};

// Where a simulation is in its time, and what is in its world. Poses are of the simulator's world: position,
// and orientation as x, y, z, w.
struct SimulationState {
  double time = 0.0;      // s
  double recorded = 0.0;  // s: the last instant that has been simulated, and can be gone to
  std::string state;      // "playing", "paused", "busy" or "failed"
  std::string text;       // for people: what it is busy with, or why it has failed
  double speed = 1.0;     // times real time, as asked
  double pace = 0.0;      // the same as measured
  std::string world;
  std::uint32_t geometry = 0;  // rises when the solids of the world are others
  std::uint32_t run = 0;       // rises when the robot has been put back to another instant
  bool fallen = false;
  std::vector<double> odometry;          // of the frame odom: x m, y m, z m, yaw rad
  std::vector<double> base;              // true pose of the robot's base, seven numbers
  std::vector<std::string> thing_names;  // of what can be moved
  std::vector<Pose> thing_poses;         // where it is now
  std::vector<double> mark_times;        // s; for a time line
  std::vector<std::string> mark_kinds;   // "command", "push", "fault", "world" or "fall"
  std::vector<double> event_times;       // s; the last ones
  std::vector<std::string> event_texts;  // events of a scenario
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/SimulationState", time, recorded, state, text, speed, pace, world,
                      geometry, run, fallen, odometry, base, thing_names, thing_poses, mark_times, mark_kinds,
                      event_times, event_texts);
};

// A real robot beside the simulated one: what it measures, how the two differ, and what is sent to it. Lists
// are empty, and numbers NaN, where nothing is known.
struct TwinState {
  std::string robot;           // its address
  std::string state;           // "connecting", "connected", "lost" or "refused"
  std::string text;            // why it is lost or refused
  double age = 0.0;            // s since its newest measurement has come
  std::string activity;        // as /robot_state has it
  std::string commander;       // who has the command there
  bool follows = false;        // the simulated robot does what that one is told
  std::string follows_text;    // why it does not, where nobody asked for that
  std::vector<double> base;    // measured pose of the base in the simulator's world: x, y, z m, x, y, z, w
  std::vector<double> joints;  // measured, rad, in the order of the description
  double lag = 0.0;            // s that the simulated robot is behind
  std::vector<std::string> channels, units;  // what is compared, in "rad", "N" or "m"
  std::vector<double> measured, simulated;   // of each channel, at the same instant of the motion
  std::vector<double> difference;            // of each channel, RMS over the last 2 s
  std::vector<double> limits;                // of each channel: more is told; 0: never
  std::vector<double> told_times;            // s since the simulator's start
  std::vector<std::string> told_texts;       // the last things that were told
  std::string sending;                       // "idle", "trying", "sending", "done", "not passed", ...
  std::string sending_what, sending_text;    // what is sent, and what came of it, for people
  std::uint32_t passed = 0, tried = 0;       // simulated robots of the newest pre-flight
  std::uint32_t picture = 0;                 // rises with each picture of the worst of them
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/TwinState", robot, state, text, age, activity, commander, follows,
                      follows_text, base, joints, lag, channels, units, measured, simulated, difference,
                      limits, told_times, told_texts, sending, sending_what, sending_text, passed, tried,
                      picture);
};

struct Log {
  Time stamp;
  std::uint8_t level = 20;  // 10 DEBUG, 20 INFO, 30 WARN, 40 ERROR, 50 FATAL
  std::string name, msg, file, function;
  std::uint32_t line = 0;
  GAITWAY_ROS_MESSAGE("rcl_interfaces/msg/Log", stamp, level, name, msg, file, function, line);
};

}  // namespace gaitway::api::ros

namespace gaitway::api {

// Nanoseconds of the robot's clock as a ROS time.
[[nodiscard]] constexpr ros::Time ros_time(std::int64_t time_ns) noexcept {
  using facts::kSecond_ns;
  std::int64_t seconds = time_ns / kSecond_ns;
  std::int64_t rest_ns = time_ns % kSecond_ns;
  if (rest_ns < 0) {
    --seconds;
    rest_ns += kSecond_ns;
  }
  return {static_cast<std::int32_t>(seconds), static_cast<std::uint32_t>(rest_ns)};
}

}  // namespace gaitway::api
