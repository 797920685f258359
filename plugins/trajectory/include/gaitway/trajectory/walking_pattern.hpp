// The walking pattern: from the newest walk command to the next batch of points and its safe tail.
#pragma once

#include <array>
#include <cstdint>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/divergence_absorber.hpp"
#include "gaitway/trajectory/footstep_planner.hpp"
#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/trajectory/hip_height.hpp"
#include "gaitway/trajectory/preview_controller.hpp"
#include "gaitway/trajectory/quintic.hpp"
#include "gaitway/trajectory/step_adjustment.hpp"
#include "gaitway/trajectory/swing_foot.hpp"

namespace gaitway::trajectory {

enum class Phase : std::uint8_t {
  stand,     // at rest in the nominal stand
  walking,   // in a step: double support, then swing
  settling,  // feet side by side, the CoM comes to rest
};

// One step: double support, in which the reference ZMP moves to the stance foot, then the swing.
struct Step {
  Side swing = Side::left;
  int double_support_points = 0;
  int swing_points = 0;
  bool last = false;     // the robot settles after it
  bool lead_in = false;  // first step from the stand: the ZMP moves smoothly, not linearly
  Pose2 stance;
  Pose2 landing;
  Eigen::Vector2d adjustment_m = Eigen::Vector2d::Zero();  // of the landing by StepAdjustment, stance frame
  Velocity2 velocity_before, velocity;  // of the step before, and with which this one was planned
  // The turn rate that the commands alone would have, without the yaw feedback.
  double commanded_turn_before_rad_per_s = 0.0, commanded_turn_rad_per_s = 0.0;
  Eigen::RowVector2d zmp_from = Eigen::RowVector2d::Zero(), zmp_to = Eigen::RowVector2d::Zero();

  [[nodiscard]] int points() const noexcept { return double_support_points + swing_points; }
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.swing, self.double_support_points, self.swing_points, self.last, self.lead_in, self.stance,
            self.landing, self.adjustment_m, self.velocity_before, self.velocity,
            self.commanded_turn_before_rad_per_s, self.commanded_turn_rad_per_s, self.zmp_from, self.zmp_to);
  }
};

// All that a plan depends on; copied to make the safe tail.
struct PatternState {
  Phase phase = Phase::stand;
  int elapsed_points = 0;  // of the step, or of the settling
  Cart cart;
  Eigen::RowVector2d divergence = Eigen::RowVector2d::Zero();  // that the reference in force asks for now, m
  ZmpOffset zmp_offset;                                        // absorbs changes of footsteps
  std::array<Pose2, 2> feet;  // [Side], on the ground or where the swing foot is
  std::array<double, 2> foot_height_m{};
  Step step;  // in flight while walking
  SwingFoot swing;
  std::array<Quintic, 2> settle;  // x, y of the CoM
  HipHeight hips;
  int recovery_steps = 0;                      // to be taken in place before the robot stands again
  std::array<double, 2> yaw_correction_rad{};  // [Side]: by which the yaw feedback has turned the foot so far
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.phase, self.elapsed_points, self.cart, self.divergence, self.zmp_offset, self.feet,
            self.foot_height_m, self.step, self.swing, self.settle, self.hips, self.recovery_steps,
            self.yaw_correction_rad);
  }
};

// Plans in the frame `plan`. No allocation, no exception after construction.
class WalkingPattern {
 public:
  // Throws std::invalid_argument (see GaitParameters::validate).
  explicit WalkingPattern(const GaitParameters& parameters);

  // Stands at rest with the middle between the sole origins at (x, y), heading yaw.
  void reset_to_stand(const Pose2& middle) noexcept;

  // Advances by kBatchPoints points towards `command` and fills `plan`, with the safe tail that begins at the
  // end of the batch. A non-finite command counts as a stop, a non-finite correction as none.
  // correction.step_offset moves the next footstep that is not fixed yet. About 5 µs.
  // `dcm_deviation_m`: by how much the body's DCM will be off the plan's at start_ns, in the plan's frame;
  // the step in flight is adjusted to it. A walk command that comes back in the last step before the stand
  // takes effect when the robot settles.
  void plan(std::uint32_t sequence, std::int64_t start_ns, const WalkCommand& command,
            const Correction& correction, MotionPlan& plan,
            const Eigen::Vector2d& dcm_deviation_m = Eigen::Vector2d::Zero()) noexcept;

  // Plans the last batch anew from its point `first` on, which plan() was told by revise_from(), and its
  // tail; the points before stay as `plan` has them. False, and nothing changes: `plan` is not of the last
  // batch, or that was revised before. dcm_deviation_m: at the start of that slot.
  bool revise(const WalkCommand& command, const Correction& correction, MotionPlan& plan,
              const Eigen::Vector2d& dcm_deviation_m) noexcept;
  // The point, 1..kBatchPoints - 1, from which batches may be revised from now on.
  void revise_from(int first) noexcept { first_revised_ = first; }
  // The last revision is not played: the batch goes on as it was planned first.
  void take_revision_back() noexcept;

  // By how much the DCM of the last plan, or revision, jumped at its start, towards the body's; plan's frame.
  [[nodiscard]] const Eigen::Vector2d& answered_m() const noexcept { return answered_m_; }
  // Where the tail of the last plan ends: the middle between the sole origins.
  [[nodiscard]] const Pose2& final_stance() const noexcept { return final_stance_; }
  [[nodiscard]] const PatternState& state() const noexcept { return state_; }
  // Which rules limited the footsteps of the last plan.
  [[nodiscard]] StepLimit applied_limits() const noexcept { return applied_; }
  // The reference that the last batch's preview followed, offset included; row 0 is the batch's start. Empty
  // unless walking.
  [[nodiscard]] const ZmpReference& reference() const noexcept { return batch_reference_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.state_, self.final_stance_);
  }

 private:
  static constexpr int kMaxSteps = 40;
  static constexpr int kRecoverySteps = 5;
  struct Schedule {
    std::array<Step, kMaxSteps> steps;
    int count = 0, next = 0;  // steps[next] follows the step in flight
    bool ends = false;        // after the last step the robot settles
  };

  // What is asked for: by the commands, and with the yaw feedback's correction.
  struct Wanted {
    Velocity2 velocity;
    double commanded_turn_rad_per_s = 0.0;
  };

  void begin_walking(PatternState& state, const Velocity2& wanted) noexcept;
  void begin_settling(PatternState& state) const noexcept;
  // Aim the step in flight, or begin one, and fill schedule_ with the steps that follow it.
  void schedule_walk(PatternState& state, const Wanted& wanted, const Eigen::Vector2d& offset_m,
                     const Eigen::Vector2d& dcm_deviation_m) noexcept;
  // Fills schedule_ with the steps after the one in flight.
  void schedule_steps_after(const Step& flying, int elapsed_points, const Wanted& wanted,
                            Eigen::Vector2d offset_m) noexcept;
  void schedule_stop(PatternState& state) noexcept;
  // A standing robot whose DCM has left its soles steps after it, where a bow that has begun does not catch
  // it.
  [[nodiscard]] bool must_recover(const PatternState& state, const Eigen::Vector2d& dcm_deviation_m,
                                  double bow_rad) const noexcept;
  void begin_recovery(PatternState& state, const Eigen::Vector2d& dcm_deviation_m, double bow_rad) noexcept;
  // Where the hips are to be when the first step of a recovery lands.
  [[nodiscard]] double recovery_hip_height_m(const Step& step, double bow_rad) const noexcept;
  // Of the schedule as it is: false where there is nothing to adjust.
  bool adjust_step(PatternState& state, const Eigen::Vector2d& dcm_deviation_m) noexcept;
  // By the reference laid out in batch_reference_.
  [[nodiscard]] StepInFlight step_in_flight(const PatternState& state) const noexcept;
  [[nodiscard]] Step step_after(const Step& before, const Wanted& wanted,
                                const Eigen::Vector2d& offset_m) noexcept;
  // Velocities and landing place of a step after those of the step before.
  void aim_step(Step& step, const Wanted& wanted, const Eigen::Vector2d& offset_m) noexcept;
  [[nodiscard]] double yaw_correction_rad(const PatternState& state) const noexcept;
  [[nodiscard]] Step closing_step_after(const Step& before) const noexcept;
  // The steps' reference as it is planned, and with what absorbs their changes.
  void lay_out_reference(const PatternState& state, int points, ZmpReference& reference) const noexcept;
  void fill_reference(PatternState& state, int points, ZmpReference& reference) const noexcept;
  // What absorbs changes of the reference goes on from its row `played`.
  void pass(PatternState& state, const ZmpReference& reference, int played) const noexcept;
  void schedule(const WalkCommand& command, const Correction& correction,
                const Eigen::Vector2d& dcm_deviation_m) noexcept;
  void write_batch(int first, MotionPlan& plan) noexcept;
  [[nodiscard]] double landing_yaw_correction_rad(const PatternState& state) const noexcept;
  // The hips' way to another height from where they are.
  void aim_hips(PatternState& state, double goal_m) const noexcept;
  // By how much the leg in the air shifts the ZMP, `in_swing` points into the swing.
  [[nodiscard]] Eigen::RowVector2d swing_zmp_m(const SwingFoot& swing, int in_swing) const noexcept;
  void advance(PatternState& state, const ZmpReference& reference, int index) noexcept;
  void advance_step(PatternState& state) noexcept;
  void advance_settling(PatternState& state) const noexcept;
  // Of the swing, what is done: 0 in the double support.
  [[nodiscard]] static double swing_share(const PatternState& state) noexcept;
  [[nodiscard]] bool is_open(const PatternState& state) const noexcept;
  [[nodiscard]] static bool must_finish_stop(const PatternState& state) noexcept;
  void write_point(const PatternState& state, std::size_t index, MotionPlan& plan) const noexcept;
  // `state` is at the plan's point `first`.
  void write_footsteps(const PatternState& state, int first, MotionPlan& plan) const noexcept;
  void write_tail(MotionPlan& plan) noexcept;
  [[nodiscard]] Eigen::RowVector2d stance_zmp(Side side, const Pose2& foot) const noexcept;
  [[nodiscard]] Eigen::RowVector2d stand_com(const std::array<Pose2, 2>& feet) const noexcept;

  GaitParameters parameters_;
  PreviewController controller_;
  DivergenceAbsorber absorber_;
  FootstepPlanner planner_;
  StepAdjustment adjustment_;
  PatternState state_, tail_state_;
  // Of the last batch: where it may be revised, and, once it is, how it ended as it was planned first.
  int first_revised_ = 0;  // 0: it may not
  std::uint32_t revisable_sequence_ = 0;
  PatternState revisable_state_, unrevised_state_;
  Pose2 unrevised_final_stance_;
  Schedule schedule_;
  ZmpReference batch_reference_, tail_reference_;
  Pose2 final_stance_;
  Eigen::Vector2d answered_m_ = Eigen::Vector2d::Zero();
  StepLimit applied_ = StepLimit::none;
};

// The middle between two feet.
[[nodiscard]] Pose2 middle_of(const std::array<Pose2, 2>& feet) noexcept;

}  // namespace gaitway::trajectory
