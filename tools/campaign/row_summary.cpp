// Counts, medians and bounds.
#include "tools/campaign/row_summary.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::tools {
namespace {

// Probability of at most `falls` in `trials` where each fails with this share.
double at_most(std::size_t falls, std::size_t trials, double share) {
  double sum = 0.0;
  for (std::size_t k = 0; k <= falls; ++k) {
    const auto n = static_cast<double>(trials), d = static_cast<double>(k);
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(d + 1.0) - std::lgamma(n - d + 1.0) +
                    d * std::log(share) + (n - d) * std::log1p(-share));
  }
  return sum;
}

void add_losses(FaultLosses& sum, const FaultLosses& one) {
  sum.late += one.late;
  sum.refused += one.refused;
  sum.tail_played += one.tail_played;
  sum.repaired += one.repaired;
  sum.resynchronised += one.resynchronised;
  sum.trajectories_lost += one.trajectories_lost;
  sum.feedback_lost += one.feedback_lost;
}

}  // namespace

// Clopper and Pearson 1934, one-sided.
double most_share(std::size_t times, std::size_t trials) {
  if (trials == 0 || times >= trials) return 1.0;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (at_most(times, trials, middle) > 0.05 ? low : high) = middle;
  }
  return high;
}

FaultEnd end_of(const FaultOutcome& outcome) {
  if (outcome.fell) return outcome.reacted() ? FaultEnd::falls_knowing : FaultEnd::falls;
  if (outcome.walked_on) return FaultEnd::walks_on;
  return outcome.walks_s ? FaultEnd::walks_again : FaultEnd::stands;
}

TimeSummary times_of(std::vector<double> times_s) {
  if (times_s.empty()) return {};
  std::ranges::sort(times_s);
  return {times_s.size(), times_s[times_s.size() / 2], times_s.back()};
}

RowSummary summary_of(const CampaignRow& row) {
  RowSummary summary;
  summary.trials = row.trials.size();
  std::vector<double> stands, walks, stop, lead;
  for (const auto& [trial, outcome] : row.trials) {
    ++summary.ends[static_cast<std::size_t>(end_of(outcome))];
    if (!outcome.fell && !outcome.walked_on) {
      if (outcome.stands_s) stands.push_back(*outcome.stands_s);
      if (outcome.walks_s) walks.push_back(*outcome.walks_s);
    }
    if (outcome.stop_s) stop.push_back(*outcome.stop_s);
    if (outcome.fell && outcome.impact_s && outcome.reacted()) {
      const double known_s =
          std::min(outcome.told_s.value_or(*outcome.impact_s), outcome.soft_s.value_or(*outcome.impact_s));
      lead.push_back(*outcome.impact_s - known_s);
    }
    add_losses(summary.lost, outcome.lost);
    summary.wrong_joints += !outcome.fell && outcome.lost.wrong_joints > 0 ? 1 : 0;
  }
  summary.most_falls_share = most_share(row.falls(), summary.trials);
  summary.stands = times_of(std::move(stands));
  summary.walks = times_of(std::move(walks));
  summary.stop = times_of(std::move(stop));
  summary.lead = times_of(std::move(lead));
  return summary;
}

}  // namespace gaitway::tools
