// What the walk does for a body that is pushed off its plan: it moves the step in flight, or steps from the
// stand.
#pragma once

#include <Eigen/Core>

#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/trajectory/pattern_state.hpp"
#include "gaitway/trajectory/step_adjustment.hpp"
#include "gaitway/trajectory/step_schedule.hpp"

namespace gaitway::trajectory {

inline constexpr int kRecoverySteps = 5;  // that a standing robot takes when it is pushed off its feet

class PushRecovery {
 public:
  PushRecovery(const GaitParameters& parameters, double omega_per_s)
      : parameters_(parameters), adjustment_(parameters, omega_per_s) {}

  // Moves the step in flight after a body that is off its plan, and the plan with it, by the schedule as it
  // is. False where there is nothing to adjust; else the steps after it are to be scheduled anew.
  // dcm_deviation_m, here and below: in the plan's frame. reference: room to lay one out.
  bool adjust(PatternState& state, const StepSchedule& schedule, const WalkReference& walk,
              const Eigen::Vector2d& dcm_deviation_m, ZmpReference& reference) const noexcept;

  // A standing robot whose DCM has left its soles steps after it, where a bow that has begun does not catch
  // it.
  [[nodiscard]] bool must_step(const PatternState& state, const Eigen::Vector2d& dcm_deviation_m,
                               double bow_rad, const DivergenceAbsorber& absorber) const noexcept;
  // The feet stand side by side: whichever is lifted, the body falls to its side meanwhile. > 0: the left
  // one.
  [[nodiscard]] double side_to_step_to(const PatternState& state,
                                       const Eigen::Vector2d& dcm_deviation_m) const noexcept;
  // Makes the first step of a walk that has begun with that side the recovery's.
  void take_over(PatternState& state, StepSchedule& schedule, const WalkReference& walk,
                 const Eigen::Vector2d& dcm_deviation_m, double bow_rad,
                 ZmpReference& reference) const noexcept;

 private:
  [[nodiscard]] StepInFlight step_in_flight(const PatternState& state, const StepSchedule& schedule,
                                            const DivergenceAbsorber& absorber,
                                            const ZmpReference& reference) const noexcept;
  // Where the hips are to be when the first step of a recovery lands.
  [[nodiscard]] double hip_height_m(const Step& step, double bow_rad) const noexcept;

  GaitParameters parameters_;
  StepAdjustment adjustment_;
};

}  // namespace gaitway::trajectory
