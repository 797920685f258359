// `gaitway robot`: a robot of somebody's own, each thing that can be done about it a subcommand.
#include "tools/robot/robot_options.hpp"

namespace gaitway::tools {

void declare_program(const CommandLine& program) {
  const CommandLine robot = add_command(program, "robot");
  robot.needs_subcommand();
  add_robot_describe(robot);
  robot.footer(
      "Examples:\n"
      "  gaitway robot describe my_robot          what it is, which gait was chosen for it, and why\n"
      "  gaitway robot describe my_robot --json   the same for programs");
}

}  // namespace gaitway::tools
