// The subcommands of `gaitway bus`, each in a file of its own, and the options that they share: which robot's
// bus, how it is disturbed, and any other set of messages.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/can/analysis/error_model.hpp"
#include "gaitway/can/analysis/network_messages.hpp"
#include "gaitway/can/analysis/response_time.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "tools/command_line.hpp"

namespace gaitway::tools {

struct BusRobotOptions {
  std::filesystem::path directory;  // folder with robot.urdf and robot.yaml
  std::string profile;              // empty: what the robot's network file says
};

// Adds --robot and --profile.
void add_robot_options(const CommandLine& command, BusRobotOptions& options);

// Its messages, its nodes and what is proven of them.
struct BusRobot {
  urdf::RobotModel model;
  can::Profile profile;
  std::vector<can::NodeId> nodes;  // on the bus
  can::Proof proof;                // without jitter and errors
};

// Throws urdf::RobotError naming file, line and rule.
[[nodiscard]] BusRobot load_bus_robot(const BusRobotOptions& options);

// How a bus may be disturbed, as written on the command line:
//
//   burst:4,interval:10ms   four errors at once, then one every 10 ms
//   jam:2ms                 the bus is unusable for 2 ms, once
//   jam:2ms,interval:100ms  and again every 100 ms
//
// Parts: `burst:N` (1 when left out), `interval:TIME`, `jam:TIME`, in any order, each at most once; TIME is a
// number with the unit us, ms or s. Throws std::invalid_argument that names part, value and rule.
[[nodiscard]] can::ErrorSource parse_errors(const std::string& text);

// Any set of CAN messages, as a JSON list that users write:
//
//   [{"name": "brake", "id": 16, "bytes": 8, "period_us": 2500, "jitter_us": 0, "deadline_us": 2500}, ...]
//
// Times may be fractions. Optional: "extended": true for a 29-bit identifier; "fifo": "engine" for messages
// that wait in one FIFO transmit queue, whose name this is. In the file's order. Throws std::invalid_argument
// that names file, entry, field, value and rule.
[[nodiscard]] std::vector<can::AnalysedMessage> read_message_list(const std::filesystem::path& file);

inline constexpr int kExitBusUnwell = 3;  // nothing was heard, or an answer took longer than is proven

void add_bus_analyze(const CommandLine& bus);
void add_bus_dbc(const CommandLine& bus);
void add_bus_document(const CommandLine& bus);
void add_bus_measure(const CommandLine& bus);
void add_bus_monitor(const CommandLine& bus);
void add_bus_replay(const CommandLine& bus);

}  // namespace gaitway::tools
