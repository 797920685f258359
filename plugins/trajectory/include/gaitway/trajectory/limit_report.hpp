// Says which named rule limits a walk command, once a command and rule.
#pragma once

#include <array>
#include <cstdint>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/footstep_planner.hpp"
#include "gaitway/trajectory/gait_parameters.hpp"

namespace gaitway::trajectory {

// What the last plan had to change of what was asked for; no allocation.
class LimitReport {
 public:
  explicit LimitReport(const GaitParameters& parameters) noexcept
      : parameters_(parameters), planner_(parameters) {}

  // The live numbers of the parameters.
  void tune(const GaitParameters& changed) noexcept { parameters_.tune(changed); }

  // The rules in `applied` that have not been told since the command last changed.
  [[nodiscard]] StepLimit news(const WalkCommand& command, StepLimit applied) noexcept;

  // One line for one rule: what was asked for, the rule's name and its value. Valid until the next call.
  [[nodiscard]] const char* text(StepLimit rule) noexcept;

 private:
  GaitParameters parameters_;
  FootstepPlanner planner_;
  WalkCommand command_{};
  StepLimit told_ = StepLimit::none;
  std::array<char, 192> text_{};
};

// Every rule, one bit each.
inline constexpr std::array kStepLimits{StepLimit::speed,    StepLimit::acceleration, StepLimit::length,
                                        StepLimit::sole_gap, StepLimit::spacing,      StepLimit::turn};

}  // namespace gaitway::trajectory
