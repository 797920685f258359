// Loads the robot, describes its network, writes the text.
#include "tools/bus/bus_dbc_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string_view>

#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/bus/dbc_file.hpp"
#include "tools/bus/network_document.hpp"
#include "tools/program.hpp"

namespace gaitway::tools {
namespace {

// The profile `name`, or the network file's own when it is empty, with what the file wants changed.
NetworkDescription describe(urdf::RobotModel robot, std::string_view name) {
  if (!name.empty() && name != robot.network.profile) {
    robot.network.profile = name;
    robot.network.messages.clear();  // they are about the file's own profile
  }
  return describe_network(robot, msgcontroller::network_profile(robot));
}

void write(const std::filesystem::path& out, std::string_view text) {
  if (out.empty()) {
    fmt::print("{}", text);
  } else {
    process::write_text_file(out, text);
  }
}

}  // namespace

CLI::App* add_bus_dbc_command(CLI::App& bus, BusDbcOptions& options) {
  CLI::App* const command =
      bus.add_subcommand("dbc", "Write the robot's messages as a .dbc file, which bus tools decode with");
  options.robot = process::default_robot_directory();
  command->add_option("--robot", options.robot, "Folder with robot.urdf and robot.yaml")
      ->capture_default_str();
  command->add_option("--profile", options.profile, "full or paper; default: what robot.yaml says")
      ->check(CLI::IsMember({"full", "paper"}));
  command->add_option("--out", options.out, "File to write; default: the terminal");
  command->footer(
      "Examples:\n"
      "  gaitway bus dbc --out robot.dbc\n"
      "  gaitway bus dbc --robot my_robot --profile paper\n"
      "Exit code: 0 written, 1 the input was bad.");
  return command;
}

int write_dbc(const BusDbcOptions& options) {
  write(options.out, dbc_text(describe(urdf::load_robot(options.robot), options.profile)));
  return kExitFine;
}

CLI::App* add_bus_document_command(CLI::App& bus, BusDocumentOptions& options) {
  CLI::App* const command =
      bus.add_subcommand("document", "Write the page that describes the network and its messages (Markdown)");
  options.robot = process::default_robot_directory();
  command->add_option("--robot", options.robot, "Folder with robot.urdf and robot.yaml")
      ->capture_default_str();
  command->add_option("--out", options.out, "File to write; default: the terminal");
  command->footer(
      "Example:\n"
      "  gaitway bus document --out docs/network.md\n"
      "Exit code: 0 written, 1 the input was bad.");
  return command;
}

int write_network_document(const BusDocumentOptions& options) {
  const urdf::RobotModel robot = urdf::load_robot(options.robot);
  write(options.out, network_document(robot, describe(robot, "full"), describe(robot, "paper")));
  return kExitFine;
}

}  // namespace gaitway::tools
