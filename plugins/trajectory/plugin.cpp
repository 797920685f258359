// The plug-in `trajectory`: connects the walking pattern to its topics.
#include "gaitway/core/plugin.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/limit_report.hpp"
#include "gaitway/trajectory/plan_continuity.hpp"
#include "gaitway/trajectory/reach_check.hpp"
#include "gaitway/trajectory/standing_posture.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"

namespace gaitway::trajectory {
namespace {

// The configuration's numbers; what it leaves out comes from the robot and from GaitParameters. Throws
// std::invalid_argument if they break a rule or a leg cannot reach the footsteps.
GaitParameters configured(Setup& setup) {
  const urdf::RobotModel robot = urdf::load_robot(setup.robot_directory());
  GaitParameters p = with_standing_posture({}, robot);
  const auto set = [&setup](double& value, const char* name, const char* unit) {
    value = setup.parameter(name, value, unit);
  };
  set(p.com_height_m, "com_height", "m");
  set(p.hip_height_m, "hip_height", "m");
  set(p.stand_com_forward_m, "stand_com_forward", "m");
  set(p.foot_spacing_m, "foot_spacing", "m");
  set(p.step_time_s, "step_time", "s");
  set(p.double_support_share, "double_support_share", "1");
  set(p.lead_in_s, "lead_in", "s");
  set(p.settle_s, "settle", "s");
  set(p.freeze_share, "freeze_share", "1");
  set(p.absorb_s, "absorb", "s");
  set(p.lift_m, "lift", "m");
  set(p.zmp_forward_m, "zmp_forward", "m");
  set(p.zmp_inward_m, "zmp_inward", "m");
  set(p.max_step_forward_m, "max_step_forward", "m");
  set(p.max_step_backward_m, "max_step_backward", "m");
  set(p.max_foot_spacing_m, "max_foot_spacing", "m");
  set(p.min_sole_gap_m, "min_sole_gap", "m");
  set(p.max_step_turn_rad, "max_step_turn", "rad");
  set(p.forward_acceleration_m_per_s2, "forward_acceleration", "m/s^2");
  set(p.lateral_acceleration_m_per_s2, "lateral_acceleration", "m/s^2");
  set(p.turn_acceleration_rad_per_s2, "turn_acceleration", "rad/s^2");
  set(p.preview_s, "preview", "s");
  set(p.zmp_error_weight, "zmp_error_weight", "1");
  set(p.jerk_weight, "jerk_weight", "1");
  p.validate();
  require_reachable(p, robot);
  return p;
}

class Trajectory final : public Plugin {
 public:
  explicit Trajectory(Setup& setup) : Trajectory(setup, configured(setup)) {}

  void step(const Tick& tick) override {
    MotionPlan& plan = plan_.value();
    const PlanDecision decision = decide(tick);
    if (decision == PlanDecision::wait) {
      plan.sequence = 0;
      plan.tail_count = 0;
      plan.footstep_count = 0;
      plan_.publish();
      return;
    }
    if (decision == PlanDecision::begin_anew) pattern_.reset_to_stand(continuity_.restart_stance());
    const WalkCommand walk = commanded(tick.now_ns);
    const Correction correction = correction_.has_value() ? correction_.read() : Correction{};
    pattern_.plan(tick.batch_sequence, tick.batch_start_ns, walk, correction, plan);
    report_limits(walk);
    continuity_.published(tick.batch_sequence, pattern_.final_stance());
    plan_.publish();
  }

  [[nodiscard]] std::uint32_t state_version() const override { return 1; }
  void save_state(StateWriter& state) const override { state(pattern_, continuity_); }
  void restore_state(StateReader& state) override { state(pattern_, continuity_); }

 private:
  Trajectory(Setup& setup, const GaitParameters& parameters)
      : pattern_(parameters),
        limits_(parameters),
        report_(setup.reporter()),
        walk_(setup.reads_optional<WalkCommand>("walk_command")),
        network_(setup.reads_optional<NetworkState>("network_state")),
        correction_(setup.reads_previous<Correction>("correction")),
        plan_(setup.writes<MotionPlan>("motion_plan")) {
    setup.period(Period::batch);
  }

  // Who commands a walk for a while only must go on commanding it: if it cannot any more, the robot stands.
  [[nodiscard]] WalkCommand commanded(std::int64_t now_ns) {
    const WalkCommand command = walk_.has_value() ? walk_.read() : WalkCommand{};
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
  PlanDecision decide(const Tick& tick) {
    if (!network_.has_value()) {
      const std::uint32_t before = tick.batch_sequence - 1;
      return continuity_.decide(tick.batch_sequence, NetworkMode::holding, before);
    }
    const NetworkState& network = network_.read();
    return continuity_.decide(tick.batch_sequence, static_cast<NetworkMode>(network.mode),
                              network.accepted_sequence);
  }

  WalkingPattern pattern_;
  LimitReport limits_;
  Reporter report_;
  PlanContinuity continuity_;
  Input<WalkCommand> walk_;
  Input<NetworkState> network_;
  Input<Correction> correction_;
  Output<MotionPlan> plan_;
};

}  // namespace
}  // namespace gaitway::trajectory

GAITWAY_PLUGIN(gaitway::trajectory::Trajectory, "trajectory", "1.0.0",
               "Plans footsteps, feet and CoM of the walk, and the safe tail of each batch")
