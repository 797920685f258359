// Between the topics and the mission: what a tick sees, and where its orders go.
#include "gaitway/behaviour_leaves/behaviour_plugin.hpp"

#include <utility>

namespace gaitway::behaviour_leaves {
namespace {

behaviour::Registry registry_of(const std::shared_ptr<Robot>& robot,
                                const BehaviourPlugin::MoreLeaves& more) {
  behaviour::Registry registry;
  register_leaves(registry, robot);
  if (more) more(registry, robot);
  return registry;
}

MissionDesk::Where desk_of(Setup& setup) {
  return setup.parameter("loads_in_step", false,
                         "read missions in the step, where wall time does not count: the same in each run")
             ? MissionDesk::Where::in_step
             : MissionDesk::Where::beside;
}

// Of a topic that tells news alone, or whose parts have times of their own.
template <class T>
const T* newest(Input<T>& input) {
  return input.has_value() ? &input.read() : nullptr;
}

// Of a topic that is told all the time: what a silent writer said last holds no more.
template <class T>
const T* fresh(Input<T>& input, std::int64_t now_ns) {
  constexpr std::int64_t kSilent_ns = 1'000'000'000;
  return input.has_value() && input.age_ns(now_ns) <= kSilent_ns ? &input.read() : nullptr;
}

}  // namespace

BehaviourPlugin::BehaviourPlugin(Setup& setup, const MoreLeaves& more, const std::string& first_mission)
    : robot_(std::make_shared<Robot>()),
      registry_(registry_of(robot_, more)),
      enabled_(setup.live_parameter("enabled", true, "false: it ends its mission and orders nothing")),
      events_(setup.reporter()),
      runner_(registry_, *robot_, desk_of(setup), events_),
      estimate_(setup.reads_optional<Estimate>("estimate")),
      footsteps_(setup.reads_previous_optional<FootstepState>("footstep_state")),
      navigation_(setup.reads_previous_optional<NavigationState>("navigation_state")),
      motion_state_(setup.reads_previous_optional<MotionState>("motion_state")),
      command_(setup.reads_optional<CommandState>("command_state")),
      targets_(setup.reads_previous_optional<SeenTargets>("seen_targets")),
      vision_(setup.reads_previous_optional<VisionState>("vision_state")),
      network_(setup.reads_optional<NetworkState>("network_state")),
      request_(setup.reads_optional<BehaviourRequest>("behaviour_request")),
      walk_(setup.writes<WalkCommand>("behaviour_walk")),
      way_(setup.writes<WalkToRequest>("behaviour_walk_to")),
      motion_(setup.writes<MotionRequest>("behaviour_motion")),
      head_(setup.writes<HeadCommand>("behaviour_head")),
      state_(setup.writes<BehaviourState>("behaviour_state")),
      nodes_(setup.writes<BehaviourNodes>("behaviour_nodes")) {
  const std::string mission =
      setup.parameter("mission", first_mission,
                      "the behaviour tree that begins at the start: name of a shipped mission, or a file");
  if (mission.empty()) return;
  try {
    runner_.load(mission);
  } catch (const std::exception& error) {
    throw SetupError(error.what());
  }
}

void BehaviourPlugin::step(const Tick& tick) {
  look(tick);
  if (request_.has_value()) runner_.ask(request_.read(), tick.now_ns);
  const bool is_due = tick.tick % facts::kSlotsPerCycle == kSlot;
  if (!runner_.step(is_due, enabled_)) return;
  pass_on();
  runner_.tell(state_.value());
  state_.publish();
  if (!is_due) return;
  runner_.tell(nodes_.value());
  nodes_.publish();
}

void BehaviourPlugin::look(const Tick& tick) {
  robot_->situation = {.now_ns = tick.now_ns,
                       .estimate = fresh(estimate_, tick.now_ns),
                       .footsteps = fresh(footsteps_, tick.now_ns),
                       .navigation = fresh(navigation_, tick.now_ns),
                       .motion = fresh(motion_state_, tick.now_ns),
                       .command = newest(command_),
                       .targets = newest(targets_),
                       .vision = fresh(vision_, tick.now_ns),
                       .network = fresh(network_, tick.now_ns)};
}

void BehaviourPlugin::pass_on() {
  Orders& orders = robot_->orders;
  const Situation& now = robot_->situation;
  if (orders.motion() && now.commands_motions()) {
    motion_.value() = *orders.motion();
    motion_.publish();
  }
  if (!now.commands()) {  // whoever does has ended what was ordered before
    walked_ = way_is_walked_ = ends_old_way_ = false;
    return;
  }
  if (std::exchange(ends_old_way_, false) && !orders.way()) orders.cancel_way();
  if (orders.walking() || walked_) {
    const Velocity velocity = orders.walking().value_or(Velocity{});
    walked_ = orders.walking().has_value();
    WalkCommand& walk = walk_.value();
    walk.stamp_ns = now.now_ns;
    walk.walk = walked_ ? 1 : 0;
    walk.velocity[0] = velocity.forward_m_per_s;
    walk.velocity[1] = velocity.left_m_per_s;
    walk.turn_rate = velocity.turn_rad_per_s;
    walk.valid_until_ns = walked_ ? now.now_ns + kWalkValid_ns : 0;
    walk_.publish();
  }
  if (orders.way()) {
    way_is_walked_ = orders.way()->cancel == 0;
    way_.value() = *orders.way();
    way_.publish();
  }
  if (orders.head()) {
    head_.value() = *orders.head();
    head_.publish();
  }
}

void BehaviourPlugin::save_state(StateWriter& state) const {
  state(runner_.state(), walked_, way_is_walked_);
}

// The tree begins anew: what the one before walks is ended first, a motion goes on to its end.
void BehaviourPlugin::restore_state(StateReader& state) {
  RunnerState runner;
  state(runner, walked_, ends_old_way_);
  runner_.go_on_from(runner);
}

}  // namespace gaitway::behaviour_leaves
