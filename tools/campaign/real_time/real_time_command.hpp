// What `gaitway campaign --real-time` does.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gaitway::tools {

struct RealTimeCommand {
  std::filesystem::path robot, out;
  std::uint64_t trials = 10;
  double speed_m_per_s = 0.2;
  std::vector<std::string> rows, except;
  bool list = false, quiet = false;
};

inline constexpr int kExitNotBack = 2;  // nobody fell, but not all came back, or it was broken off
// The exit code: also 3, a robot fell. Throws std::invalid_argument before anything moves.
[[nodiscard]] int run_in_real_time(const RealTimeCommand& command);

}  // namespace gaitway::tools
