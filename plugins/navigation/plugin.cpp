// The plug-in `navigation`: connects the navigator to its topics. It plans in its step, so it belongs into a
// process of its own that no tick waits for.
#include "gaitway/plugin/plugin.hpp"

#include <cmath>
#include <string>

#include "gaitway/facts/facts.hpp"
#include "gaitway/navigation/navigator.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/world/world_choice.hpp"

namespace gaitway::navigation {
namespace {

world::World world_of(Setup& setup) {
  const std::string name =
      setup.parameter("world", "empty",
                      "the map: a world's file, or the name of a shipped one, as `gaitway world list` tells");
  const std::int64_t seed = setup.parameter("world_seed", std::int64_t{-1}, "1",
                                            {-1.0, 2147483647.0, "of its random courses; -1: their own"});
  return world::load_world(
      {.name = name,
       .random_seed =
           seed >= 0 ? std::optional<std::uint64_t>(static_cast<std::uint64_t>(seed)) : std::nullopt,
       .written_in = "the parameter 'world' of the plug-in 'navigation'",
       .line = 0});
}

PlanningDesk::Where desk_of(Setup& setup) {
  return setup.parameter("plans_in_step", false,
                         "plan in the step, where wall time does not count: the same in each run")
             ? PlanningDesk::Where::in_step
             : PlanningDesk::Where::beside;
}

StepShares shares_of(Setup& setup) {
  StepShares shares;
  shares.forward = setup.parameter("forward_share", shares.forward, "1",
                                   {0.2, 1.0, "of the gait's own limit, what planned steps take"});
  shares.side = setup.parameter("side_share", shares.side, "1",
                                {0.2, 1.0, "of the gait's own limit, what planned steps take"});
  shares.turn = setup.parameter("turn_share", shares.turn, "1",
                                {0.2, 1.0, "of the gait's own limit, what planned steps take"});
  return shares;
}

PoseFilterParameters filter_of(Setup& setup) {
  PoseFilterParameters filter;
  filter.way_drift_m = setup.parameter("way_drift", filter.way_drift_m, "m");
  filter.way_drift_rad = setup.parameter("way_turn_drift", filter.way_drift_rad, "rad");
  filter.turn_drift_rad = setup.parameter("turn_drift", filter.turn_drift_rad, "rad");
  filter.start_deviation_m = setup.parameter("start_deviation", filter.start_deviation_m, "m");
  filter.start_deviation_rad = setup.parameter("start_turn_deviation", filter.start_deviation_rad, "rad");
  return filter;
}

NavigatorParameters navigator_of(Setup& setup) {
  NavigatorParameters navigator;
  navigator.goal_tolerance_m = setup.parameter("goal_tolerance", navigator.goal_tolerance_m, "m");
  navigator.goal_tolerance_rad = setup.parameter("goal_turn_tolerance", navigator.goal_tolerance_rad, "rad");
  navigator.pushed_m = setup.parameter("pushed", navigator.pushed_m, "m");
  navigator.pushed_rad = setup.parameter("pushed_turn", navigator.pushed_rad, "rad");
  return navigator;
}

class Navigation final : public Plugin {
 public:
  explicit Navigation(Setup& setup) : Navigation(setup, world_of(setup)) {}

  void step(const Tick& tick) override {
    if (!estimate_.has_value() || !walk_.has_value() || !knows_odometry()) return;
    if (request_.has_value()) navigator_.ask(request_.read(), tick.now_ns);
    if (measurement_.has_value() && measurement_.read().stamp_ns != measured_ns_) {
      measured_ns_ = measurement_.read().stamp_ns;
      navigator_.measure(measurement_.read());
    }
    if (obstacles_.has_value()) navigator_.see(obstacles_.read());
    const WalkCommand command = command_.has_value() ? command_.read() : WalkCommand{};
    const NetworkState network = network_.has_value() ? network_.read() : NetworkState{};
    navigator_.step({.now_ns = tick.now_ns,
                     .estimate = estimate_.read(),
                     .walk = walk_.read(),
                     .commanded = command.walk != 0 &&
                                  (command.valid_until_ns == 0 || tick.now_ns < command.valid_until_ns),
                     .network_mode = network.mode,
                     .stops = network.stops},
                    plan_.value(), state_.value(), way_.value());
    plan_.publish();
    state_.publish();
    way_.publish();
    tell_end();
  }

  [[nodiscard]] std::uint32_t state_version() const override { return 1; }
  void save_state(StateWriter& state) const override { state(navigator_, measured_ns_, told_result_); }
  void restore_state(StateReader& state) override { state(navigator_, measured_ns_, told_result_); }

 private:
  Navigation(Setup& setup, world::World world)
      : start_{world.start.position_m.x(), world.start.position_m.y(), world.start.yaw_rad},
        planner_(urdf::load_robot(setup.robot_directory()), std::move(world), shares_of(setup)),
        desk_(desk_of(setup)),
        navigator_(planner_, desk_, PoseFilter(start_, filter_of(setup)), navigator_of(setup)),
        report_(setup.reporter()),
        estimate_(setup.reads<Estimate>("estimate")),
        walk_(setup.reads_previous<FootstepState>("footstep_state")),
        request_(setup.reads_optional<WalkToRequest>("walk_to_command")),
        command_(setup.reads_optional<WalkCommand>("walk_command")),
        measurement_(setup.reads_optional<PoseMeasurement>("pose_measurement")),
        // Of the tick before: the eyes have a process of their own, and no batch is held back by its crash.
        obstacles_(setup.reads_previous_optional<Obstacles>("obstacles")),
        network_(setup.reads_optional<NetworkState>("network_state")),
        plan_(setup.writes<FootstepPlan>("footstep_plan")),
        state_(setup.writes<NavigationState>("navigation_state")),
        way_(setup.writes<NavigationWay>("navigation_way")) {}

  [[nodiscard]] bool knows_odometry() {
    const Estimate& estimate = estimate_.read();
    const auto is_finite = [](const double(&pose)[3]) { return std::isfinite(pose[0] + pose[1] + pose[2]); };
    return is_finite(estimate.odometry_base) && is_finite(estimate.odometry_foot[0]) &&
           is_finite(estimate.odometry_foot[1]) && is_finite(walk_.read().landing);
  }

  // Once a way.
  void tell_end() {
    const NavigationState& state = state_.value();
    if (state.result == told_result_) return;
    told_result_ = state.result;
    namespace results = navigation_state::result;
    if (state.result == results::refused || state.result == results::failed) {
      report_(Severity::warning, reinterpret_cast<const char*>(state.text));
    }
  }

  planning::Pose start_;
  WayPlanner planner_;
  PlanningDesk desk_;
  Navigator navigator_;
  Reporter report_;
  std::int64_t measured_ns_ = -1;
  std::uint32_t told_result_ = 0;
  Input<Estimate> estimate_;
  Input<FootstepState> walk_;
  Input<WalkToRequest> request_;
  Input<WalkCommand> command_;
  Input<PoseMeasurement> measurement_;
  Input<Obstacles> obstacles_;
  Input<NetworkState> network_;
  Output<FootstepPlan> plan_;
  Output<NavigationState> state_;
  Output<NavigationWay> way_;
};

}  // namespace
}  // namespace gaitway::navigation

GAITWAY_PLUGIN(gaitway::navigation::Navigation, "navigation", "1.0.0",
               "Walks to places: plans footsteps through a map, has the walk follow them, plans anew")
