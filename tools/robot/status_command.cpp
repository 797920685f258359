// `gaitway robot status`: each part, how it is and what became of it.
#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "gaitway/process/real_time.hpp"
#include "tools/robot/keeper/robot_keeper.hpp"
#include "tools/robot/robot_commands.hpp"

namespace gaitway::tools {
namespace {

constexpr int kExitNotAllWell = 2;
constexpr int kExitNotUp = 3;
constexpr std::int64_t kStale_ns = 2'000'000'000;  // it is written five times a second

struct StatusOptions {
  std::filesystem::path folder = usual_robot_folder();
  bool json = false;
};

// One that has ended and waits for somebody to take notice does not.
bool lives(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t state = text.rfind(") ");
  return state != std::string::npos && text.find_first_of("ZX", state + 2) != state + 2;
}

// What has happened since the supervisor wrote it down.
void look_again(RobotStatus& status, const RobotFolders& folders) {
  for (const PartStatus& part : status.parts) {
    if (part.name == "user_interface" || part.process == 0 || lives(part.worker)) continue;
    status.deny_command(fmt::format("{} has just ended (process {})", part.name, part.worker));
    return;
  }
  RobotView view(folders.memory_socket());
  static_cast<void>(view.look());
  if (const std::string why = view.why_not_commanded(process::monotonic_ns()); !why.empty()) {
    status.deny_command(why);
  }
}

int show(const StatusOptions& options) {
  const RobotFolders folders = folders_at(options.folder);
  const pid_t supervisor = SupervisorLock::holder(folders.folder);
  std::optional<RobotStatus> status = read_status(folders.status_file());
  if (!status) {
    fmt::print(stderr, "gaitway robot: no robot is up in {}. Another --folder?\n", folders.folder.string());
    return kExitNotUp;
  }
  const auto is_off = [](const PartStatus& part) { return part.state == "off" && part.process == 0; };
  if (supervisor == 0 && std::ranges::all_of(status->parts, is_off)) {
    fmt::print(stderr, "gaitway robot: the robot in {} was taken down {:.1f} s ago\n",
               folders.folder.string(),
               static_cast<double>(process::monotonic_ns() - status->written_ns) * 1e-9);
    return kExitNotUp;
  }
  const bool supervised = supervisor != 0 && supervisor == status->supervisor;
  bool any_lives = supervised;
  for (PartStatus& part : status->parts) {
    if (supervised || part.process == 0) continue;
    const bool is_there = kill(part.process, 0) == 0;
    any_lives = any_lives || is_there;
    part.state = is_there ? "lives" : "gone";
  }
  const std::int64_t now_ns = process::monotonic_ns();
  const bool stale = now_ns - status->written_ns > kStale_ns;
  if (!supervised || stale) {
    status->deny_command(supervised ? "its supervisor tells nothing any more" : "nobody watches over it");
  } else if (status->may_be_commanded) {
    look_again(*status, folders);
  }
  fmt::print("{}", options.json ? status_text(*status, supervised, now_ns)
                                : status_table(*status, supervised, now_ns));
  if (supervised && stale) {
    fmt::print(
        stderr,
        "gaitway robot: the supervisor (process {}) has written nothing for {:.1f} s: was it stopped?\n",
        supervisor, static_cast<double>(now_ns - status->written_ns) * 1e-9);
  }
  if (!any_lives) return kExitNotUp;
  return supervised && !stale && status->all_work() && status->may_be_commanded ? kExitFine : kExitNotAllWell;
}

}  // namespace

void add_robot_status(const CommandLine& robot) {
  const CommandLine command = robot.subcommand(
      "status", "Show the parts of a robot: how each is, since when, and what ended it last");
  StatusOptions& options = command.runs(show);
  command.option("--folder", options.folder,
                 std::string("Folder of the robot, as given to 'up'") + kUsualFolder);
  command.option("--json", options.json, "For programs; times in ns of CLOCK_MONOTONIC, ages in s");
  command.footer(
      "Examples:\n"
      "  gaitway robot status\n"
      "  gaitway robot status --folder /tmp/trial\n"
      "  gaitway robot status --json | jq '.parts[] | {name, state, restarts, reason}'\n"
      "Exit code: 0 all parts work and the robot may be commanded, 1 the input was bad, 2 not so: a part is "
      "down, or\n"
      "starts, or nobody supervises them, 3 no robot is up there.");
}

}  // namespace gaitway::tools
