// Runs the fault campaign on several cores, and sums it up row by row.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/campaign/fault_table.hpp"
#include "tools/campaign/fault_trial.hpp"
#include "tools/measure/gait_trial.hpp"
#include "tools/measure/outcome_store.hpp"

namespace gaitway::tools {

struct CampaignOptions {
  std::uint64_t instants = 100;  // of each row
  int robots = 20;               // that take turns
  double speed_m_per_s = 0.2;
  int jobs = 1;  // processes side by side
  struct Progress {
    std::uint64_t done = 0, planned = 0;
    std::optional<double> remaining_s;  // none: not known yet
  };
  std::function<void(const Progress&)> progress;  // empty: none
};

struct PlayedTrial {
  FaultTrial trial;
  FaultOutcome outcome;
};

struct CampaignRow {
  FaultRow row;
  std::vector<PlayedTrial> trials;  // in order of their numbers

  [[nodiscard]] std::size_t falls() const;
  // Falls in none of its trials, if it must be survived; where it may fall, the robot knew before the impact,
  // or was soft. A row of which nothing is promised holds.
  [[nodiscard]] bool holds() const;
};

struct Campaign {
  std::vector<CampaignRow> rows;
  std::uint64_t run = 0, known = 0;  // trials: played now, and from the store
};

// Outcomes depend on rows, robot and speed alone. The trials run in copies of the process: call it where
// there is a single thread. Throws std::runtime_error with what a trial threw, or with how its process came
// to its end.
[[nodiscard]] Campaign run_campaign(const TrialRobot& robot, const std::vector<FaultRow>& rows,
                                    OutcomeStore& store, const CampaignOptions& options);

struct CampaignHead {
  std::string robot, configuration;
  CampaignOptions options;
  bool quick = false;
};

[[nodiscard]] std::string campaign_markdown(const CampaignHead& head, const Campaign& campaign);
[[nodiscard]] std::string campaign_csv(const Campaign& campaign);  // a line for each trial
[[nodiscard]] nlohmann::ordered_json campaign_json(const CampaignHead& head, const Campaign& campaign);
[[nodiscard]] std::string campaign_picture(const CampaignHead& head, const Campaign& campaign);  // SVG

}  // namespace gaitway::tools
