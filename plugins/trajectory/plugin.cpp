// The plug-in `trajectory`: connects the walking pattern and the player of motions to their topics.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/plugin/cycle.hpp"
#include "gaitway/plugin/plugin.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/trajectory/divergence_feedback.hpp"
#include "gaitway/trajectory/fall_posture.hpp"
#include "gaitway/trajectory/footstep_planner.hpp"
#include "gaitway/trajectory/head_planner.hpp"
#include "gaitway/trajectory/joint_torque.hpp"
#include "gaitway/trajectory/motion_admission.hpp"
#include "gaitway/trajectory/motion_player.hpp"
#include "gaitway/trajectory/motion_table.hpp"
#include "gaitway/trajectory/plan_continuity.hpp"
#include "gaitway/trajectory/planned_steps.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"

namespace gaitway::trajectory {
namespace {

// The parameters with the configuration's numbers. Throws std::invalid_argument if they break a rule or
// the robot cannot walk with them (require_walkable); one that is too weak to walk with
// is reported.
const GaitParameters& configured(Setup& setup, const urdf::RobotModel& robot, GaitParameters& parameters) {
  setup.parameters(parameters.numbers());
  parameters.validate();
  require_walkable(parameters, robot);
  if (const std::string weak = weakest_joint(leg_torques(parameters, robot), robot); !weak.empty()) {
    setup.reporter()(Severity::warning, weak.c_str());
  }
  return parameters;
}

// The tables of the folder that the parameter names, or of the robot's own; where two have a name, the first.
std::vector<MotionTable> tables_of(Setup& setup, const std::filesystem::path& robot_directory) {
  const std::string folder =
      setup.parameter("motions", "", "folder with prepared motions; empty: those of the robot's folder");
  const std::vector<std::filesystem::path> folders =
      folder.empty() ? process::prepared_motion_directories(robot_directory)
                     : std::vector<std::filesystem::path>{folder};
  std::vector<MotionTable> tables;
  for (const std::filesystem::path& place : folders) {
    for (const std::filesystem::path& file : motion_table_files(place)) {
      MotionTable table = read_motion_table(file);
      if (std::ranges::find(tables, table.name, &MotionTable::name) == tables.end())
        tables.push_back(std::move(table));
    }
  }
  return tables;
}

// Those that can be played. One that was prepared for another robot, or for another stand than this
// configuration's, is left out, and that is reported.
std::vector<MotionTable> motions_of(Setup& setup, const urdf::RobotModel& robot,
                                    const GaitParameters& parameters, const GaitParameters& described) {
  const std::filesystem::path directory = setup.robot_directory();
  const std::uint64_t digest = robot_digest(directory);
  const bool own_stand = stands_as_described(parameters, described);
  std::vector<MotionTable> motions;
  for (MotionTable& motion : tables_of(setup, directory)) {
    if (motion.robot_digest == digest && own_stand && motion.joint_count == robot.joints.size()) {
      motions.push_back(std::move(motion));
      continue;
    }
    const std::string text =
        fmt::format("the motion '{}' cannot be played: it was prepared for {}", motion.name,
                    own_stand ? "another robot. Prepare it for this one with `gaitway motion prepare`"
                              : "the robot's standing posture, and the parameters give another one");
    setup.reporter()(Severity::warning, text.c_str());
  }
  return motions;
}

class Trajectory final : public Plugin {
 public:
  explicit Trajectory(Setup& setup) : Trajectory(setup, urdf::load_robot(setup.robot_directory())) {}

  void step(const Tick& tick) override {
    pattern_.tune(parameters_);
    limits_.tune(parameters_);
    MotionPlan& plan = plan_.value();
    const NetworkState network = network_at(tick);
    PlanDecision decision = continuity_.decide(tick.batch_sequence, network);
    if (joint_plan_.has_value()) accepted_.take(joint_plan_.read(), network.accepted_sequence);
    if (decision != PlanDecision::resume) player_.break_off();
    if (decision == PlanDecision::begin_anew) pattern_.reset_to_stand(continuity_.restart_stance());
    const WalkCommand walk = commanded(tick.now_ns);
    answer_motion_request(tick, walk, decision);
    if (respond_to_fall(tick, decision)) decision = PlanDecision::resume;
    if (decision == PlanDecision::wait || (player_.lies() && !fall_.plays())) {
      plan.sequence = 0;
      plan.tail_count = 0;
      plan.footstep_count = 0;
      plan.motion = 0;
    } else if (fall_.plays()) {
      fall_.plan(tick.batch_sequence, tick.batch_start_ns, stand_, plan, posture_.value());
      continuity_.published(tick.batch_sequence, pattern_.final_stance());
      posture_.publish();
    } else if (player_.plays()) {
      player_.plan(tick.batch_sequence, tick.batch_start_ns, plan, posture_.value());
      continuity_.published(tick.batch_sequence, pattern_.final_stance());
      posture_.publish();
    } else {
      plan_steps(tick, walk, plan);
    }
    plan_head(decision, plan);
    plan_.publish();
    player_.tell(state_.value());
    state_.value().stamp_ns = tick.now_ns;
    state_.publish();
    tell_footsteps(tick, decision);
  }

  [[nodiscard]] std::uint32_t state_version() const override { return 10; }
  void save_state(StateWriter& state) const override {
    state(pattern_, divergence_, continuity_, player_, admission_, fall_, void_until_ns_, head_);
  }
  void restore_state(StateReader& state) override {
    state(pattern_, divergence_, continuity_, player_, admission_, fall_, void_until_ns_, head_);
  }

 private:
  Trajectory(Setup& setup, const urdf::RobotModel& robot) : Trajectory(setup, robot, gait_of(robot)) {}
  Trajectory(Setup& setup, const urdf::RobotModel& robot, const GaitParameters& described)
      : parameters_(described),
        pattern_(configured(setup, robot, parameters_)),
        divergence_(parameters_),
        player_(motions_of(setup, robot, parameters_, described)),
        admission_(player_.motions(), robot),
        fall_(robot),
        head_(robot),
        takes_fall_posture_(
            setup.parameter("fall_posture", true, "a falling robot takes a posture to meet the ground in") &&
            fall_.exists()),
        stand_{{}, parameters_.stand_com_forward_m, parameters_.hip_height_m, parameters_.foot_spacing_m},
        limits_(parameters_),
        report_(setup.reporter()),
        walk_(setup.reads_optional<WalkCommand>("walk_command")),
        request_(setup.reads_optional<MotionRequest>("motion_command")),
        look_(setup.reads_optional<HeadCommand>("head_command")),
        estimate_(setup.reads_optional<Estimate>("estimate")),
        joints_(setup.reads_optional<JointStates>("joint_states")),
        footsteps_(setup.reads_optional<FootstepPlan>("footstep_plan")),
        network_(setup.reads_optional<NetworkState>("network_state")),
        correction_(setup.reads_previous<Correction>("correction")),
        joint_plan_(setup.reads_previous_optional<JointPlan>("joint_plan")),
        plan_(setup.writes<MotionPlan>("motion_plan")),
        posture_(setup.writes<PosturePlan>("posture_plan")),
        state_(setup.writes<gaitway::MotionState>("motion_state")),
        footstep_state_(setup.writes<FootstepState>("footstep_state")) {
    setup.period(Period::batch);
  }

  Correction correction() { return correction_.has_value() ? correction_.read() : Correction{}; }

  Eigen::Vector2d deviation_m(std::int64_t start_ns) {
    if (!estimate_.has_value()) return Eigen::Vector2d::Zero();
    return divergence_.deviation_m(estimate_.read(), start_ns);
  }

  void plan_steps(const Tick& tick, const WalkCommand& walk, MotionPlan& plan) {
    pattern_.plan(tick.batch_sequence, tick.batch_start_ns, walk, correction(), plan,
                  deviation_m(tick.batch_start_ns), footsteps(tick.now_ns));
    divergence_.take(plan);
    divergence_.answered(pattern_.answered_m(), tick.batch_start_ns);
    report_limits(walk);
    continuity_.published(tick.batch_sequence, pattern_.final_stance());
  }

  // A posture of a fall, or a motion that begins on the ground, sets out from where the neck's joints are.
  void plan_head(PlanDecision decision, MotionPlan& plan) {
    if (look_.has_value()) head_.obey(look_.read());
    if (decision == PlanDecision::begin_anew) head_.begin_after_tail();
    const bool sets_out_itself = plan.motion != 0 && posture_.value().from_home != 0;
    if (plan.sequence == 0) return;  // the tail plays, at whose end the head goes on
    if (sets_out_itself) return head_.leave_to_others(plan);
    head_.plan(!player_.plays(), estimate_.has_value() ? &estimate_.read() : nullptr, plan);
  }

  // A plan from before a fall, or during it, is void, as a command is.
  PlannedSteps footsteps(std::int64_t now_ns) {
    if (!footsteps_.has_value() || !estimate_.has_value()) return {};
    const FootstepPlan& plan = footsteps_.read();
    return plan.stamp_ns <= void_until_ns_ ? PlannedSteps{}
                                           : planned_steps(plan, estimate_.read(), pattern_.state(), now_ns);
  }

  void tell_footsteps(const Tick& tick, PlanDecision decision) {
    if (!estimate_.has_value()) return;
    const bool free = decision != PlanDecision::wait && !player_.plays() && !player_.lies() &&
                      !fall_.plays() && estimate_.read().fall == estimate::fall::upright;
    FootstepState& state = footstep_state_.value();
    state.stamp_ns = tick.now_ns;
    if (describe(pattern_.state(), estimate_.read(), free, state)) footstep_state_.publish();
  }

  // Who commands a walk while a motion plays means the motion to end.
  void answer_motion_request(const Tick& tick, const WalkCommand& walk, PlanDecision decision) {
    if (player_.plays() && walk.walk != 0) player_.leave();
    if (!request_.has_value()) return;
    const MotionCircumstances now{.now_ns = tick.now_ns,
                                  .follows = decision != PlanDecision::wait,
                                  .falls = fall_.falls(),
                                  .stands = pattern_.state().phase == Phase::stand && walk.walk == 0,
                                  .estimate = estimate_.has_value() ? &estimate_.read() : nullptr,
                                  .joints = joints_.has_value() ? &joints_.read() : nullptr};
    const std::optional<MotionOrder> order = admission_.answer(request_.read(), now, player_, state_.value());
    if (!order || (order->kind == MotionOrder::Kind::none && state_.value().refused == 0)) return;
    report_(state_.value().refused != 0 ? Severity::warning : Severity::info,
            reinterpret_cast<const char*>(state_.value().text));
    if (order->kind == MotionOrder::Kind::leave) player_.leave();
    if (order->kind != MotionOrder::Kind::play) return;
    fall_.end();
    stand_.middle = middle_of(pattern_.state().feet);
    player_.start(order->motion, stand_, admission_.offsets(now));
  }

  // A robot that falls goes into a posture for it, be it from a safe tail. As soon as it lies, or does not
  // fall after all, its references go back to the home angles, where a stand or a motion goes on; so they do
  // after a safe tail. Whether a way begins.
  bool respond_to_fall(const Tick& tick, PlanDecision decision) {
    if (!estimate_.has_value()) return false;
    const Estimate& estimate = estimate_.read();
    const bool falls = takes_fall_posture_ && estimate.fall == estimate::fall::falls;
    const bool anew = decision == PlanDecision::begin_anew;
    if (decision == PlanDecision::wait && (!falls || !plays_tail())) return false;
    // A posture that waits for its turn was not accepted, or has been cut off: it begins again.
    const bool goes_on = decision == PlanDecision::resume && falls == fall_.falls();
    if (anew ? !fall_.plays() : goes_on) return false;
    const FallPosture::References references = references_before(tick, decision);
    if (anew || !falls) {
      fall_.go_home(references);
      return fall_.plays();
    }
    fall_.fall(estimate.fall_direction, references);
    if (!fall_.falls()) return false;
    player_.break_off();
    pattern_.reset_to_stand(pattern_.final_stance());
    stand_.middle = pattern_.final_stance();
    return true;
  }

  bool plays_tail() { return network_.has_value() && network_.read().mode == network_state::mode::safe_tail; }

  // A robot that holds is where its joints say; so is one of whose batch nothing is known any more.
  FallPosture::References references_before(const Tick& tick, PlanDecision decision) {
    if (decision != PlanDecision::begin_anew) {
      if (const auto played = accepted_.before(tick.batch_sequence)) return *played;
    }
    if (!joints_.has_value()) return {};
    const JointStates& joints = joints_.read();
    const std::span held(joints.reference_position, std::min<std::size_t>(joints.joint_count, kMaxJoints));
    return {held, held};
  }

  // Who commands a walk for a while only must go on commanding it: if it cannot any more, the robot stands. A
  // command from before a fall, or during it, is void: a robot that has got up does not walk off by itself.
  [[nodiscard]] WalkCommand commanded(std::int64_t now_ns) {
    const WalkCommand command = walk_.has_value() ? walk_.read() : WalkCommand{};
    if (estimate_.has_value() && estimate_.read().fall != 0) void_until_ns_ = now_ns;
    if (command.stamp_ns <= void_until_ns_) return WalkCommand{};
    return command.valid_until_ns == 0 || now_ns < command.valid_until_ns ? command : WalkCommand{};
  }

  // A command is limited, never in silence.
  void report_limits(const WalkCommand& walk) noexcept {
    const StepLimit news = limits_.news(walk, pattern_.applied_limits());
    for (const StepLimit rule : kStepLimits) {
      if (has(news, rule)) {
        report_(rule == StepLimit::acceleration ? Severity::info : Severity::warning, limits_.text(rule));
      }
    }
  }

  // Without a network (a plug-in check, a log replay) every batch counts as accepted.
  NetworkState network_at(const Tick& tick) {
    if (network_.has_value()) return network_.read();
    NetworkState assumed{};
    assumed.mode = network_state::mode::holding;
    assumed.accepted_sequence = tick.batch_sequence - 1;
    return assumed;
  }

  GaitParameters parameters_;  // what is set live is taken over at the next batch
  WalkingPattern pattern_;
  DivergenceFeedback divergence_;
  MotionPlayer player_;
  MotionAdmission admission_;
  FallPosture fall_;
  HeadPlanner head_;
  bool takes_fall_posture_;
  Stand stand_;
  LimitReport limits_;
  Reporter report_;
  PlanContinuity continuity_;
  Input<WalkCommand> walk_;
  Input<MotionRequest> request_;
  Input<HeadCommand> look_;
  Input<Estimate> estimate_;
  Input<JointStates> joints_;
  Input<FootstepPlan> footsteps_;
  Input<NetworkState> network_;
  Input<Correction> correction_;
  Input<JointPlan> joint_plan_;
  AcceptedReferences accepted_;
  std::int64_t void_until_ns_ = -1;  // walk commands up to this stamp were given before a fall
  Output<MotionPlan> plan_;
  Output<PosturePlan> posture_;
  Output<gaitway::MotionState> state_;
  Output<FootstepState> footstep_state_;
};

}  // namespace
}  // namespace gaitway::trajectory

GAITWAY_PLUGIN(
    gaitway::trajectory::Trajectory, "trajectory", "1.0.0",
    "Plans footsteps, feet and CoM of the walk, plays key-frame motions, and gives each batch its safe tail")
