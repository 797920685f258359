// Plays trials of the fault campaign: one robot walks once, and at each trial's instant the walk goes on in a
// copy of the process with that trial's fault.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/scenario_event.hpp"
#include "tools/campaign/fault_trial.hpp"
#include "tools/measure/gait_trial.hpp"

namespace gaitway::tools {

// The actions as the co-simulation takes them. Throws input::InputError for a text that is none.
[[nodiscard]] std::vector<simulator::ScenarioEvent> events_of(const FaultTrial& trial,
                                                              const urdf::RobotModel& robot);

// A robot of this seed as the campaign has it.
[[nodiscard]] simulator::CosimulationOptions walk_options(const TrialRobot& robot, std::uint64_t seed);

// Told each outcome with the trial's place in the series.
using FaultTrialDone = std::function<void(std::size_t trial, const FaultOutcome& outcome)>;

// Trials of one robot at one speed, in order of their instants; outcomes do not depend on which trials share
// the walk. For a process with a single thread, and plug-ins that run in it. Throws what the co-simulation's
// construction throws, and std::runtime_error when a copy of the process fails.
void run_fault_trials(const TrialRobot& robot, std::span<const FaultTrial> trials,
                      const FaultTrialDone& done);

}  // namespace gaitway::tools
