// The walking pattern: from the newest walk command to the next batch of points and its safe tail.
#pragma once

#include <cstdint>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/trajectory/pattern_state.hpp"
#include "gaitway/trajectory/preview_controller.hpp"
#include "gaitway/trajectory/push_recovery.hpp"
#include "gaitway/trajectory/step_schedule.hpp"

namespace gaitway::trajectory {

// Plans in the frame `plan`. No allocation, no exception after construction.
class WalkingPattern {
 public:
  // Throws std::invalid_argument (see GaitParameters::validate).
  explicit WalkingPattern(const GaitParameters& parameters);

  // The live numbers of the parameters; see GaitParameters::numbers(). Between two plans; no allocation.
  void tune(const GaitParameters& changed) noexcept;

  // Stands at rest with the middle between the sole origins at (x, y), heading yaw.
  void reset_to_stand(const Pose2& middle) noexcept;

  // Advances by kBatchPoints points towards `command` and fills `plan`, with the safe tail that begins at the
  // end of the batch. A non-finite command counts as a stop, a non-finite correction as none.
  // correction.step_offset moves the next footstep that is not fixed yet. About 5 µs.
  // `dcm_deviation_m`: by how much the body's DCM will be off the plan's at start_ns, in the plan's frame;
  // the step in flight is adjusted to it. A walk command that comes back in the last step before the stand
  // takes effect when the robot settles. `steps`: followed while nothing is commanded; a robot that walks by
  // a command stands first. A first step that is out of reach is not taken.
  void plan(std::uint32_t sequence, std::int64_t start_ns, const WalkCommand& command,
            const Correction& correction, MotionPlan& plan,
            const Eigen::Vector2d& dcm_deviation_m = Eigen::Vector2d::Zero(),
            const PlannedSteps& steps = {}) noexcept;

  // By how much the DCM of the last plan jumped at its start, towards the body's; plan's frame.
  [[nodiscard]] const Eigen::Vector2d& answered_m() const noexcept { return answered_m_; }
  // Where the tail of the last plan ends: the middle between the sole origins.
  [[nodiscard]] const Pose2& final_stance() const noexcept { return final_stance_; }
  [[nodiscard]] const PatternState& state() const noexcept { return state_; }
  // Which rules limited the footsteps of the last plan.
  [[nodiscard]] StepLimit applied_limits() const noexcept { return schedule_.applied_limits(); }
  // The reference that the last batch's preview followed, offset included; row 0 is the batch's start. Empty
  // unless walking.
  [[nodiscard]] const ZmpReference& reference() const noexcept { return batch_reference_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.state_, self.final_stance_);
  }

 private:
  // What the steps are to be from now on: by what is asked for, and by where the body is.
  void schedule(const WalkCommand& command, const Correction& correction,
                const Eigen::Vector2d& dcm_deviation_m, const PlannedSteps& steps) noexcept;
  void schedule_planned(PatternState& state, const PlannedSteps& steps,
                        const Eigen::Vector2d& dcm_deviation_m) noexcept;
  void stop(const Eigen::Vector2d& dcm_deviation_m) noexcept;
  void schedule_walk(PatternState& state, const WantedWalk& wanted, const Eigen::Vector2d& offset_m,
                     const Eigen::Vector2d& dcm_deviation_m) noexcept;
  void schedule_stop(PatternState& state) noexcept;
  void begin_walking(PatternState& state, Side swing) noexcept;
  void begin_settling(PatternState& state) const noexcept;
  // The hips' way to another height from where they are.
  void aim_hips(PatternState& state, double goal_m) const noexcept;
  [[nodiscard]] bool is_open(const PatternState& state) const noexcept;

  // By a point, which the reference's row `index` is for.
  void advance(PatternState& state, const ZmpReference& reference, int index) noexcept;
  void advance_step(PatternState& state) noexcept;
  void advance_settling(PatternState& state) const noexcept;

  void write_batch(MotionPlan& plan) noexcept;
  void write_tail(MotionPlan& plan) noexcept;
  void write_point(const PatternState& state, std::size_t index, MotionPlan& plan) const noexcept;
  void write_footsteps(MotionPlan& plan) const noexcept;

  GaitParameters parameters_;
  PreviewController controller_;
  StepSchedule schedule_;
  WalkReference walk_;
  PushRecovery recovery_;
  PatternState state_, tail_state_;
  ZmpReference batch_reference_, tail_reference_;
  Pose2 final_stance_;
  Eigen::Vector2d answered_m_ = Eigen::Vector2d::Zero();
};

}  // namespace gaitway::trajectory
