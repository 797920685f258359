// The plug-in plugin_name: a gait of its own, slow and with high steps, made with the shipped walking
// pattern.
#include "gaitway/plugin/plugin.hpp"
#include "gaitway/trajectory/plan_continuity.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"

namespace trajectory = gaitway::trajectory;

class PluginName final : public gaitway::Plugin {
 public:
  explicit PluginName(gaitway::Setup& setup)
      : pattern_(gait(setup)),
        walk_(setup.reads_optional<gaitway::WalkCommand>("walk_command")),
        network_(setup.reads<gaitway::NetworkState>("network_state")),
        correction_(setup.reads_previous<gaitway::Correction>("correction")),
        plan_(setup.writes<gaitway::MotionPlan>("motion_plan")) {
    setup.period(gaitway::Period::batch);
  }

  // Every 80 ms: the next eight points, and the safe tail that brings the robot to a stand.
  void step(const gaitway::Tick& tick) override {
    const auto decision = continuity_.decide(tick.batch_sequence, network_.read());
    if (decision == trajectory::PlanDecision::wait) {
      plan_.value() = {};
      return plan_.publish();
    }
    if (decision == trajectory::PlanDecision::begin_anew) {
      pattern_.reset_to_stand(continuity_.restart_stance());
    }
    pattern_.plan(tick.batch_sequence, tick.batch_start_ns, walk_.read(), correction_.read(), plan_.value());
    continuity_.published(tick.batch_sequence, pattern_.final_stance());
    plan_.publish();
  }

 private:
  static trajectory::GaitParameters gait(gaitway::Setup& setup) {
    const auto robot = gaitway::urdf::load_robot(setup.robot_directory());
    auto gait = trajectory::gait_of(robot);
    gait.lift_m = setup.parameter("lift", 0.045, "m");
    gait.step_time_s = setup.parameter("step_time", 0.48, "s");
    gait.validate();
    trajectory::require_reachable(gait, robot);
    return gait;
  }

  trajectory::WalkingPattern pattern_;
  trajectory::PlanContinuity continuity_;
  gaitway::Input<gaitway::WalkCommand> walk_;
  gaitway::Input<gaitway::NetworkState> network_;
  gaitway::Input<gaitway::Correction> correction_;
  gaitway::Output<gaitway::MotionPlan> plan_;
};

GAITWAY_PLUGIN(PluginName, "plugin_name", "0.1.0", "Walks slowly, with high steps")
