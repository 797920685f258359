// Which parts a robot has, with which words each is started, what it needs, and how long it may go without
// progress.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/process/installation.hpp"
#include "tools/robot/keeper/part_watch.hpp"
#include "tools/serve/module_options.hpp"

namespace gaitway::tools {

// What a part's progress is seen by.
enum class Progress {
  rounds,   // the process goes to sleep by itself, again and again: its loop runs
  joints,   // rounds, or feedback of the joints in the memory block
  block,    // the memory block's heartbeat
  reports,  // the plug-in manager's reports in the memory block
  answers,  // to requests for the head of its page
};

struct PartPlan {
  std::string name;
  std::vector<std::string> words;
  Progress progress = Progress::rounds;
  PartPatience patience{};
  std::string needs = {};     // starts once that part works; empty: at once
  std::string lives_in = {};  // works in that part's memory: when it was started again, in a new one…
  std::int64_t moves_ns = 0;  // …to which it is to come within this time by itself, or it is started again
  std::int64_t end_ns = 3'000'000'000;  // from being told to end to its end
};

struct RobotFolders {
  std::filesystem::path folder;  // sockets, locks, status
  std::filesystem::path log;     // events and what the parts say
  [[nodiscard]] std::filesystem::path memory_socket() const { return folder / "memory.sock"; }
  [[nodiscard]] std::filesystem::path bus_socket() const { return folder / "bus.sock"; }
  [[nodiscard]] std::filesystem::path link_socket() const { return folder / "link.sock"; }
  [[nodiscard]] std::filesystem::path status_file() const { return folder / "status.json"; }
  [[nodiscard]] std::filesystem::path event_file() const { return log / "events.log"; }
};

// Of this user: what the service manager gave it, /run/gaitway of root, or among the user's own.
[[nodiscard]] std::filesystem::path usual_robot_folder();
// Makes what is missing, for this user alone. `log`: empty, it is the folder itself. Throws
// std::invalid_argument.
[[nodiscard]] RobotFolders prepare_folders(const std::filesystem::path& folder,
                                           const std::filesystem::path& log);
// Of a robot that is there, or was.
[[nodiscard]] RobotFolders folders_at(const std::filesystem::path& folder);

struct RobotPlanOptions {
  std::filesystem::path robot = process::default_robot_directory();
  std::filesystem::path config;    // plug-ins; empty: the shipped ones
  std::string profile;             // of the bus; empty: the robot's own
  std::optional<std::string> can;  // interface
  bool simulate = false;           // instead
  bool no_interface = false;
  bool accept_unproven = false;
  std::vector<double> walk;  // forward, left m/s, turn rad/s; empty: none
  double walk_after_s = 1.0;
  std::vector<std::filesystem::path> plugin_path;
  std::string world;                 // simulated
  std::uint64_t seed = 1;            // likewise
  double mismatch = 1.0;             // likewise
  std::filesystem::path recordings;  // empty: nothing can be recorded
  ModuleOptions module;
};

// In the order of their start. Writes the plug-ins' configuration with the link of this folder into it.
// Throws std::invalid_argument and the like before anything moves.
[[nodiscard]] std::vector<PartPlan> plan_robot(const RobotPlanOptions& options, const RobotFolders& folders);

}  // namespace gaitway::tools
