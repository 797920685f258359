// The subcommands of `gaitway robot`.
#pragma once

#include "tools/command_line.hpp"

namespace gaitway::tools {

void add_robot_describe(const CommandLine& robot);

}  // namespace gaitway::tools
