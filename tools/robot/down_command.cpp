// `gaitway robot down`: the robot stands, then its parts end; with or without their supervisor.
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/real_time.hpp"
#include "tools/robot/keeper/robot_keeper.hpp"
#include "tools/robot/robot_commands.hpp"

namespace gaitway::tools {
namespace {

constexpr int kExitNothingUp = 3;
constexpr int kPatience_ms = 30'000;  // all parts' together

struct DownOptions {
  std::filesystem::path folder = usual_robot_folder();
};

// What was written to the file from there on, without date and time.
void show_events(const std::filesystem::path& file, std::streamoff from) {
  std::ifstream events(file);
  events.seekg(from);
  for (std::string line; std::getline(events, line);) {
    const std::size_t text = line.find(' ');
    fmt::print("{}\n", text == std::string::npos ? line : line.substr(text + 1));
  }
}

int end_supervisor(pid_t supervisor, const std::filesystem::path& events) {
  const process::FileDescriptor pidfd(static_cast<int>(syscall(SYS_pidfd_open, supervisor, 0)));
  std::error_code unknown;
  const auto size = std::filesystem::file_size(events, unknown);
  kill(supervisor, SIGTERM);
  kill(supervisor, SIGCONT);  // should it have been stopped
  pollfd ended{pidfd.get(), POLLIN, 0};
  const bool has_ended = !pidfd || poll(&ended, 1, kPatience_ms) > 0;
  show_events(events, unknown ? 0 : static_cast<std::streamoff>(size));
  if (!has_ended) {
    fmt::print(stderr,
               "gaitway robot: the supervisor (process {}) has not ended within {} s: 'kill -9 {}' and then "
               "'gaitway robot down' again\n",
               supervisor, kPatience_ms / 1000, supervisor);
    return kExitPartsKilled;
  }
  return kExitFine;
}

// The parts that a supervisor has left behind.
int end_orphans(const RobotFolders& folders) {
  const SupervisorLock lock(folders.folder);
  std::vector<PartPlan> plans;
  std::vector<PartProcess> processes;
  for (const auto& [name, progress] :
       {std::pair("virtual_robot", Progress::joints), std::pair("message_controller", Progress::block),
        std::pair("main_controller", Progress::reports), std::pair("user_interface", Progress::answers)}) {
    if (!std::filesystem::exists(folders.folder / fmt::format("{}.lock", name))) continue;
    PartProcess process(name, {}, {.folder = folders.folder, .log = folders.log});
    if (!process.take_over_whatever()) continue;
    plans.push_back({.name = name, .words = {}, .progress = progress});
    processes.push_back(std::move(process));
  }
  if (plans.empty()) {
    fmt::print(stderr, "gaitway robot: no robot is up in {}. Another --folder?\n", folders.folder.string());
    return kExitNothingUp;
  }
  fmt::print("the supervisor is gone; its parts are ended without it\n");
  RobotView view(folders.memory_socket());
  const bool well =
      end_parts(plans, processes, view, [](const std::string& text) { fmt::print("{}\n", text); });
  // Whoever asks later is to be told so.
  if (std::optional<RobotStatus> status = read_status(folders.status_file())) {
    for (PartStatus& part : status->parts) {
      part.state = "off";
      part.process = part.worker = 0;
    }
    status->deny_command("it was taken down");
    status->written_ns = process::monotonic_ns();
    write_status(folders.status_file(), *status);
  }
  return well ? kExitFine : kExitPartsKilled;
}

int down(const DownOptions& options) {
  const RobotFolders folders = folders_at(options.folder);
  if (!std::filesystem::is_directory(folders.folder)) {
    fmt::print(stderr, "gaitway robot: no robot is up in {}: there is no such folder. Another --folder?\n",
               folders.folder.string());
    return kExitNothingUp;
  }
  if (const pid_t supervisor = SupervisorLock::holder(folders.folder); supervisor > 0) {
    const auto status = read_status(folders.status_file());
    return end_supervisor(supervisor, status ? std::filesystem::path(status->events) : folders.event_file());
  }
  return end_orphans(folders);
}

}  // namespace

void add_robot_down(const CommandLine& robot) {
  const CommandLine command =
      robot.subcommand("down", "Let the robot stand, then end its parts and their supervisor");
  DownOptions& options = command.runs(down);
  command.option("--folder", options.folder,
                 std::string("Folder of the robot, as given to 'up'") + kUsualFolder);
  command.footer(
      "Examples:\n"
      "  gaitway robot down\n"
      "  gaitway robot down --folder /tmp/trial\n"
      "The interface ends first, then the main controller; the message controller plays the safe tail, and "
      "ends when\n"
      "the robot stands. Under systemd: systemctl stop gaitway-robot (it would start the robot again "
      "otherwise).\n"
      "Exit code: 0 all ended as told, 1 the input was bad, 2 something had to be killed or has not ended, 3 "
      "no robot\n"
      "was up there.");
}

}  // namespace gaitway::tools
