// The walk before the pushes is played in this process, and what comes after each of them in a copy of it.
#include "tools/measure/trial_series.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/process/working_copy.hpp"
#include "tools/measure/trial_run.hpp"

namespace gaitway::tools {
namespace {

constexpr double kMillisecond_s = 1e-3;

// All of a trial but its push and its length.
nlohmann::ordered_json beginning_of(Trial trial) {
  trial.push.reset();
  trial.seconds = 0.0;
  return describe(trial);
}

bool goes_on_from(const Trial& before, const Trial& next) {
  return before.push && next.push && next.push->at_s >= before.push->at_s && next.seconds >= before.seconds &&
         beginning_of(next) == beginning_of(before);
}

// fork() copies one thread, and no other process.
bool may_be_copied(const TrialRobot& robot) {
  const bool isolated =
      std::any_of(robot.plugins.plugins.begin(), robot.plugins.plugins.end(),
                  [](const core::PluginEntry& plugin) { return plugin.isolation != core::Isolation::none; });
  return !isolated && std::distance(std::filesystem::directory_iterator("/proc/self/task"), {}) == 1;
}

TrialOutcome finish_in_copy(TrialRun& walk, const Trial& trial) {
  process::WorkingCopy copy([&](const process::WorkingCopy::Tell& tell) {
    walk.go_on_in_copy_as(trial);
    tell(to_json(walk.finish()).dump());
  });
  std::vector<std::string> told;
  while (!copy.done()) {
    std::ranges::move(copy.listen(), std::back_inserter(told));
  }
  return outcome_from_json(nlohmann::ordered_json::parse(told.at(0)));
}

// Returns whether to go on.
bool run_pushes(const TrialRobot& robot, std::span<const Trial> trials, std::size_t first,
                const TrialDone& done) {
  Trial unpushed = trials.back();  // the longest
  unpushed.push.reset();
  TrialRun walk(robot, unpushed);
  for (std::size_t i = 0; i < trials.size(); ++i) {
    // The millisecond before the push is the trial's own: at its end the feet's places are noted.
    walk.advance_to(std::min(trials[i].push->at_s, trials[i].seconds) - kMillisecond_s);
    if (!done(first + i, finish_in_copy(walk, trials[i]))) {
      return false;
    }
  }
  return true;
}

}  // namespace

void run_trials(const TrialRobot& robot, std::span<const Trial> trials, const TrialDone& done) {
  for (std::size_t first = 0, end = 0; first < trials.size(); first = end) {
    for (end = first + 1; end < trials.size() && goes_on_from(trials[end - 1], trials[end]);) {
      ++end;
    }
    const bool shared = end - first > 1 && may_be_copied(robot);
    end = shared ? end : first + 1;
    const bool go_on = shared ? run_pushes(robot, trials.subspan(first, end - first), first, done)
                              : done(first, run_trial(robot, trials[first]));
    if (!go_on) {
      return;
    }
  }
}

}  // namespace gaitway::tools
