// The table of parts. Times without progress are several times what was measured of working ones under load.
#include "tools/robot/keeper/robot_plan.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <net/if.h>
#include <sys/file.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"
#include "gaitway/instance/configuration.hpp"
#include "gaitway/msgcontroller/command_arbiter.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/listening_socket.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/robot/keeper/page_probe.hpp"
#include "tools/robot/keeper/port_owner.hpp"

namespace gaitway::tools {
namespace {

using facts::kMillisecond_ns;
using facts::kSecond_ns;

std::string program(const char* name) {
  std::error_code unknown;
  const std::filesystem::path beside = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
  for (const std::filesystem::path& folder : {beside, process::installation_root() / "bin"}) {
    if (access((folder / name).c_str(), X_OK) == 0) return (folder / name).string();
  }
  throw std::invalid_argument(
      fmt::format("the program {} is not in {}: build or install it", name, beside.string()));
}

// By the interface of this folder's robot, which may be taken over.
bool interface_lives(const RobotFolders& folders) {
  const process::FileDescriptor lock(
      open((folders.folder / "user_interface.lock").c_str(), O_RDWR | O_CLOEXEC));
  return lock && flock(lock.get(), LOCK_EX | LOCK_NB) != 0;
}

void check_port(const RobotPlanOptions& options, const RobotFolders& folders) {
  const int port = options.module.port;
  if (options.no_interface || port == 0 || interface_lives(folders) ||
      !port_is_taken(options.module.address, port)) {
    return;
  }
  throw std::invalid_argument(
      fmt::format("--port {}: another program listens there on {}: {}. Choose another --port, or do without "
                  "the interface (--no-interface)",
                  port, options.module.address, describe_listener(port)));
}

void check(const RobotPlanOptions& options, const RobotFolders& folders) {
  static_cast<void>(process::socket_address(folders.memory_socket()));  // a path that is too long is refused
  if (options.can && if_nametoindex(options.can->c_str()) == 0) {
    throw std::invalid_argument(
        fmt::format("--can {}: there is no such network interface. 'ip link' lists them; docs/socketcan.md "
                    "says how to set one up",
                    *options.can));
  }
  if (!options.walk.empty()) {
    msgcontroller::check_walk_option(options.walk);
  }
  if (options.profile != "" && options.profile != "full" && options.profile != "paper") {
    throw std::invalid_argument("--profile: must be full or paper");
  }
  const urdf::RobotModel robot = msgcontroller::load_robot(options.robot, options.profile);
  msgcontroller::require_proven_network(robot, options.accept_unproven);
  check_port(options, folders);
}

// A copy of the configuration in which the api has this folder's link.
std::filesystem::path with_link(const std::filesystem::path& config, const RobotFolders& folders) {
  YAML::Node root = YAML::LoadFile(config.string());
  bool found = false;
  for (YAML::Node plugin : root["plugins"]) {
    if (plugin["sockets"] && plugin["sockets"].as<std::string>() == "local") {
      plugin["parameters"]["link"] = "unix:" + folders.link_socket().string();
      found = true;
      break;
    }
  }
  if (!found) {
    throw std::invalid_argument(fmt::format(
        "--config {}: has no plug-in 'api' (sockets: local), to which the user interface connects. "
        "Add it as in serve.yaml, or choose --no-interface",
        config.string()));
  }
  const std::filesystem::path written = folders.folder / "plugins.yaml";
  process::write_text_file(
      written, fmt::format("# {} with the link of this robot; written at each start.\n{}\n", config.string(),
                           YAML::Dump(root)));
  return written;
}

std::filesystem::path configuration(const RobotPlanOptions& options, const RobotFolders& folders) {
  const std::filesystem::path shipped =
      process::config_directory() / (options.no_interface ? "walk.yaml" : "serve.yaml");
  const std::filesystem::path config = options.config.empty() ? shipped : options.config;
  static_cast<void>(core::read_configuration(config));  // complains of what is wrong with it
  return std::filesystem::absolute(options.no_interface ? config : with_link(config, folders));
}

PartPlan simulated_robot(const RobotPlanOptions& options, const RobotFolders& folders) {
  PartPlan part{.name = "virtual_robot",
                .words = {program("virtual_robot"), "--robot", options.robot.string(), "--bus",
                          folders.bus_socket().string(), "--seed", std::to_string(options.seed), "--mismatch",
                          fmt::format("{}", options.mismatch)},
                .progress = Progress::joints,
                // It wakes each millisecond; nobody can be hurt by a simulated body that waits.
                .patience = {.start_ns = 20 * kSecond_ns, .hang_ns = 1'500 * kMillisecond_ns}};
  if (!options.profile.empty()) part.words.insert(part.words.end(), {"--profile", options.profile});
  if (!options.world.empty()) part.words.insert(part.words.end(), {"--world", options.world});
  return part;
}

PartPlan message_controller(const RobotPlanOptions& options, const RobotFolders& folders) {
  PartPlan part{.name = "message_controller",
                .words = {program("message_controller"), "--robot", options.robot.string(), "--memory",
                          folders.memory_socket().string()},
                .progress = Progress::block,
                // It beats each millisecond and waits for the bus for 50 ms at most. The longest nap that a
                // busy computer was seen to force on it is 23 ms; the shortest safe tail lasts 960 ms.
                .patience = {.start_ns = 15 * kSecond_ns, .hang_ns = 300 * kMillisecond_ns},
                .needs = options.simulate ? "virtual_robot" : ""};
  part.words.insert(part.words.end(),
                    {options.simulate ? "--bus" : "--can",
                     options.simulate ? folders.bus_socket().string() : options.can.value_or("")});
  if (!options.profile.empty()) part.words.insert(part.words.end(), {"--profile", options.profile});
  if (options.accept_unproven) part.words.emplace_back("--accept-unproven");
  if (!options.walk.empty()) {
    part.words.insert(part.words.end(), {"--walk", fmt::format("{}", fmt::join(options.walk, ",")),
                                         "--walk-after", fmt::format("{}", options.walk_after_s)});
  }
  return part;
}

PartPlan main_controller(const RobotPlanOptions& options, const RobotFolders& folders,
                         const std::filesystem::path& config) {
  PartPlan part{.name = "main_controller",
                .words = {program("main_controller"), "--supervised", "--socket",
                          folders.memory_socket().string(), "--robot", options.robot.string(), "--config",
                          config.string(), "--events", (folders.log / "main_controller.jsonl").string()},
                .progress = Progress::reports,
                // Its own supervisor ends a worker that makes no tick for 1 s, and knows which plug-in was to
                // blame: this is for when that one does not.
                .patience = {.start_ns = 30 * kSecond_ns, .hang_ns = 2'500 * kMillisecond_ns},
                .needs = "message_controller",
                .lives_in = "message_controller",
                .moves_ns = 10 * kSecond_ns,
                .end_ns = 6 * kSecond_ns};
  if (!options.plugin_path.empty()) {
    part.words.emplace_back("--plugin-path");
    for (const std::filesystem::path& path : options.plugin_path) part.words.push_back(path.string());
  }
  return part;
}

PartPlan user_interface(const RobotPlanOptions& options, const RobotFolders& folders) {
  std::vector<std::string> words = module_arguments(
      options.module, {.robot = options.robot,
                       .profile = options.profile,
                       .link = "unix:" + folders.link_socket().string(),
                       .simulation = {},
                       .recordings = options.recordings.empty() ? folders.log : options.recordings});
  const auto leave_out = [&words](const char* option) {
    const auto at = std::ranges::find(words, option);
    words.erase(at, at + 2);
  };
  leave_out("--simulation");  // nobody pushes this one
  if (options.recordings.empty()) leave_out("--recordings");
  words.insert(words.begin(), program("user_interface"));
  const bool can_be_asked = options.module.port != 0 && options.module.certificate_file.empty();
  return {.name = "user_interface",
          .words = std::move(words),
          .progress = can_be_asked ? Progress::answers : Progress::rounds,
          // Asked each second. Nothing of the balance waits for it.
          .patience = {.start_ns = 20 * kSecond_ns, .hang_ns = 6 * kSecond_ns},
          .needs = "main_controller"};
}

}  // namespace

std::vector<PartPlan> plan_robot(const RobotPlanOptions& given, const RobotFolders& folders) {
  RobotPlanOptions options = given;
  options.robot = std::filesystem::absolute(options.robot);
  check(options, folders);
  const std::filesystem::path config = configuration(options, folders);
  std::vector<PartPlan> parts;
  if (options.simulate) parts.push_back(simulated_robot(options, folders));
  parts.push_back(message_controller(options, folders));
  parts.push_back(main_controller(options, folders, config));
  if (!options.no_interface) parts.push_back(user_interface(options, folders));
  return parts;
}

}  // namespace gaitway::tools
