// One trial of the fault campaign: a seeded robot walks, something happens to it at an instant that chance
// has chosen, and it is watched; and what came of it. A trial is data alone: the same one has the same
// outcome to the bit.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/campaign/fault_table.hpp"

namespace gaitway::tools {

inline constexpr double kWalkFrom_s = 1.0;      // it is asked to walk
inline constexpr double kFirstInstant_s = 4.0;  // it walks as it does for hours
inline constexpr double kInstants_s = 6.4;      // eight gait cycles of 0.8 s
inline constexpr double kWatched_s = 10.0;      // from the fault on; then it is asked to walk once more
inline constexpr double kWalkAgain_s = 4.0;
inline constexpr double kStopAfter_s = 0.1;  // a copy of the trial is stopped so long after the fault

struct FaultTrial {
  std::string row;
  std::uint64_t number = 0;  // in its row, from 0
  std::uint64_t seed = 1;    // of the robot
  double speed_m_per_s = 0.2;
  double instant_s = 0.0;
  std::vector<FaultAction> actions;
};

// The row's trial of this number: instant and fault are drawn from its name and number alone.
[[nodiscard]] FaultTrial draw_trial(const FaultRow& row, std::uint64_t number, int robots,
                                    double speed_m_per_s);

// What was lost on the way, and put right.
struct FaultLosses {
  std::uint64_t late = 0, refused = 0;  // batches
  std::uint64_t tail_played = 0;        // cycles
  std::uint64_t repaired = 0, resynchronised = 0;
  std::uint64_t trajectories_lost = 0, feedback_lost = 0;
  int wrong_joints = 0;  // at the end: their references are not what they ought to be
};

// All times from the fault on.
struct FaultOutcome {
  bool fell = false;
  std::optional<double> fell_s;
  std::optional<double> told_s;    // the robot's own estimate says that it falls
  std::optional<double> soft_s;    // a SYNC makes the joints soft: a fall's posture does
  std::optional<double> impact_s;  // something that is no foot hits the ground
  std::optional<double> stands_s;  // it stands, still and on both feet
  bool walked_on = false;          // it never stopped
  std::optional<double> walks_s;   // since then it walks, to the end; none: it does not
  std::optional<double> stop_s;  // from the asking for an emergency stop to its frame's end; none: never came
  FaultLosses lost;

  // Before the impact it knew that it falls, or the joints were soft. A robot that bends until it counts as
  // fallen has none.
  [[nodiscard]] bool reacted() const noexcept {
    const std::optional<double> down_s = impact_s ? impact_s : fell_s;
    return down_s && ((told_s && *told_s < *down_s) || (soft_s && *soft_s < *down_s));
  }
};

// What a trial's key is made of.
[[nodiscard]] nlohmann::ordered_json describe(const FaultTrial& trial);
[[nodiscard]] nlohmann::ordered_json to_json(const FaultOutcome& outcome);
// Throws nlohmann::json::exception where a field is missing or of another type.
[[nodiscard]] FaultOutcome fault_outcome_from_json(const nlohmann::ordered_json& json);

// The trial as a scenario file, for `gaitway run --scenario FILE --seed SEED`.
[[nodiscard]] std::string scenario_text(const FaultTrial& trial);

}  // namespace gaitway::tools
