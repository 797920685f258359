// Plays the campaign's trials in real time, one after the other: the same robot for as many as it outlasts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/campaign/real_time/real_time_row.hpp"
#include "tools/campaign/real_time/real_time_trial.hpp"
#include "tools/measure/outcome_store.hpp"

namespace gaitway::tools {

struct RealTimeOptions {
  std::filesystem::path robot;  // folder
  std::uint64_t trials = 10;    // of each row
  double speed_m_per_s = 0.2;
  // Before each trial; `remaining_s`: none, it is not known yet.
  std::function<void(std::uint64_t done, std::uint64_t planned, const std::string& row,
                     std::optional<double> remaining_s)>
      progress = {};
};

struct RealTimeRowResult {
  RealTimeRow row;
  std::vector<RealTimeOutcome> outcomes;  // in order of the trials' numbers; fewer, if it was broken off
};

struct RealTimeCampaign {
  std::vector<RealTimeRowResult> rows;
  std::uint64_t run = 0, known = 0;  // trials: played now, and from the store
  bool is_whole = true;              // else it was broken off by a signal
};

// What outcomes depend on beside the trial: the programs, what they load, the robot's description.
[[nodiscard]] std::uint64_t real_time_fingerprint(const std::filesystem::path& robot);

// Until all are played, or SIGINT or SIGTERM came (process::stop_on_signals). Throws std::runtime_error when
// a robot does not come up, or does not walk.
[[nodiscard]] RealTimeCampaign run_real_time_campaign(const std::vector<RealTimeRow>& rows,
                                                      OutcomeStore& store, const RealTimeOptions& options);

}  // namespace gaitway::tools
