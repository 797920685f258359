// Which steps follow the one in flight, as far as the preview looks ahead, and their reference ZMP.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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

// The steps of a footstep plan that come next, in the frame `plan`.
struct PlannedSteps {
  struct Place {
    Side side = Side::left;
    Pose2 pose;
  };
  std::array<Place, kMaxPlannedSteps> place;
  std::uint32_t first = 1;          // number of place[0]
  std::uint32_t count = 0;          // 0: nothing is to be followed
  bool ends = false;                // the last of them is the way's last
  double yaw_correction_rad = 0.0;  // of the frame `plan` against the measured heading

  [[nodiscard]] const Place* find(std::uint32_t number) const noexcept {
    return number >= first && number - first < count ? &place[number - first] : nullptr;
  }
  // The number of the first one after `number`; 0: there is none.
  [[nodiscard]] std::uint32_t next_after(std::uint32_t number) const noexcept {
    const std::uint32_t next = std::max(first, number + 1);
    return find(next) != nullptr ? next : 0;
  }
  [[nodiscard]] bool is_last(std::uint32_t number) const noexcept {
    return ends && number + 1 == first + count;
  }
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
  // Sets a step to where the plan has its number. stance_correction_rad: by which the yaw feedback has turned
  // its stance foot.
  void place(Step& step, const PlannedSteps& steps, double stance_correction_rad) noexcept;
  // Whether the step of that number can be taken from there as it is planned, but for what a correction of
  // the pose may have moved it.
  [[nodiscard]] bool is_in_reach(const Pose2& stance, const PlannedSteps& steps,
                                 std::uint32_t number) const noexcept;
  // The planned steps after the one in flight, as far as the preview asks for them; then the stand.
  void follow_after(const Step& flying, int elapsed_points, const PlannedSteps& steps) noexcept;
  // Where a step lands that is moved after the body by `offset_m` (stance frame) in all.
  [[nodiscard]] Pose2 adjusted_landing(const Step& step, const Eigen::Vector2d& offset_m) const noexcept;
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
