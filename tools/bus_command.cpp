// Picks the subcommand of `gaitway bus`.
#include "gaitway/tools/bus_command.hpp"

#include <CLI/CLI.hpp>

namespace gaitway::tools {

CLI::App* add_bus_command(CLI::App& app, BusOptions& options) {
  CLI::App* const command = app.add_subcommand("bus", "Analyse the robot's CAN bus");
  command->require_subcommand(1);
  add_bus_analyze_command(*command, options.analyze);
  command->footer(
      "Examples:\n"
      "  gaitway bus analyze\n"
      "  gaitway bus analyze --help");
  return command;
}

int bus(const CLI::App& command, const BusOptions& options) {
  if (command.got_subcommand("analyze")) {
    return analyze_bus(options.analyze);
  }
  throw CLI::RequiredError("a subcommand of bus");
}

}  // namespace gaitway::tools
