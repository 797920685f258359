// A trial at work, which may go on as another one that began like it.
#pragma once

#include <cstddef>

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

}  // namespace gaitway::tools
