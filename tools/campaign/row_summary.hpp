// What the trials of one row come to, in numbers.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/campaign/campaign.hpp"

namespace gaitway::tools {

// How a trial ends, from the best on.
enum class FaultEnd { walks_on, walks_again, stands, falls_knowing, falls };
inline constexpr std::size_t kFaultEnds = 5;
struct FaultEndLook {
  std::string_view words, colour;
};
inline constexpr std::array<FaultEndLook, kFaultEnds> kFaultEndLooks{{{"walks on", "#2a7f4f"},
                                                                      {"stops, walks again", "#8bc48a"},
                                                                      {"stands", "#5b8fc9"},
                                                                      {"falls, knew or was soft", "#e8a33d"},
                                                                      {"falls", "#b3261e"}}};
[[nodiscard]] FaultEnd end_of(const FaultOutcome& outcome);

// Of several times: the middle one and the largest; none: there was none.
struct TimeSummary {
  std::size_t count = 0;
  double median_s = 0.0, largest_s = 0.0;
};
[[nodiscard]] TimeSummary times_of(std::vector<double> times_s);

// With 95 % confidence, of things that happened so often in so many trials, the share is not larger.
[[nodiscard]] double most_share(std::size_t times, std::size_t trials);

struct RowSummary {
  std::size_t trials = 0;
  std::array<std::size_t, kFaultEnds> ends{};  // trials with each
  double most_falls_share = 0.0;  // with 95 % confidence the share of instants that fell it is not larger
  TimeSummary stands, walks;      // of those that stopped
  TimeSummary stop;               // of an emergency stop
  TimeSummary lead;               // of falls: from knowing, or being soft, to the impact
  FaultLosses lost;               // of all trials together
  int wrong_joints = 0;           // trials in which joints are wrong at the end
};
[[nodiscard]] RowSummary summary_of(const CampaignRow& row);

}  // namespace gaitway::tools
