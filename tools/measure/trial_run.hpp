// A trial at work, which may go on as another one that began like it; and trials one after the other, of
// which what several have in common is played once.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "gaitway/simulator/cosimulation.hpp"
#include "tools/measure/gait_trial.hpp"
#include "tools/measure/trial_watch.hpp"

namespace gaitway::tools {

class TrialRun {
 public:
  // Throws what the co-simulation's construction throws.
  TrialRun(const TrialRobot& robot, const Trial& trial);
  TrialRun(const TrialRun&) = delete;
  TrialRun& operator=(const TrialRun&) = delete;

  // Up to the millisecond that begins then, or to the trial's end.
  void advance_to(double at_s);
  [[nodiscard]] TrialOutcome finish();
  // In a copy of the process that fork() made: from now on it is `trial`, which differs from the present one
  // in its push, that is still to come, and in its length alone.
  void go_on_in_copy_as(const Trial& trial);

 private:
  [[nodiscard]] bool goes_on() const;
  [[nodiscard]] bool is_due(double at_s) const;
  void advance_millisecond();

  Trial trial_;
  simulator::Cosimulation run_;
  TrialWatch watch_;  // keeps references to both
  std::size_t commands_given_ = 0;
  bool pushed_ = false, risen_ = false;
};

// `next` can go on from where `before` is pushed: they differ in their push alone, which comes no earlier,
// and in their length.
[[nodiscard]] bool shares_walk(const Trial& before, const Trial& next);

// Told each outcome with the trial's place in the series. Returns whether to go on.
using TrialDone = std::function<bool(std::size_t trial, const TrialOutcome& outcome)>;

// Outcomes are the same to the bit as those of run_trial(). Trials that follow one another and differ in
// their push alone share the walk up to the push: it goes on in a copy of the process for each of them.
// Throws what run_trial() throws, and std::runtime_error when a copy of the process fails.
void run_trials(const TrialRobot& robot, std::span<const Trial> trials, const TrialDone& done);

}  // namespace gaitway::tools
