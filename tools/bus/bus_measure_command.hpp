// `gaitway bus measure`: the published experiment, rerun.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/bus/bus_robot.hpp"

namespace CLI {
class App;
}

namespace gaitway::tools {

struct BusMeasureOptions {
  BusRobotOptions robot;
  std::filesystem::path config;
  std::vector<double> walk{0.1};
  std::optional<double> seconds;
  std::uint64_t seed = 1;
  double mismatch = 1.0;
  std::optional<std::filesystem::path> socket;  // measure a running robot's bus instead
  std::optional<std::string> interface;         // 〃
  std::filesystem::path out;                    // folder for pictures and tables; empty: none
  bool json = false;
};

// `options` outlives the application.
CLI::App* add_bus_measure_command(CLI::App& bus, BusMeasureOptions& options);

// Returns the exit code; throws on bad input.
int measure_bus(const BusMeasureOptions& options);

}  // namespace gaitway::tools
