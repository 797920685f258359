// `gaitway bus dbc` and `gaitway bus document`: the network's description as files.

#include <fmt/format.h>

#include <string_view>

#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/bus/bus_options.hpp"
#include "tools/bus/network_description.hpp"

namespace gaitway::tools {
namespace {

struct BusDbcOptions {
  std::filesystem::path robot = process::default_robot_directory();
  std::string profile;        // empty: the one that the network file names
  std::filesystem::path out;  // empty: the terminal
};

struct BusDocumentOptions {
  std::filesystem::path robot = process::default_robot_directory();
  std::filesystem::path out;  // empty: the terminal
};

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

int write_dbc(const BusDbcOptions& options) {
  write(options.out, dbc_text(describe(urdf::load_robot(options.robot), options.profile)));
  return kExitFine;
}

int write_network_document(const BusDocumentOptions& options) {
  const urdf::RobotModel robot = urdf::load_robot(options.robot);
  write(options.out, network_document(robot, describe(robot, "full"), describe(robot, "paper")));
  return kExitFine;
}

}  // namespace

void add_bus_dbc(const CommandLine& bus) {
  const CommandLine command =
      bus.subcommand("dbc", "Write the robot's messages as a .dbc file, which bus tools decode with");
  BusDbcOptions& options = command.runs(write_dbc);
  command.option("--robot", options.robot, "Folder with robot.urdf and robot.yaml");
  command.option("--profile", options.profile, "full or paper; default: what robot.yaml says")
      .one_of({"full", "paper"});
  command.option("--out", options.out, "File to write; default: the terminal");
  command.footer(
      "Examples:\n"
      "  gaitway bus dbc --out robot.dbc\n"
      "  gaitway bus dbc --robot my_robot --profile paper\n"
      "Exit code: 0 written, 1 the input was bad.");
}

void add_bus_document(const CommandLine& bus) {
  const CommandLine command =
      bus.subcommand("document", "Write the page that describes the network and its messages (Markdown)");
  BusDocumentOptions& options = command.runs(write_network_document);
  command.option("--robot", options.robot, "Folder with robot.urdf and robot.yaml");
  command.option("--out", options.out, "File to write; default: the terminal");
  command.footer(
      "Example:\n"
      "  gaitway bus document --out docs/network.md\n"
      "Exit code: 0 written, 1 the input was bad.");
}

}  // namespace gaitway::tools
