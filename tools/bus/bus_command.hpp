// `gaitway bus`: everything about the robot's CAN bus, each thing a subcommand of its own.
#pragma once

#include "tools/bus/bus_analyze_command.hpp"
#include "tools/bus/bus_dbc_command.hpp"
#include "tools/bus/bus_measure_command.hpp"
#include "tools/bus/bus_monitor_command.hpp"
#include "tools/bus/bus_replay_command.hpp"

namespace CLI {
class App;
}

namespace gaitway::tools {

// One member a subcommand.
struct BusOptions {
  BusAnalyzeOptions analyze;
  BusDbcOptions dbc;
  BusDocumentOptions document;
  BusMeasureOptions measure;
  BusMonitorOptions monitor;
  BusReplayOptions replay;
};

// Adds the command with its subcommands; `options` is filled when it is parsed.
CLI::App* add_bus_command(CLI::App& app, BusOptions& options);

// Runs the subcommand that was parsed; returns its exit code. Throws on bad input.
int bus(const CLI::App& command, const BusOptions& options);

}  // namespace gaitway::tools
