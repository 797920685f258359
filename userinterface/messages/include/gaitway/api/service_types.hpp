// The services that the API offers for the robot, in the style of ros_messages.hpp: a service has a name, a
// Request and a Response. Every response says whether it worked, and if not, why.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/ros_messages.hpp"

namespace gaitway::api::ros {

// A type's name as a template argument.
template <std::size_t size>
struct TypeName {
  // Not explicit: a literal stands for it.
  consteval TypeName(const char (&text)[size]) { std::copy_n(text, size, characters); }
  consteval TypeName(std::string_view start, std::string_view end) {
    std::ranges::copy(end, std::copy(start.begin(), start.end(), characters));
  }
  [[nodiscard]] constexpr std::string_view text() const noexcept { return {characters, size - 1}; }

  char characters[size]{};
};

template <std::size_t a, std::size_t b>
consteval TypeName<a + b - 1> operator+(const TypeName<a>& start, const TypeName<b>& end) {
  return {start.text(), end.text()};
}

template <TypeName name>
inline constexpr std::string_view kTypeName = name.text();

// A service's type. Its request and its response are messages named after it.
template <TypeName name, class RequestFields, class ResponseFields>
struct RosService {
  static constexpr std::string_view kName = kTypeName<name>;
  struct Request : RequestFields {
    static constexpr std::string_view kName = kTypeName<name + TypeName("_Request")>;
  };
  struct Response : ResponseFields {
    static constexpr std::string_view kName = kTypeName<name + TypeName("_Response")>;
  };
};

struct Nothing {
  GAITWAY_FIELDS()
};

struct Outcome {
  bool success = false;
  std::string message;
  GAITWAY_FIELDS(success, message)
};

using Trigger = RosService<"std_srvs/srv/Trigger", Nothing, Outcome>;

GAITWAY_ONE_FIELD(Truth, bool, data);
using SetBool = RosService<"std_srvs/srv/SetBool", Truth, Outcome>;

// One joint to `position` [rad] in `duration` [s], while the robot stands.
struct JointMove {
  std::string joint;
  double position = 0.0;
  double duration = 0.0;
  GAITWAY_FIELDS(joint, position, duration)
};
using MoveJoint = RosService<"gaitway_msgs/srv/MoveJoint", JointMove, Outcome>;

GAITWAY_ONE_FIELD(MotionName, std::string, motion);
using PlayMotion = RosService<"gaitway_msgs/srv/PlayMotion", MotionName, Outcome>;

// A place of the world [m] and a heading [rad], of the middle between the feet.
struct Place {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;
  GAITWAY_FIELDS(x, y, yaw)
};
using WalkTo = RosService<"gaitway_msgs/srv/WalkTo", Place, Outcome>;

// Where the head is to look. Angles of the neck: yaw to the left and pitch down, from ahead.
struct LookOrder {
  std::string mode = "ahead";  // "ahead", "direction", "point", "scan" or "hold"
  double yaw = 0.0;            // rad; of "direction", and the middle of a "scan"
  double pitch = 0.0;          // rad; likewise
  double extent = 0.0;         // rad; of "scan": as far to either side of the middle
  double period = 0.0;         // s; of "scan": from one side to the other and back; 0: as the robot has it
  double x = 0.0, y = 0.0, z = 0.0;  // m, in odom; of "point"
  double speed = 0.0;                // rad/s, at most; 0: as the robot has it
  GAITWAY_FIELDS(mode, yaw, pitch, extent, period, x, y, z, speed)
};
using Look = RosService<"gaitway_msgs/srv/Look", LookOrder, Outcome>;

GAITWAY_ONE_FIELD(MissionName, std::string, mission);
using StartMission = RosService<"gaitway_msgs/srv/StartMission", MissionName, Outcome>;

// One plug-in as the manager sees it.
struct PluginState {
  std::string name;
  std::string state;
  std::uint64_t steps = 0;
  std::uint64_t faults = 0;
  std::uint64_t overruns = 0;
  double p50_step_us = 0.0;
  double p99_step_us = 0.0;
  double worst_step_us = 0.0;
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/PluginState", name, state, steps, faults, overruns, p50_step_us,
                      p99_step_us, worst_step_us);
};
struct PluginList {
  bool success = false;
  std::string message;
  std::vector<PluginState> plugins;
  GAITWAY_FIELDS(success, message, plugins)
};
using ListPlugins = RosService<"gaitway_msgs/srv/ListPlugins", Nothing, PluginList>;

// Load, reload or unload. `library`: the file; empty: where the plug-in was. Not used to unload.
struct PluginChange {
  std::string name;
  std::string library;
  GAITWAY_FIELDS(name, library)
};
using ChangePlugin = RosService<"gaitway_msgs/srv/ChangePlugin", PluginChange, Outcome>;

GAITWAY_ONE_FIELD(PluginName, std::string, plugin);
// One entry a parameter in each array. `live`: may be changed while the plug-in works.
struct ParameterList {
  bool success = false;
  std::string message;
  std::vector<std::string> names;
  std::vector<std::string> values;
  std::vector<std::string> units;
  std::vector<std::string> docs;
  std::vector<bool> live;
  GAITWAY_FIELDS(success, message, names, values, units, docs, live)
};
using GetParameters = RosService<"gaitway_msgs/srv/GetParameters", PluginName, ParameterList>;

// `value`: with its unit, as in the configuration.
struct ParameterChange {
  std::string plugin;
  std::string parameter;
  std::string value;
  GAITWAY_FIELDS(plugin, parameter, value)
};
using SetParameter = RosService<"gaitway_msgs/srv/SetParameter", ParameterChange, Outcome>;

// At most so fast [m/s, rad/s]; `left` and `turn` in either direction.
struct WalkBounds {
  bool success = false;
  std::string message;
  double forward = 0.0;
  double backward = 0.0;
  double left = 0.0;
  double turn = 0.0;
  GAITWAY_FIELDS(success, message, forward, backward, left, turn)
};
using WalkLimits = RosService<"gaitway_msgs/srv/WalkLimits", Nothing, WalkBounds>;

// `name`: of the file, without folder; empty: named after the time.
GAITWAY_ONE_FIELD(RecordingName, std::string, name);
struct RecordingFile {
  bool success = false;
  std::string message;
  std::string file;
  GAITWAY_FIELDS(success, message, file)
};
using StartRecording = RosService<"gaitway_msgs/srv/StartRecording", RecordingName, RecordingFile>;

// One recording in the recorder's folder.
struct Recording {
  std::string file;         // its path
  std::uint64_t bytes = 0;  // as far as it has been written
  Time start;               // by the computer's clock
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/Recording", file, bytes, start);
};
struct RecordingList {
  bool success = false;
  std::string message;
  std::vector<Recording> recordings;
  GAITWAY_FIELDS(success, message, recordings)
};
using ListRecordings = RosService<"gaitway_msgs/srv/ListRecordings", Nothing, RecordingList>;

// `name`: of who commands, for people. `keep_alive_period` [s]: keep the lease alive at least this often.
GAITWAY_ONE_FIELD(CommanderName, std::string, name);
struct CommandLease {
  bool success = false;
  std::string message;
  std::string lease;
  double keep_alive_period = 0.0;
  GAITWAY_FIELDS(success, message, lease, keep_alive_period)
};
using AcquireCommand = RosService<"gaitway_msgs/srv/AcquireCommand", CommanderName, CommandLease>;

GAITWAY_ONE_FIELD(LeaseName, std::string, lease);
using Lease = RosService<"gaitway_msgs/srv/Lease", LeaseName, Outcome>;

}  // namespace gaitway::api::ros
