// From a motion plan in task space to a joint plan: the batch and its safe tail.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gaitway/kinematics/correction_fade.hpp"
#include "gaitway/kinematics/leg_speed.hpp"
#include "gaitway/kinematics/load_compensation.hpp"
#include "gaitway/kinematics/whole_body_placement.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/arm_swing.hpp"
#include "gaitway/urdf/neck.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {

// What became of a batch. If not solved, the joint plan must not be handed over.
struct BatchOutcome {
  enum class Kind { solved, too_many_points, leg_unreachable, com_not_placed, no_posture };
  Kind kind = Kind::solved;
  int point = 0;  // at which it failed; 0 is the first of the batch, kBatchPoints the first of the tail
  urdf::Side side = urdf::Side::left;  // leg_unreachable: the side
  LegSolution leg;                     // leg_unreachable: why, and by how much

  [[nodiscard]] bool solved() const noexcept { return kind == Kind::solved; }
};

// Solves every point of the batch with the CoM where it is planned (kBatchTolerance_m). In the tail, the
// base's offset from the CoM is solved at every fourth point and interpolated between; the legs are solved at
// each. Arms swing and the head turns as the plan has it; all other joints stay at home. Remembers the last
// batch's offsets as first guess, and the correction.
class BatchSolver {
 public:
  static constexpr double kBatchTolerance_m = 0.05e-3;
  static constexpr double kTailTolerance_m = 0.1e-3;  // at the points that are solved, not interpolated

  // Throws urdf::RobotError if the model does not fit the topics or the choice of the solver.
  // compensate_load: the references of the legs lead by what their servos give way under the planned load.
  BatchSolver(const urdf::RobotModel& model, SolverChoice choice, bool compensate_load = false);

  // Fills joint_plan; on failure its content is unspecified and this object is as before. reference_rad:
  // where the joints' references are now, in the model's order; empty if that is not known. No allocation.
  // posture: of a plan whose `motion` is set, else nullptr. Its offsets already lead by what the motion's
  // load takes beyond the stand's: they are added to the references of the stand, which are solved as ever.
  [[nodiscard]] BatchOutcome solve(const MotionPlan& plan, const BaseOffset& correction,
                                   JointPlan& joint_plan, std::span<const double> reference_rad = {},
                                   const PosturePlan* posture = nullptr);

  // All that a plug-in does for the batch of a tick: joint_plan is solved, or says "no plan" (sequence 0)
  // while `plan` is none for the batch of that number. True: solved. Throws std::runtime_error where a foot
  // is out of reach, or a motion's posture does not belong to the plan.
  bool plan_batch(std::uint32_t sequence, const MotionPlan& plan, const Correction& correction,
                  JointPlan& joint_plan, std::span<const double> reference_rad = {},
                  const PosturePlan* posture = nullptr);

  // The newest batch that plays, or whose tail does: one that was solved after it and refused is taken back,
  // so that the next goes on from what is played. To be told before each batch.
  void go_on_from(std::uint32_t accepted_sequence) noexcept;

  // A failure in words: which side, at which point, by how much. Allocates.
  [[nodiscard]] std::string describe(const BatchOutcome& outcome) const;

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.fade_, self.past_, self.fade_before_, self.past_before_);
    if (self.load_compensation_) archive(*self.load_compensation_);
  }

 private:
  struct Knot {  // a point at which the base was placed
    double point = 0.0;
    Eigen::Vector2d used_m = Eigen::Vector2d::Zero();     // offset with which the legs were solved
    Eigen::Vector2d refined_m = Eigen::Vector2d::Zero();  // best known offset
    LegAngles angle_rad{};
    template <class Self, class Archive>
    static void visit_state(Self& self, Archive& archive) {
      archive(self.point, self.used_m, self.refined_m, self.angle_rad);
    }
  };
  struct Run;  // the state of one call

  BatchOutcome solve_point(Run& run, int point, const Eigen::Vector2d& guess_m, double tolerance_m,
                           const std::optional<LegAngles>& start_rad, Knot& knot);
  // Drawn through three points, for legs that want a start.
  [[nodiscard]] std::optional<LegAngles> start_at(int point, const Knot& first, const Knot& second,
                                                  const Knot& third) const noexcept;
  // The points of the tail between the last two of three at which the base was placed. recent: the last three
  // that were solved.
  BatchOutcome solve_between(Run& run, const std::array<Knot, 3>& knots, std::array<Knot, 3>& recent);
  BatchOutcome solve_standing_or_walking(const MotionPlan& plan, const BaseOffset& correction,
                                         JointPlan& joint_plan, std::span<const double> reference_rad);
  void stand_at_home(const MotionPlan& plan, JointPlan& joint_plan) noexcept;
  BatchOutcome solve_batch(Run& run);
  BatchOutcome solve_tail(Run& run);
  void write(JointPlan& joint_plan, int point, const BothLegs& legs) const noexcept;
  void swing_arms(Run& run) const noexcept;
  void turn_head(const MotionPlan& plan, JointPlan& joint_plan) const noexcept;
  void note_base(const PlanPoint& planned, const PointFrames& frames, const Eigen::Vector2d& offset_m,
                 int point) noexcept;

  const urdf::RobotModel model_;
  WholeBodyPlacement placement_;
  std::unique_ptr<LoadCompensation> load_compensation_;  // large; none: the references are the planned angles
  LegSpeed leg_speed_;
  std::vector<float> home_rad_;
  std::optional<urdf::ArmSwing> arms_;
  urdf::Neck neck_;
  CorrectionFade fade_, fade_before_;  // of the next batch, and of the last one
  struct Past {
    std::uint32_t sequence = 0;  // of the last batch that was solved
    std::array<Knot, 3> last{};  // its last three points
    double arm_back_rad = 0.0;   // the left arm at its end
    LegAngles reference_rad{};   // of the legs, at its end
    template <class Self, class Archive>
    static void visit_state(Self& self, Archive& archive) {
      archive(self.sequence, self.last, self.arm_back_rad, self.reference_rad);
    }
    [[nodiscard]] bool precedes(const MotionPlan& plan) const noexcept {
      return sequence != 0 && plan.sequence == sequence + 1;
    }
  };
  Past past_, past_before_;  // of the next batch, and of the last one
  std::unique_ptr<MotionPlan> stand_ = std::make_unique<MotionPlan>();  // of a motion; large
};

}  // namespace gaitway::kinematics
