// `gaitway calibrate`: joint zeros, trunk and force cells from standing poses.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace CLI {
class App;
}

namespace gaitway::calibration {

inline constexpr int kExitMisfit = 3;  // the measurements do not fit the robot

struct CalibrateOptions {
  bool simulate = false;
  std::filesystem::path measurements, bus_log;  // empty: none
  std::filesystem::path robot, poses;
  std::uint64_t seed = 1;
  int seeds = 1, rounds = 4;
  double mismatch = 1.0;
  double measure_s = 1.0;
  double play_deg = 0.0, floor_deg = 0.0;
  std::optional<double> weighed_kg;
  double weighed_deviation_kg = 0.01;
  std::filesystem::path out, record;
  bool quiet = false;
};

// Adds the subcommand; `options` is filled when it is parsed.
CLI::App* add_calibrate_command(CLI::App& app, CalibrateOptions& options);

// Does what was parsed; returns the exit code. Throws std::exception for bad input.
int calibrate_command(const CalibrateOptions& options);

}  // namespace gaitway::calibration
