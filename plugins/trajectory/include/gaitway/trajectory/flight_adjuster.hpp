// Moves the step in flight after a body that is off its plan, and the plan with it.
#pragma once

#include <Eigen/Core>

#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/trajectory/pattern_state.hpp"
#include "gaitway/trajectory/step_adjustment.hpp"
#include "gaitway/trajectory/step_schedule.hpp"
#include "gaitway/trajectory/walk_reference.hpp"

namespace gaitway::trajectory {

inline constexpr int kRecoverySteps = 5;  // that a standing robot takes when it is pushed off its feet

class FlightAdjuster {
 public:
  FlightAdjuster(const GaitParameters& parameters, double omega_per_s)
      : parameters_(parameters), adjustment_(parameters, omega_per_s) {}

  // By the schedule as it is. False where there is nothing to adjust; else the steps after it are to be
  // scheduled anew. dcm_deviation_m: in the plan's frame. reference: room to lay one out.
  bool adjust(PatternState& state, const StepSchedule& schedule, const WalkReference& walk,
              const Eigen::Vector2d& dcm_deviation_m, ZmpReference& reference) const noexcept;

 private:
  [[nodiscard]] StepInFlight step_in_flight(const PatternState& state, const FootstepPlanner& planner,
                                            const DivergenceAbsorber& absorber,
                                            const ZmpReference& reference) const noexcept;

  GaitParameters parameters_;
  StepAdjustment adjustment_;
};

}  // namespace gaitway::trajectory
