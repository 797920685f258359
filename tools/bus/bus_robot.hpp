// Which robot's bus a command is about: its messages, its nodes and what is proven of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/can/analysis/network_messages.hpp"
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

struct BusRobot {
  urdf::RobotModel model;
  can::Profile profile;
  std::vector<can::NodeId> nodes;  // on the bus
  can::Proof proof;                // without jitter and errors
};

// Throws urdf::RobotError naming file, line and rule.
[[nodiscard]] BusRobot load_bus_robot(const BusRobotOptions& options);

}  // namespace gaitway::tools
