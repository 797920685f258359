// The ROS message types that the API speaks, as plain structs. Each names its fields once, in `fields()`: the
// codecs (JSON, CBOR, CDR), the message definitions, the JSON schemas and the reference all come from there.
//
// A field is a bool, an integer or floating-point number of fixed size, a std::string, another message, or a
// std::vector or std::array of one of these. Names and order are those of the published definitions (ROS 2).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gaitway::api::ros {

// Gives `fields(visit)` as visit("name", member) for each member, const or not.
#define GAITWAY_ROS_MESSAGE(type_name)                 \
  static constexpr std::string_view kName = type_name; \
  template <class Visitor>                             \
  void fields(Visitor&& visit) {                       \
    visit_fields(*this, visit);                        \
  }                                                    \
  template <class Visitor>                             \
  void fields(Visitor&& visit) const {                 \
    visit_fields(*this, visit);                        \
  }                                                    \
  template <class Self, class Visitor>                 \
  static void visit_fields([[maybe_unused]] Self& self, [[maybe_unused]] Visitor& visit)

struct Time {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  GAITWAY_ROS_MESSAGE("builtin_interfaces/msg/Time") {
    visit("sec", self.sec);
    visit("nanosec", self.nanosec);
  }
};

struct Header {
  Time stamp;
  std::string frame_id;
  GAITWAY_ROS_MESSAGE("std_msgs/msg/Header") {
    visit("stamp", self.stamp);
    visit("frame_id", self.frame_id);
  }
};

struct String {
  std::string data;
  GAITWAY_ROS_MESSAGE("std_msgs/msg/String") { visit("data", self.data); }
};

struct Clock {
  Time clock;
  GAITWAY_ROS_MESSAGE("rosgraph_msgs/msg/Clock") { visit("clock", self.clock); }
};

struct Point {
  double x = 0.0, y = 0.0, z = 0.0;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Point") {
    visit("x", self.x);
    visit("y", self.y);
    visit("z", self.z);
  }
};

struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Vector3") {
    visit("x", self.x);
    visit("y", self.y);
    visit("z", self.z);
  }
};

struct Quaternion {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Quaternion") {
    visit("x", self.x);
    visit("y", self.y);
    visit("z", self.z);
    visit("w", self.w);
  }
};

struct Pose {
  Point position;
  Quaternion orientation;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Pose") {
    visit("position", self.position);
    visit("orientation", self.orientation);
  }
};

struct PoseArray {
  Header header;
  std::vector<Pose> poses;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/PoseArray") {
    visit("header", self.header);
    visit("poses", self.poses);
  }
};

struct PointStamped {
  Header header;
  Point point;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/PointStamped") {
    visit("header", self.header);
    visit("point", self.point);
  }
};

struct Twist {
  Vector3 linear, angular;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Twist") {
    visit("linear", self.linear);
    visit("angular", self.angular);
  }
};

struct Wrench {
  Vector3 force, torque;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Wrench") {
    visit("force", self.force);
    visit("torque", self.torque);
  }
};

struct WrenchStamped {
  Header header;
  Wrench wrench;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/WrenchStamped") {
    visit("header", self.header);
    visit("wrench", self.wrench);
  }
};

struct Transform {
  Vector3 translation;
  Quaternion rotation;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/Transform") {
    visit("translation", self.translation);
    visit("rotation", self.rotation);
  }
};

struct TransformStamped {
  Header header;
  std::string child_frame_id;
  Transform transform;
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/TransformStamped") {
    visit("header", self.header);
    visit("child_frame_id", self.child_frame_id);
    visit("transform", self.transform);
  }
};

struct TFMessage {
  std::vector<TransformStamped> transforms;
  GAITWAY_ROS_MESSAGE("tf2_msgs/msg/TFMessage") { visit("transforms", self.transforms); }
};

struct PoseWithCovariance {
  Pose pose;
  std::array<double, 36> covariance{};
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/PoseWithCovariance") {
    visit("pose", self.pose);
    visit("covariance", self.covariance);
  }
};

struct TwistWithCovariance {
  Twist twist;
  std::array<double, 36> covariance{};
  GAITWAY_ROS_MESSAGE("geometry_msgs/msg/TwistWithCovariance") {
    visit("twist", self.twist);
    visit("covariance", self.covariance);
  }
};

struct Odometry {
  Header header;
  std::string child_frame_id;
  PoseWithCovariance pose;
  TwistWithCovariance twist;
  GAITWAY_ROS_MESSAGE("nav_msgs/msg/Odometry") {
    visit("header", self.header);
    visit("child_frame_id", self.child_frame_id);
    visit("pose", self.pose);
    visit("twist", self.twist);
  }
};

struct JointState {
  Header header;
  std::vector<std::string> name;
  std::vector<double> position, velocity, effort;
  GAITWAY_ROS_MESSAGE("sensor_msgs/msg/JointState") {
    visit("header", self.header);
    visit("name", self.name);
    visit("position", self.position);
    visit("velocity", self.velocity);
    visit("effort", self.effort);
  }
};

struct Imu {
  Header header;
  Quaternion orientation;
  std::array<double, 9> orientation_covariance{};
  Vector3 angular_velocity;
  std::array<double, 9> angular_velocity_covariance{};
  Vector3 linear_acceleration;
  std::array<double, 9> linear_acceleration_covariance{};
  GAITWAY_ROS_MESSAGE("sensor_msgs/msg/Imu") {
    visit("header", self.header);
    visit("orientation", self.orientation);
    visit("orientation_covariance", self.orientation_covariance);
    visit("angular_velocity", self.angular_velocity);
    visit("angular_velocity_covariance", self.angular_velocity_covariance);
    visit("linear_acceleration", self.linear_acceleration);
    visit("linear_acceleration_covariance", self.linear_acceleration_covariance);
  }
};

struct KeyValue {
  std::string key, value;
  GAITWAY_ROS_MESSAGE("diagnostic_msgs/msg/KeyValue") {
    visit("key", self.key);
    visit("value", self.value);
  }
};

struct DiagnosticStatus {
  std::uint8_t level = 0;  // 0 OK, 1 WARN, 2 ERROR, 3 STALE
  std::string name, message, hardware_id;
  std::vector<KeyValue> values;
  GAITWAY_ROS_MESSAGE("diagnostic_msgs/msg/DiagnosticStatus") {
    visit("level", self.level);
    visit("name", self.name);
    visit("message", self.message);
    visit("hardware_id", self.hardware_id);
    visit("values", self.values);
  }
};

struct DiagnosticArray {
  Header header;
  std::vector<DiagnosticStatus> status;
  GAITWAY_ROS_MESSAGE("diagnostic_msgs/msg/DiagnosticArray") {
    visit("header", self.header);
    visit("status", self.status);
  }
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
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/MotionState") {
    visit("header", self.header);
    visit("motion", self.motion);
    visit("state", self.state);
    visit("time", self.time);
    visit("duration", self.duration);
    visit("ended", self.ended);
    visit("result", self.result);
  }
};

struct Log {
  Time stamp;
  std::uint8_t level = 20;  // 10 DEBUG, 20 INFO, 30 WARN, 40 ERROR, 50 FATAL
  std::string name, msg, file, function;
  std::uint32_t line = 0;
  GAITWAY_ROS_MESSAGE("rcl_interfaces/msg/Log") {
    visit("stamp", self.stamp);
    visit("level", self.level);
    visit("name", self.name);
    visit("msg", self.msg);
    visit("file", self.file);
    visit("function", self.function);
    visit("line", self.line);
  }
};

}  // namespace gaitway::api::ros
