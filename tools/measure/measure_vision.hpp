// `gaitway measure vision`: how exactly the robot's eyes see boxes and tags, against the simulator's truth.
#pragma once

#include "tools/command_line.hpp"

namespace gaitway::tools {

void declare_measure_vision(const CommandLine& measure);

}  // namespace gaitway::tools
