// Lists a seed's trials and cuts them into series.
#include "tools/measure/seed_trials.hpp"

#include "tools/measure/trial_run.hpp"

namespace gaitway::tools {
namespace {

// Seven seconds on a core, of which the shared walk takes a tenth.
constexpr std::size_t kLongestSeries = 16;

}  // namespace

SeedTrials::SeedTrials(const GaitRow& of, double at_level, std::uint64_t of_seed)
    : row(&of), level(at_level), seed(of_seed), trials(of.trials(of_seed, at_level)) {}

bool SeedTrials::end_with(const Trial& trial, const TrialOutcome& outcome) const {
  return !row->has_figure() && !row->passes(outcome, trial, level);
}

double seconds_of(std::span<const Trial> trials) {
  double sum_s = 0.0;
  for (const Trial& trial : trials) {
    sum_s += trial.seconds;
  }
  return sum_s;
}

std::vector<TrialSeries> series_of(std::span<const Trial> trials) {
  std::vector<TrialSeries> all;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (!all.empty() && all.back().count < kLongestSeries && shares_walk(trials[i - 1], trials[i])) {
      ++all.back().count;
    } else {
      all.push_back({i, 1});
    }
  }
  return all;
}

}  // namespace gaitway::tools
