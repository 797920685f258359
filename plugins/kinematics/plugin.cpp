// Connects the batch solver to its topics: motion plan and correction in, joint plan out.
#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/kinematics/batch_solver.hpp"
#include "gaitway/kinematics/held_start.hpp"
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
    take_back_refused();
    solved_batch_ = plan.sequence;
    if (solver_.plan_batch(tick.batch_sequence, plan, correction_at(tick.now_ns), joint_plan_.value(),
                           references(), plan.motion != 0 ? &posture_plan_.read() : nullptr)) {
      begin_where_held(tick.batch_sequence);
    }
    joint_plan_.publish();
  }

  [[nodiscard]] std::uint32_t state_version() const override { return 5; }
  void save_state(StateWriter& state) const override { state(solver_, held_start_); }
  void restore_state(StateReader& state) override { state(solver_, held_start_); }

 private:
  Kinematics(Setup& setup, const urdf::RobotModel& robot)
      : solver_(robot,
                solver_choice(setup.parameter("solver", "auto",
                                              "closed_form, kdl, or auto: the first that the legs allow")),
                setup.parameter("compensate_load", true,
                                "leads the joints by what the servos give way under load")),
        held_start_(robot),
        report_(setup.reporter()),
        motion_plan_(setup.reads<MotionPlan>("motion_plan")),
        posture_plan_(setup.reads_optional<PosturePlan>("posture_plan")),
        correction_(setup.reads_optional<Correction>("correction")),
        joint_states_(setup.reads_optional<JointStates>("joint_states")),
        network_(setup.reads_optional<NetworkState>("network_state")),
        joint_plan_(setup.writes<JointPlan>("joint_plan")) {
    for (const urdf::Joint& joint : robot.joints) names_.push_back(joint.name);
    setup.period(Period::batch);
  }

  // What comes next goes on from what was accepted.
  void take_back_refused() {
    if (!network_.has_value()) return;
    const std::uint32_t accepted = network_.read().accepted_sequence;
    solver_.go_on_from(accepted);
    if (solved_batch_ != 0 && solved_batch_ != accepted) held_start_.take_back();
  }

  // A batch for a robot that holds still, be it after a safe tail, must not begin elsewhere: it would be
  // refused for ever.
  void begin_where_held(std::uint32_t sequence) {
    const bool holds = network_.has_value() && network_.read().mode == network_state::mode::holding;
    const bool sets_out_itself = motion_plan_.read().motion != 0 && posture_plan_.read().from_home != 0;
    if (sets_out_itself) held_start_.forget();
    HeldStart::Detour detour;
    if (!held_start_.apply(holds ? references() : std::span<const double>{}, joint_plan_.value(), detour)) {
      return;
    }
    std::array<char, 200> text{};
    fmt::format_to_n(text.data(), text.size() - 1,
                     "batch {} does not begin where the joints are held: '{}' is {:.2g} rad from it, and all "
                     "are led there in {:.2g} s",
                     sequence, names_[detour.joint], detour.way_rad, detour.time_s);
    report_(Severity::warning, text.data());
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
  HeldStart held_start_;
  std::vector<std::string> names_;  // of the joints
  std::uint32_t solved_batch_ = 0;
  Reporter report_;
  Input<MotionPlan> motion_plan_;
  Input<PosturePlan> posture_plan_;
  Input<Correction> correction_;
  Input<JointStates> joint_states_;
  Input<NetworkState> network_;
  Output<JointPlan> joint_plan_;
};

}  // namespace
}  // namespace gaitway::kinematics

GAITWAY_PLUGIN(gaitway::kinematics::Kinematics, "kinematics", "1.0.0",
               "Turns a motion plan in task space into joint angles")
