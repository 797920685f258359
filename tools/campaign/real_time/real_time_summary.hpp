// What the trials of one row in real time come to, and the whole as Markdown, JSON and CSV.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tools/campaign/real_time/real_time_campaign.hpp"
#include "tools/campaign/row_summary.hpp"

namespace gaitway::tools {

struct RealTimeSummary {
  std::size_t trials = 0, falls = 0, walked_on = 0, walked_again = 0;
  std::size_t stopped = 0;        // trials in which a stop was asked for
  double most_falls_share = 0.0;  // with 95 % confidence the share of instants that fell it is not larger
  // Of those that came to it, among the trials in which nobody asks for a stop; `parts` of all trials, `stop`
  // of the others.
  TimeSummary commandable, order, walks, parts, stop;
  RealTimeLosses lost;  // of all trials together
};
[[nodiscard]] RealTimeSummary summary_of(const RealTimeRowResult& row);

struct RealTimeHead {
  std::string robot;
  double speed_m_per_s = 0.2;
};
[[nodiscard]] std::string real_time_markdown(const RealTimeHead& head, const RealTimeCampaign& campaign);
[[nodiscard]] std::string real_time_csv(const RealTimeCampaign& campaign);  // a line for each trial
[[nodiscard]] nlohmann::ordered_json real_time_json(const RealTimeHead& head,
                                                    const RealTimeCampaign& campaign);

}  // namespace gaitway::tools
