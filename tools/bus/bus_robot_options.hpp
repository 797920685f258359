// The options that name a robot and its messages, for all commands that need both.
#pragma once

#include <CLI/CLI.hpp>

#include "tools/bus/bus_robot.hpp"

namespace gaitway::tools {

// Adds --robot and --profile.
void add_robot_options(CLI::App& command, BusRobotOptions& options);

}  // namespace gaitway::tools
