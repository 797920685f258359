// One trial of the campaign in real time: which fault, at which instant of the walk, and what came of it.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace gaitway::tools {

inline constexpr double kStopAsked_s = 0.1;  // after the fault, in every second trial

// Drawn from the row's name and the trial's number alone.
struct RealTimeTrial {
  std::string row;
  std::uint64_t number = 0;  // in its row, from 0
  double speed_m_per_s = 0.2;
  double instant_s = 0.0;   // of the fault, since the robot was first seen to walk
  bool is_stopped = false;  // a stop is asked for shortly after the fault; else it is to walk on
};
[[nodiscard]] RealTimeTrial draw_real_time_trial(const std::string& row, std::uint64_t number,
                                                 double speed_m_per_s);

// What was lost on the way.
struct RealTimeLosses {
  std::uint64_t batches = 0;        // late or refused
  std::uint64_t tail_cycles = 0;    // played by the message controller
  std::uint64_t joint_cycles = 0;   // that joints played by themselves
  std::uint64_t restarts = 0;       // of parts
  std::uint64_t plugin_faults = 0;  // of plug-ins, as the manager counts them
  std::uint64_t event_lines = 0;    // that found no room
};

// All times from the fault on.
struct RealTimeOutcome {
  std::uint64_t seed = 0;  // of the robot's deviations
  bool fell = false;
  std::optional<double> fell_s;
  bool was_interrupted = false;         // for a while it could not be commanded
  std::optional<double> commandable_s;  // it may be commanded again, or still; none: it may not any more
  std::optional<double> order_s;        // an order given after the fault is obeyed
  bool walked_on = false;               // it never stopped
  std::optional<double> walks_s;        // it walks again, when asked; none: it does not
  std::optional<double> parts_s;        // every process is there and makes progress; none: not any more
  std::optional<double> stop_s;         // from the asking for a stop to its being obeyed
  RealTimeLosses lost;
  std::string note;  // what a person ought to know of it

  [[nodiscard]] bool is_well() const noexcept { return !fell && commandable_s && walks_s && parts_s; }
};

[[nodiscard]] nlohmann::ordered_json describe(const RealTimeTrial& trial);
[[nodiscard]] nlohmann::ordered_json to_json(const RealTimeOutcome& outcome);
// Throws nlohmann::json::exception where a field is missing or of another type.
[[nodiscard]] RealTimeOutcome real_time_outcome_from_json(const nlohmann::ordered_json& json);

}  // namespace gaitway::tools
