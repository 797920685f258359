// Trials one after the other; what several of them have in common is played once.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "tools/measure/gait_trial.hpp"

namespace gaitway::tools {

// Told each outcome with the trial's place in the series. Returns whether to go on.
using TrialDone = std::function<bool(std::size_t trial, const TrialOutcome& outcome)>;

// Outcomes are the same to the bit as those of run_trial(). Trials that follow one another and differ in
// their push alone share the walk up to the push: it goes on in a copy of the process for each of them.
// Throws what run_trial() throws, and std::runtime_error when a copy of the process fails.
void run_trials(const TrialRobot& robot, std::span<const Trial> trials, const TrialDone& done);

}  // namespace gaitway::tools
