// The parts of `gaitway robot`, each in a file of its own.
#pragma once

#include "tools/command_line.hpp"

namespace gaitway::tools {

void add_robot_import(const CommandLine& robot);
void add_robot_check(const CommandLine& robot);

}  // namespace gaitway::tools
