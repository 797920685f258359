// The parts of `gaitway robot`, each in a file of its own.
#pragma once

#include "tools/command_line.hpp"

namespace gaitway::tools {

// Of `up` and `down`: all parts ended, but one had to be killed for that.
inline constexpr int kExitPartsKilled = 2;
// Of --folder, beside the one that is shown as this user's.
inline constexpr const char* kUsualFolder =
    ". Without it: of root /run/gaitway, of other users $XDG_RUNTIME_DIR/gaitway or /tmp/gaitway-UID";

void add_robot_import(const CommandLine& robot);
void add_robot_describe(const CommandLine& robot);
void add_robot_check(const CommandLine& robot);
void add_robot_up(const CommandLine& robot);
void add_robot_down(const CommandLine& robot);
void add_robot_status(const CommandLine& robot);

}  // namespace gaitway::tools
