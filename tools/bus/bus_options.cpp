// Loads a robot with its messages and what is proven about them.
#include "tools/bus/bus_options.hpp"

#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/installation.hpp"

namespace gaitway::tools {

void add_robot_options(const CommandLine& command, BusRobotOptions& options) {
  options.directory = process::default_robot_directory();
  command.option("--robot", options.directory, "Folder with robot.urdf and robot.yaml");
  command.option("--profile", options.profile,
                 "Messages of the bus: full or paper. Without it, what the robot's network file says");
}

BusRobot load_bus_robot(const BusRobotOptions& options) {
  BusRobot robot;
  robot.model = msgcontroller::load_robot(options.directory, options.profile);
  robot.profile = msgcontroller::network_profile(robot.model);
  robot.nodes = msgcontroller::nodes_on_bus(robot.profile, robot.model);
  robot.proof = can::prove(robot.profile, robot.nodes);
  return robot;
}

}  // namespace gaitway::tools
