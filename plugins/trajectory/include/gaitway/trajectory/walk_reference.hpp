// The reference ZMP of the steps that are scheduled, and the offset in it that absorbs their changes.
#pragma once

#include <Eigen/Core>
#include <array>

#include "gaitway/trajectory/divergence_absorber.hpp"
#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/trajectory/pattern_state.hpp"
#include "gaitway/trajectory/step_schedule.hpp"

namespace gaitway::trajectory {

class WalkReference {
 public:
  explicit WalkReference(const GaitParameters& parameters);

  // From now on, as the steps are planned. Empty unless walking.
  void lay_out(const PatternState& state, const StepSchedule& schedule, int points,
               ZmpReference& reference) const noexcept;
  // The same with the offset by which the state's cart follows it.
  void fill(PatternState& state, const StepSchedule& schedule, int points,
            ZmpReference& reference) const noexcept;
  // The offset goes on from the reference's row `played`.
  void pass(PatternState& state, const ZmpReference& reference, int played) const noexcept;

  // By how much the leg in the air shifts the ZMP, `in_swing` points into the swing.
  [[nodiscard]] Eigen::RowVector2d swing_zmp_m(const SwingFoot& swing, int in_swing) const noexcept;
  [[nodiscard]] Eigen::RowVector2d stand_com(const std::array<Pose2, 2>& feet) const noexcept;
  [[nodiscard]] const DivergenceAbsorber& absorber() const noexcept { return absorber_; }

 private:
  double swing_moment_s2_, stand_com_forward_m_;
  int settle_points_;
  DivergenceAbsorber absorber_;
};

}  // namespace gaitway::trajectory
