// Connects the batch solver to its topics: motion plan and correction in, joint plan out.
#include <string>

#include "gaitway/kinematics/batch_solver.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/plugin/cycle.hpp"
#include "gaitway/plugin/plugin.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {
namespace {

// A correction older than this is no longer asked for: it is faded out over the next batch.
constexpr std::int64_t kCorrectionLifetime_ns = 200'000'000;

class Kinematics final : public Plugin {
 public:
  explicit Kinematics(Setup& setup) : Kinematics(setup, urdf::load_robot(setup.robot_directory())) {}
  // Throws if a foot pose cannot be reached: the batch is not handed over then, and the safe tail plays on.
  void step(const Tick& tick) override {
    const MotionPlan& plan = motion_plan_.read();
    if (!tick.batch && !is_revision(tick, plan)) return;
    solved_ = motion_plan_.sequence();
    solved_batch_ = plan.sequence;
    solver_.plan_batch(tick.batch ? tick.batch_sequence : plan.sequence, plan, correction_at(tick.now_ns),
                       joint_plan_.value(), references(), plan.motion != 0 ? &posture_plan_.read() : nullptr);
    joint_plan_.publish();
  }

  [[nodiscard]] std::uint32_t state_version() const override { return 3; }
  void save_state(StateWriter& state) const override { state(solver_); }
  void restore_state(StateReader& state) override { state(solver_); }

 private:
  Kinematics(Setup& setup, const urdf::RobotModel& robot)
      : solver_(robot,
                solver_choice(setup.parameter("solver", "auto",
                                              "closed_form, kdl, or auto: the first that the legs allow")),
                setup.parameter("compensate_load", true,
                                "leads the joints by what the servos give way under load")),
        revision_slot_(robot.network.revision_slot),
        motion_plan_(setup.reads<MotionPlan>("motion_plan")),
        posture_plan_(setup.reads_optional<PosturePlan>("posture_plan")),
        correction_(setup.reads_optional<Correction>("correction")),
        joint_states_(setup.reads_optional<JointStates>("joint_states")),
        joint_plan_(setup.writes<JointPlan>("joint_plan")) {
    setup.period(revision_slot_ > 0 ? Period::tick : Period::batch);
  }

  // Of the batch that runs, which this object has solved before.
  bool is_revision(const Tick& tick, const MotionPlan& plan) {
    return core::is_revision_tick(tick, revision_slot_) && motion_plan_.sequence() != solved_ &&
           plan.sequence + 1 == tick.batch_sequence && plan.sequence == solved_batch_ && plan.motion == 0;
  }

  Correction correction_at(std::int64_t now_ns) {
    const bool asked = correction_.has_value() && correction_.age_ns(now_ns) <= kCorrectionLifetime_ns;
    return asked ? correction_.read() : Correction{};
  }

  std::span<const double> references() {
    if (!joint_states_.has_value()) return {};
    const JointStates& joints = joint_states_.read();
    return {joints.reference_position, joints.joint_count};
  }

  BatchSolver solver_;
  int revision_slot_;         // of a cycle, from which its batch may be revised; 0: none is
  std::uint64_t solved_ = 0;  // of the motion plans: the last one
  std::uint32_t solved_batch_ = 0;
  Input<MotionPlan> motion_plan_;
  Input<PosturePlan> posture_plan_;
  Input<Correction> correction_;
  Input<JointStates> joint_states_;
  Output<JointPlan> joint_plan_;
};

}  // namespace
}  // namespace gaitway::kinematics

GAITWAY_PLUGIN(gaitway::kinematics::Kinematics, "kinematics", "1.0.0",
               "Turns a motion plan in task space into joint angles")
