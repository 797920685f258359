// The state of plug-ins, bus, nodes and loop as a ROS diagnostic array: what a person looks at first when
// something is wrong.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/api/ros_messages.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {

enum class DiagnosticLevel : std::uint8_t { ok = 0, warning = 1, error = 2, stale = 3 };

// What is known of the robot; nullptr: nobody has written it yet.
struct RobotCondition {
  std::int64_t stamp_ns = 0;          // the robot's clock
  std::int64_t heartbeat_age_ns = 0;  // how long the message controller has not been heard of
  const PluginStatistics* plugins = nullptr;
  const NetworkState* network = nullptr;
  const NetworkHealth* health = nullptr;
};

// Remembers the counters of the last report: what has grown since is a warning.
class Diagnostics {
 public:
  explicit Diagnostics(const urdf::RobotModel& model);
  // Status names: `plugin/<name>` for each plug-in in the order of the steps, `bus`, `nodes`, `loop`.
  [[nodiscard]] ros::DiagnosticArray report(const RobotCondition& condition);
  // The robot's counters began anew.
  void reset() noexcept { before_ = {}; }

 private:
  struct Before {
    std::vector<std::uint64_t> plugin_faults;
    std::optional<std::uint64_t> incidents, refusals;
  };

  void add_plugins(const PluginStatistics& plugins, std::vector<ros::DiagnosticStatus>& to);
  [[nodiscard]] ros::DiagnosticStatus bus(const NetworkHealth* health);
  [[nodiscard]] ros::DiagnosticStatus nodes(const NetworkHealth* health) const;
  [[nodiscard]] ros::DiagnosticStatus loop(const RobotCondition& condition);

  std::string robot_;
  std::vector<std::string> joints_;
  Before before_;
};

}  // namespace gaitway::api
