// `gaitway run`: one simulated run from options to report.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/simulator/scenario.hpp"

namespace CLI {
class App;
}

namespace gaitway::tools {

struct RunOptions {
  std::filesystem::path robot;              // folder with robot.urdf and robot.yaml
  std::string profile;                      // of the bus; empty: what the robot's network file says
  bool accept_unproven = false;             // run even if the bus cannot be proven
  std::filesystem::path config;             // plug-ins of the main controller
  std::vector<std::filesystem::path> with;  // libraries put into it; see core/plugin_exchange.hpp
  std::optional<std::filesystem::path> scenario;
  std::optional<std::vector<double>> walk;  // forward m/s, left m/s, turn rad/s
  std::optional<double> seconds;
  std::uint64_t seed = 1;
  double mismatch = 1.0;
  std::filesystem::path out = "out/run";
  bool pictures = true;
  std::optional<std::vector<double>> film;  // from and to when the film strip shows the run, s
  bool quiet = false;
};

// Adds the subcommand with its options and examples; `options` is filled when it is parsed.
CLI::App* add_run_command(CLI::App& app, RunOptions& options);

// Runs and writes the results; returns the exit code. Throws on bad input, before anything moves.
int run(const RunOptions& options);

}  // namespace gaitway::tools
