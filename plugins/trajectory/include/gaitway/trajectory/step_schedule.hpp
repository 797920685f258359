// Which steps follow the one in flight, as far as the preview looks ahead, and their reference ZMP.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>

#include "gaitway/trajectory/divergence_absorber.hpp"
#include "gaitway/trajectory/footstep_planner.hpp"
#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/trajectory/pattern_state.hpp"

namespace gaitway::trajectory {

// What is asked for: by the commands, and with the yaw feedback's correction.
struct WantedWalk {
  Velocity2 velocity;
  double commanded_turn_rad_per_s = 0.0;
};

class StepSchedule {
 public:
  explicit StepSchedule(const GaitParameters& parameters) : parameters_(parameters), planner_(parameters) {}
  void tune(const GaitParameters& parameters) noexcept {
    parameters_ = parameters;
    planner_ = FootstepPlanner(parameters);
  }

  // Velocities and landing place of a step after those of the step before. offset_m: of the landing, in the
  // stance foot's frame.
  void aim(Step& step, const WantedWalk& wanted, const Eigen::Vector2d& offset_m) noexcept;

  // Fills itself with the steps after the one in flight: for a walk that goes on, for a stop.
  void walk_after(const Step& flying, int elapsed_points, const WantedWalk& wanted,
                  Eigen::Vector2d offset_m) noexcept;
  // A foot on the ground becomes the closing foot; a foot in the air lands where it was to land, and the
  // other closes. A step that has been adjusted stays so. False: the feet are side by side, nothing is to be
  // stepped.
  [[nodiscard]] bool stop_after(PatternState& state) noexcept;

  // Of the steps after the one in flight.
  [[nodiscard]] std::span<const Step> steps() const noexcept {
    return std::span(steps_).first(static_cast<std::size_t>(count_));
  }
  // After the last step the robot settles.
  [[nodiscard]] bool ends() const noexcept { return ends_; }
  // The step that follows the one in flight becomes it; null: there is none.
  [[nodiscard]] const Step* begin_next() noexcept {
    return next_ < count_ ? &steps_[static_cast<std::size_t>(next_++)] : nullptr;
  }

  [[nodiscard]] Eigen::RowVector2d stance_zmp(Side side, const Pose2& foot) const noexcept;
  [[nodiscard]] const FootstepPlanner& planner() const noexcept { return planner_; }

  // Which rules have limited footsteps since forget_limits().
  [[nodiscard]] StepLimit applied_limits() const noexcept { return applied_; }
  void forget_limits() noexcept { applied_ = StepLimit::none; }

 private:
  static constexpr int kMaxSteps = 40;

  [[nodiscard]] Step closing_step_after(const Step& before) const noexcept;

  GaitParameters parameters_;
  FootstepPlanner planner_;
  std::array<Step, kMaxSteps> steps_;
  int count_ = 0, next_ = 0;
  bool ends_ = false;
  StepLimit applied_ = StepLimit::none;
};

// The reference ZMP of the steps that are scheduled, and the offset in it that absorbs their changes.
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
  double swing_moment_s2_, swing_flatness_, stand_com_forward_m_;
  int settle_points_;
  DivergenceAbsorber absorber_;
};

}  // namespace gaitway::trajectory
