// `gaitway robot`: what it is made of.
#include "tools/robot/robot_commands.hpp"

namespace gaitway::tools {

void declare_program(const CommandLine& program) {
  const CommandLine robot = add_command(program, "robot");
  add_robot_import(robot);
  add_robot_check(robot);
  robot.needs_subcommand();
}

}  // namespace gaitway::tools
