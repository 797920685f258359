// `gaitway bus`: everything about the robot's CAN bus, each thing a subcommand of its own.
#include "tools/bus/bus_options.hpp"

namespace gaitway::tools {

void declare_program(const CommandLine& program) {
  const CommandLine bus = add_command(program, "bus");
  bus.needs_subcommand();
  add_bus_analyze(bus);
  add_bus_dbc(bus);
  add_bus_document(bus);
  add_bus_measure(bus);
  add_bus_monitor(bus);
  add_bus_replay(bus);
  bus.footer(
      "Examples:\n"
      "  gaitway bus analyze\n"
      "  gaitway bus dbc --out robot.dbc\n"
      "  gaitway bus analyze --help");
}

}  // namespace gaitway::tools
