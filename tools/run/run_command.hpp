// `gaitway run`: one simulated run from options to report.
#pragma once

#include "tools/command_line.hpp"

namespace gaitway::tools {

void add_run(const CommandLine& program);

}  // namespace gaitway::tools
