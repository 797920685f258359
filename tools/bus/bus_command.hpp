// The subcommands of `gaitway bus`, each in a file of its own.
#pragma once

#include "tools/command_line.hpp"

namespace gaitway::tools {

inline constexpr int kExitBusUnwell = 3;  // nothing was heard, or an answer took longer than is proven

void add_bus_analyze(const CommandLine& bus);
void add_bus_dbc(const CommandLine& bus);
void add_bus_document(const CommandLine& bus);
void add_bus_measure(const CommandLine& bus);
void add_bus_monitor(const CommandLine& bus);
void add_bus_replay(const CommandLine& bus);

}  // namespace gaitway::tools
