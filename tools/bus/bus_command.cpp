// Picks the subcommand of `gaitway bus`.
#include "tools/bus/bus_command.hpp"

#include <CLI/CLI.hpp>
#include "tools/program.hpp"

namespace gaitway::tools {

CLI::App* add_bus_command(CLI::App& app, BusOptions& options) {
  CLI::App* const command = add_command(app, "bus");
  command->require_subcommand(1);
  add_bus_analyze_command(*command, options.analyze);
  add_bus_dbc_command(*command, options.dbc);
  add_bus_document_command(*command, options.document);
  add_bus_measure_command(*command, options.measure);
  add_bus_monitor_command(*command, options.monitor);
  add_bus_replay_command(*command, options.replay);
  command->footer(
      "Examples:\n"
      "  gaitway bus analyze\n"
      "  gaitway bus dbc --out robot.dbc\n"
      "  gaitway bus analyze --help");
  return command;
}

int bus(const CLI::App& command, const BusOptions& options) {
  if (command.got_subcommand("analyze")) {
    return analyze_bus(options.analyze);
  }
  if (command.got_subcommand("dbc")) {
    return write_dbc(options.dbc);
  }
  if (command.got_subcommand("document")) {
    return write_network_document(options.document);
  }
  if (command.got_subcommand("measure")) {
    return measure_bus(options.measure);
  }
  if (command.got_subcommand("monitor")) {
    return monitor_bus(options.monitor);
  }
  if (command.got_subcommand("replay")) {
    return replay_bus_log(options.replay);
  }
  throw CLI::RequiredError("a subcommand of bus");
}

}  // namespace gaitway::tools

int main(int argc, char** argv) {
  gaitway::tools::BusOptions options;
  return gaitway::tools::run_program(argc, argv, [&options](CLI::App& app) -> std::function<int()> {
    CLI::App* const command = gaitway::tools::add_bus_command(app, options);
    return [command, &options] { return gaitway::tools::bus(*command, options); };
  });
}
