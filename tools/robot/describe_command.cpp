// `gaitway robot describe`: what a robot is, which gait was chosen for it and why.
#include <fmt/format.h>

#include <filesystem>

#include "gaitway/urdf/robot_model.hpp"
#include "tools/robot/robot_commands.hpp"
#include "tools/robot/robot_description.hpp"

namespace gaitway::tools {
namespace {

struct DescribeOptions {
  std::filesystem::path robot;
  bool json = false;
};

int describe(const DescribeOptions& options) {
  const RobotDescription description = describe_robot(urdf::load_robot(options.robot));
  if (options.json) {
    fmt::print("{}\n", description_json(description));
  } else {
    fmt::print("{}", description_text(description));
  }
  const bool walks = description.gait_complaint.empty() && description.torque_complaint.empty();
  return walks && description.bus_complaint.empty() ? kExitFine : kExitNotDone;
}

}  // namespace

void add_robot_describe(const CommandLine& robot) {
  const CommandLine command = robot.subcommand(
      "describe", "What a robot is, which gait was chosen for it, how fast it may go, and why");
  DescribeOptions& options = command.runs(describe);
  command.option("robot", options.robot, "Folder with robot.urdf and robot.yaml").required();
  command.option("--json", options.json, "For programs");
  command.footer(
      "Examples:\n"
      "  gaitway robot describe robots/g1\n"
      "  gaitway robot describe robots/g1 --json > g1.json\n"
      "Exit code: 0 it can walk, 3 it cannot, and the last lines say why; 1 the robot does not load.");
}

}  // namespace gaitway::tools
