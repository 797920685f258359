// `gaitway robot up`: all parts of a robot, under one supervisor.
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/real_time.hpp"
#include "tools/robot/keeper/robot_keeper.hpp"
#include "tools/robot/robot_commands.hpp"
#include "tools/serve/module_options.hpp"

namespace gaitway::tools {
namespace {

constexpr int kExitNotReady = 3;
constexpr int kReadyPatience_ms = 60'000;

struct UpOptions {
  RobotPlanOptions robot;
  std::filesystem::path folder = usual_robot_folder(), log;
  bool detach = false, quiet = false;
};

int supervise(const UpOptions& options, const std::function<void()>& on_ready) {
  const RobotFolders folders = prepare_folders(options.folder, options.log);
  const SupervisorLock lock(folders.folder);
  RobotKeeper keeper(plan_robot(options.robot, folders), {.folders = folders,
                                                          .probe_address = options.robot.module.address,
                                                          .probe_port = options.robot.module.port,
                                                          .quiet = options.quiet,
                                                          .on_ready = on_ready});
  process::stop_on_signals();
  return keeper.run() ? kExitFine : kExitPartsKilled;
}

// Of the new process: it leaves the terminal, and says through the pipe that the robot may be commanded.
int supervise_detached(const UpOptions& options, const process::FileDescriptor& says) {
  setsid();
  // What whoever started this has open, a lock or a pipe, is not to live as long as the robot.
  const auto kept = static_cast<unsigned>(says.get());
  syscall(SYS_close_range, 3U, kept - 1, 0U);
  syscall(SYS_close_range, kept + 1, ~0U, 0U);
  try {
    const RobotFolders folders = prepare_folders(options.folder, options.log);
    const int code = supervise(options, [&says, &folders] {
      static_cast<void>(!write(says.get(), "\n", 1));
      const std::filesystem::path file = folders.log / "supervisor.log";
      const process::FileDescriptor out(open(file.c_str(), O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, 0600));
      const process::FileDescriptor nothing(open("/dev/null", O_RDWR | O_CLOEXEC));
      dup2(nothing.get(), STDIN_FILENO);
      dup2(nothing.get(), STDOUT_FILENO);
      dup2(out ? out.get() : nothing.get(), STDERR_FILENO);
    });
    return code;
  } catch (const std::exception& error) {
    fmt::print(stderr, "gaitway: {}\n", error.what());
    return kExitBadInput;
  }
}

int detach(const UpOptions& options) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error(fmt::format("no pipe: {}", std::strerror(errno)));
  }
  const process::FileDescriptor hears(ends[0]);
  process::FileDescriptor says(ends[1]);
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) {
    throw std::runtime_error(fmt::format("no process: {}", std::strerror(errno)));
  }
  if (child == 0) {
    std::fflush(nullptr);
    _exit(supervise_detached(options, says));
  }
  says = process::FileDescriptor();
  pollfd ready{hears.get(), POLLIN, 0};
  std::array<char, 1> byte{};
  if (poll(&ready, 1, kReadyPatience_ms) == 0) {
    fmt::print(
        stderr,
        "gaitway robot: the robot may not be commanded yet after {} s; its supervisor (process {}) goes on. "
        "'gaitway robot status' says why\n",
        kReadyPatience_ms / 1000, child);
    return kExitNotReady;
  }
  if (read(hears.get(), byte.data(), byte.size()) == 1) {
    fmt::print("the robot is up; its supervisor is process {}\n", child);
    return kExitFine;
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : kExitBadInput;
}

int up(const UpOptions& options) {
  if (options.detach) return detach(options);
  return supervise(options, [] {});
}

void add_simulation_options(const CommandLine& command, RobotPlanOptions& options) {
  command.option("--world", options.world,
                 "With --simulate: what it walks in (YAML): a file, or the name of a shipped one");
  command.option("--seed", options.seed, "With --simulate: seed of mismatch, noise and clock drifts");
  command
      .option("--mismatch", options.mismatch,
              "With --simulate: scale of what the planner does not know of the robot")
      .between(0.0, 10.0);
}

}  // namespace

void add_robot_up(const CommandLine& robot) {
  const CommandLine command =
      robot.subcommand("up", "Start all parts of a robot and keep them working, whatever ends or hangs");
  UpOptions& options = command.runs(up);
  const CommandLine bus = command.group("The joints, one of", true);
  bus.option("--can", options.robot.can, "CAN interface, for example can0 (docs/socketcan.md)");
  bus.option("--simulate", options.robot.simulate, "A simulated body on a simulated bus");
  command.option("--robot", options.robot.robot, "Folder with robot.urdf and robot.yaml");
  command.option("--config", options.robot.config,
                 "Plug-ins of the main controller (YAML); without it the shipped serve.yaml, with "
                 "--no-interface walk.yaml");
  command.option("--profile", options.robot.profile,
                 "Messages of the bus: full or paper. Without it, what the robot's network file says");
  command.option("--accept-unproven", options.robot.accept_unproven,
                 "Run even if some message of the bus may miss its deadline");
  command.repeated(
      "--plugin-path", options.robot.plugin_path,
      "Folder to look for plug-ins in, before GAITWAY_PLUGIN_PATH and the shipped ones; once for each");
  command.option("--folder", options.folder,
                 std::string("Folder of this robot: sockets, locks, status, logs") + kUsualFolder);
  command.option("--log", options.log, "Folder for events.log and what each part says; without it, --folder");
  command.option("--detach", options.detach,
                 "Leave the terminal once the robot may be commanded, and go on in the background");
  command.option("--quiet", options.quiet, "Events go to events.log alone");
  command
      .option("--walk", options.robot.walk,
              "For trials: order a walk VX,VY,WZ after each start of the message controller")
      .values(3);
  command.option("--walk-after", options.robot.walk_after_s, "Seconds from that start to that command")
      .between(0.0, 1e6);
  add_simulation_options(command, options.robot);
  const CommandLine interface = command.group("The user interface module");
  interface.option("--no-interface", options.robot.no_interface, "None: nobody is served");
  interface.option("--recordings", options.robot.recordings,
                   "Folder for recordings; without it, none are made");
  add_module_options(interface, options.robot.module);
  command.footer(
      "Examples:\n"
      "  gaitway robot up --simulate                 until Ctrl-C; its page is http://127.0.0.1:9090\n"
      "  gaitway robot up --simulate --detach; gaitway robot status; gaitway robot down\n"
      "  gaitway robot up --can can0 --robot my_robot --log /var/log/gaitway\n"
      "  gaitway robot up --simulate --no-interface --walk 0.15,0,0 --folder /tmp/trial\n"
      "A part that ends or hangs is started again: at once, then after pauses up to 10 s, for ever. Ctrl-C, "
      "SIGTERM\n"
      "and 'gaitway robot down' let the robot stand and end the parts. If the supervisor itself is killed, "
      "the parts\n"
      "live on, and the next 'up' of the same robot on the same bus takes them over.\n"
      "Exit code: 0 taken down as told, 1 the input was bad or the robot is up already, and nothing moved, 2 "
      "taken\n"
      "down, but a part had to be killed, 3 with --detach: up, but not to be commanded within 60 s.");
}

}  // namespace gaitway::tools
