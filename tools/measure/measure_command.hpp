// `gaitway measure gait`: how well the robot walks, as a table.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gaitway::tools {

struct MeasureGaitOptions {
  std::filesystem::path robot;
  std::filesystem::path config;
  std::filesystem::path out = "out/gait";
  std::optional<int> seeds;  // 20, or fewer with --quick
  std::uint64_t first_seed = 1;
  int jobs = 0;                     // 0: all cores
  std::vector<std::string> rows;    // none: all
  std::vector<std::string> except;  // of these
  bool quick = false;
  bool quiet = false;
};

struct MeasureOptions {
  MeasureGaitOptions gait;
};

// Adds the subcommand with its options and examples; `options` is filled when it is parsed.
CLI::App* add_measure_command(CLI::App& app, MeasureOptions& options);

// Exit codes beside 0, every measured floor holds, and 1, bad input: nothing was measured.
inline constexpr int kExitFloorFailed = 3;

// Measures and writes the results; returns the exit code. Throws on bad input.
int measure(const CLI::App& command, const MeasureOptions& options);

}  // namespace gaitway::tools
