// Whether a robot stands, steps and walks in the simulator, and how well.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::tools {

struct RobotCheckOptions {
  std::filesystem::path configuration;  // plug-ins of the main controller
  std::vector<std::filesystem::path> plugin_path;
  double speed_m_per_s = 0.0;
  double walk_s = 20.0;
  double mismatch = 1.0;
};

// One seed's robot: what became of it.
struct RobotCheckOutcome {
  std::uint64_t seed = 0;
  enum class Reached { nothing, stand, steps, walk } reached = Reached::nothing;
  bool fell = false;
  double fell_at_s = 0.0;
  double speed_m_per_s = 0.0;              // held, from three seconds after its command
  double drift_m = 0.0;                    // sideways
  double stand_turn_rate_rad_per_s = 0.0;  // of the trunk while it stands, RMS, once it has settled
  bool trembles = false;                   // while it stands
  std::uint64_t batches = 0, refused = 0;
  std::string first_refusal;  // the first warning of the run; empty: none
  [[nodiscard]] bool walks() const noexcept { return reached == Reached::walk; }
};

inline constexpr double kStandUntil_s = 4.0, kStepsUntil_s = 8.0;
inline constexpr double kFroudeSpeed = 0.14;  // of sqrt(g h): Froude's number 0.02

// It stands for four seconds, steps on the spot for four, then walks. `progress` is told the time in the run.
[[nodiscard]] RobotCheckOutcome check_robot(const urdf::RobotModel& robot, std::uint64_t seed,
                                            const RobotCheckOptions& options,
                                            const std::function<void(double)>& progress);

}  // namespace gaitway::tools
