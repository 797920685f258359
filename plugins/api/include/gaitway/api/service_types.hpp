// The services that the API offers for the robot, as plain structs in the style of ros_messages.hpp: a
// service has a name, a Request and a Response. Every response says whether it worked, and if not, why.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/ros_messages.hpp"

namespace gaitway::api::ros {

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
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/PluginState") {
    visit("name", self.name);
    visit("state", self.state);
    visit("steps", self.steps);
    visit("faults", self.faults);
    visit("overruns", self.overruns);
    visit("p50_step_us", self.p50_step_us);
    visit("p99_step_us", self.p99_step_us);
    visit("worst_step_us", self.worst_step_us);
  }
};

struct Trigger {
  static constexpr std::string_view kName = "std_srvs/srv/Trigger";
  struct Request {
    GAITWAY_ROS_MESSAGE("std_srvs/srv/Trigger_Request") {}
  };
  struct Response {
    bool success = false;
    std::string message;
    GAITWAY_ROS_MESSAGE("std_srvs/srv/Trigger_Response") {
      visit("success", self.success);
      visit("message", self.message);
    }
  };
};

struct SetBool {
  static constexpr std::string_view kName = "std_srvs/srv/SetBool";
  struct Request {
    bool data = false;
    GAITWAY_ROS_MESSAGE("std_srvs/srv/SetBool_Request") { visit("data", self.data); }
  };
  struct Response {
    bool success = false;
    std::string message;
    GAITWAY_ROS_MESSAGE("std_srvs/srv/SetBool_Response") {
      visit("success", self.success);
      visit("message", self.message);
    }
  };
};

// One joint to `position` [rad] in `duration` [s], while the robot stands.
struct MoveJoint {
  static constexpr std::string_view kName = "gaitway_msgs/srv/MoveJoint";
  struct Request {
    std::string joint;
    double position = 0.0;
    double duration = 0.0;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/MoveJoint_Request") {
      visit("joint", self.joint);
      visit("position", self.position);
      visit("duration", self.duration);
    }
  };
  struct Response {
    bool success = false;
    std::string message;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/MoveJoint_Response") {
      visit("success", self.success);
      visit("message", self.message);
    }
  };
};

struct PlayMotion {
  static constexpr std::string_view kName = "gaitway_msgs/srv/PlayMotion";
  struct Request {
    std::string motion;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/PlayMotion_Request") { visit("motion", self.motion); }
  };
  struct Response {
    bool success = false;
    std::string message;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/PlayMotion_Response") {
      visit("success", self.success);
      visit("message", self.message);
    }
  };
};

struct ListPlugins {
  static constexpr std::string_view kName = "gaitway_msgs/srv/ListPlugins";
  struct Request {
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/ListPlugins_Request") {}
  };
  struct Response {
    bool success = false;
    std::string message;
    std::vector<PluginState> plugins;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/ListPlugins_Response") {
      visit("success", self.success);
      visit("message", self.message);
      visit("plugins", self.plugins);
    }
  };
};

// Load, reload or unload. `library`: the file; empty: where the plug-in was. Not used to unload.
struct ChangePlugin {
  static constexpr std::string_view kName = "gaitway_msgs/srv/ChangePlugin";
  struct Request {
    std::string name;
    std::string library;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/ChangePlugin_Request") {
      visit("name", self.name);
      visit("library", self.library);
    }
  };
  struct Response {
    bool success = false;
    std::string message;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/ChangePlugin_Response") {
      visit("success", self.success);
      visit("message", self.message);
    }
  };
};

// One entry a parameter in each array. `live`: may be changed while the plug-in works.
struct GetParameters {
  static constexpr std::string_view kName = "gaitway_msgs/srv/GetParameters";
  struct Request {
    std::string plugin;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/GetParameters_Request") { visit("plugin", self.plugin); }
  };
  struct Response {
    bool success = false;
    std::string message;
    std::vector<std::string> names;
    std::vector<std::string> values;
    std::vector<std::string> units;
    std::vector<std::string> docs;
    std::vector<bool> live;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/GetParameters_Response") {
      visit("success", self.success);
      visit("message", self.message);
      visit("names", self.names);
      visit("values", self.values);
      visit("units", self.units);
      visit("docs", self.docs);
      visit("live", self.live);
    }
  };
};

// `value`: with its unit, as in the configuration.
struct SetParameter {
  static constexpr std::string_view kName = "gaitway_msgs/srv/SetParameter";
  struct Request {
    std::string plugin;
    std::string parameter;
    std::string value;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/SetParameter_Request") {
      visit("plugin", self.plugin);
      visit("parameter", self.parameter);
      visit("value", self.value);
    }
  };
  struct Response {
    bool success = false;
    std::string message;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/SetParameter_Response") {
      visit("success", self.success);
      visit("message", self.message);
    }
  };
};

// `name`: of the file, without folder; empty: named after the time.
struct StartRecording {
  static constexpr std::string_view kName = "gaitway_msgs/srv/StartRecording";
  struct Request {
    std::string name;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/StartRecording_Request") { visit("name", self.name); }
  };
  struct Response {
    bool success = false;
    std::string message;
    std::string file;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/StartRecording_Response") {
      visit("success", self.success);
      visit("message", self.message);
      visit("file", self.file);
    }
  };
};

// `name`: of who commands, for people. `keep_alive_period` [s]: keep the lease alive at least this often.
struct AcquireCommand {
  static constexpr std::string_view kName = "gaitway_msgs/srv/AcquireCommand";
  struct Request {
    std::string name;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/AcquireCommand_Request") { visit("name", self.name); }
  };
  struct Response {
    bool success = false;
    std::string message;
    std::string lease;
    double keep_alive_period = 0.0;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/AcquireCommand_Response") {
      visit("success", self.success);
      visit("message", self.message);
      visit("lease", self.lease);
      visit("keep_alive_period", self.keep_alive_period);
    }
  };
};

struct Lease {
  static constexpr std::string_view kName = "gaitway_msgs/srv/Lease";
  struct Request {
    std::string lease;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/Lease_Request") { visit("lease", self.lease); }
  };
  struct Response {
    bool success = false;
    std::string message;
    GAITWAY_ROS_MESSAGE("gaitway_msgs/srv/Lease_Response") {
      visit("success", self.success);
      visit("message", self.message);
    }
  };
};

}  // namespace gaitway::api::ros
