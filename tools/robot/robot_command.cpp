// `gaitway robot`: a robot of one's own, from its description to its daily work, each thing that can be done
// about it a subcommand.
#include "tools/robot/robot_commands.hpp"

namespace gaitway::tools {

void declare_program(const CommandLine& program) {
  const CommandLine robot = add_command(program, "robot");
  robot.needs_subcommand();
  add_robot_import(robot);
  add_robot_describe(robot);
  add_robot_check(robot);
  add_robot_up(robot);
  add_robot_down(robot);
  add_robot_status(robot);
  robot.footer(
      "Examples:\n"
      "  gaitway robot import my_robot.urdf    a folder from the URDF that its maker publishes\n"
      "  gaitway robot describe my_robot       what it is, which gait was chosen for it, and why\n"
      "  gaitway robot check my_robot          does it stand, step and walk in the simulator?\n"
      "  gaitway robot up --simulate           all its parts, kept working; 'status' shows them, 'down' ends "
      "them");
}

}  // namespace gaitway::tools
