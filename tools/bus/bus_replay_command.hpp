// `gaitway bus replay`: a recorded log, fed to the local controllers once more.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "tools/bus/bus_robot.hpp"

namespace CLI {
class App;
}

namespace gaitway::tools {

inline constexpr int kExitDiffers = 3;

struct BusReplayOptions {
  std::filesystem::path log;
  BusRobotOptions robot;
  std::uint64_t seed = 1;
  double mismatch = 1.0;
  bool references_only = false;
  bool losses = false;
  std::optional<std::filesystem::path> scenario;  // of the recorded run
  std::filesystem::path out;                      // CSV; empty: none
};

// `options` outlives the application.
CLI::App* add_bus_replay_command(CLI::App& bus, BusReplayOptions& options);

// Returns the exit code; throws on bad input, before anything is fed.
int replay_bus_log(const BusReplayOptions& options);

}  // namespace gaitway::tools
