// Between the topics of a footstep plan and the walking pattern: the frame `odometry` outside, `plan` inside.
#pragma once

#include <cstdint>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/pattern_state.hpp"
#include "gaitway/trajectory/step_schedule.hpp"

namespace gaitway::trajectory {

// The plan's steps in the frame `plan`, by where the stance foot of the step in flight is planned and where
// it has been measured; of a standing robot, the first step's. Without a step: the plan is too old, or breaks
// a rule (numbers from 1, sides that take turns, finite places), or the odometry is not known.
[[nodiscard]] PlannedSteps planned_steps(const FootstepPlan& plan, const Estimate& estimate,
                                         const PatternState& state, std::int64_t now_ns) noexcept;

// Where the walk is in it, for who plans. `free`: neither a motion nor a fall has the robot. False: the
// odometry is not known.
[[nodiscard]] bool describe(const PatternState& state, const Estimate& estimate, bool free,
                            FootstepState& to) noexcept;

}  // namespace gaitway::trajectory
