// `gaitway bus monitor`: a bus in the terminal, live or from a log.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/bus/bus_robot.hpp"

namespace CLI {
class App;
}

namespace gaitway::tools {

inline constexpr int kExitBusUnwell = 3;

struct BusMonitorOptions {
  BusRobotOptions robot;
  std::optional<std::filesystem::path> socket;  // of a simulated bus
  std::optional<std::string> interface;         // of SocketCAN
  std::optional<std::filesystem::path> log;
  bool all = false;
  std::optional<double> seconds;
};

// `options` outlives the application.
CLI::App* add_bus_monitor_command(CLI::App& bus, BusMonitorOptions& options);

// Returns the exit code; throws on bad input.
int monitor_bus(const BusMonitorOptions& options);

}  // namespace gaitway::tools
