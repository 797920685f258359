// A simulated robot under `gaitway robot up`, with its real programs, and what can be asked about it.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "command_run.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/real_time.hpp"
#include "tools/robot/keeper/robot_status.hpp"
#include "tools/robot/keeper/robot_view.hpp"

namespace gaitway::tools {

class RunningRobot {
 public:
  // Returns when it may be commanded. `options`: as a shell takes them.
  explicit RunningRobot(const std::string& options) : started(run("up --simulate --detach " + options)) {}
  ~RunningRobot() { static_cast<void>(run("down")); }
  RunningRobot(const RunningRobot&) = delete;
  RunningRobot& operator=(const RunningRobot&) = delete;

  [[nodiscard]] test::CommandRun run(const std::string& words) const {
    return test::run_command(GAITWAY_ROBOT_COMMAND " robot " + words + " --folder " + folder.path().string());
  }
  [[nodiscard]] PartStatus status(const std::string& name) const {
    if (const auto whole = read_status(folder.path() / "status.json")) {
      for (const PartStatus& part : whole->parts) {
        if (part.name == name) return part;
      }
    }
    return {};
  }
  [[nodiscard]] std::string log(const std::string& name) const {
    return test::text_of(folder.path() / (name + ".log"));
  }
  [[nodiscard]] std::string everything() const {
    std::string all;
    for (const char* const name :
         {"events", "supervisor", "message_controller", "main_controller", "virtual_robot"}) {
      all += std::string("\n--- ") + name + "\n" + log(name);
    }
    return all;
  }
  // Kills this process, then waits until the robot has been seen not to be commandable, and is so again by
  // another one. How long that took; nothing: it does not come back.
  [[nodiscard]] std::optional<double> seconds_to_command(pid_t killed) {
    constexpr std::int64_t kPatience_ns = 20'000'000'000;
    const std::int64_t begin_ns = process::monotonic_ns();
    if (kill(killed, SIGKILL) != 0) return std::nullopt;
    bool was_away = false;
    while (process::monotonic_ns() - begin_ns < kPatience_ns) {
      RobotView view(folder.path() / "memory.sock");
      while (view.look() && is_block_alive(view)) {
        const bool commanded = view.may_be_commanded(process::monotonic_ns());
        if (was_away && commanded) return static_cast<double>(process::monotonic_ns() - begin_ns) * 1e-9;
        was_away = was_away || !commanded;
        if (process::monotonic_ns() - begin_ns >= kPatience_ns) return std::nullopt;
        usleep(1'000);
      }
      was_away = true;  // its memory block is gone
      usleep(1'000);
    }
    return std::nullopt;
  }

  process::PrivateFolder folder{"gaitway_robot"};
  test::CommandRun started;

 private:
  // Its heartbeat is not old.
  static bool is_block_alive(const RobotView& view) {
    constexpr std::int64_t kOld_ns = 50'000'000;
    const auto beat_ns = static_cast<std::int64_t>(view.message_controller_beats().value_or(0));
    return process::monotonic_ns() - beat_ns < kOld_ns;
  }
};

}  // namespace gaitway::tools
