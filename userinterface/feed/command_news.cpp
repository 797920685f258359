// Told as it changes: what counts as a change.
#include "command_news.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "gaitway/api/command_messages.hpp"
#include "gaitway/api/state_messages.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

// As the schema has them; the last one is what is unknown here.
constexpr std::array<std::string_view, 5> kCommanders{"nobody", "behaviour", "person", "emergency_stop",
                                                      "unknown"};
constexpr std::array<std::string_view, 12> kCommandReasons{"start",
                                                           "behaviour_orders",
                                                           "behaviour_is_done",
                                                           "person_orders",
                                                           "person_takes",
                                                           "person_stops",
                                                           "person_lets_go",
                                                           "person_is_lost",
                                                           "person_moves_joint",
                                                           "emergency_stop",
                                                           "emergency_stop_released",
                                                           "unknown"};
constexpr std::array<std::string_view, 4> kOrderSources{"nobody", "behaviour", "person", "unknown"};
constexpr std::array<std::string_view, 7> kBehaviourStates{"none",   "runs",  "halts",  "succeeded",
                                                           "failed", "waits", "unknown"};
static_assert(kCommandReasons.size() == command_state::reason::emergency_stop_released + 2);
static_assert(kBehaviourStates.size() == behaviour_state::state::waits + 2);

template <std::size_t size>
std::string word_of(const std::array<std::string_view, size>& words, std::uint32_t value) {
  return std::string(words[std::min<std::size_t>(value, size - 1)]);
}

ros::CommandState command_state_of(const gaitway::CommandState& command) {
  ros::CommandState message;
  message.header.stamp = ros_time(command.stamp_ns);
  message.commander = word_of(kCommanders, command.commander);
  message.reason = word_of(kCommandReasons, command.reason);
  message.text = text_of(command.text);
  message.since = ros_time(command.since_ns);
  message.walk = word_of(kOrderSources, command.in_force[0]);
  message.way = word_of(kOrderSources, command.in_force[1]);
  message.motion = word_of(kOrderSources, command.in_force[2]);
  message.head = word_of(kOrderSources, command.in_force[3]);
  message.may_get_up = command.may_get_up != 0;
  message.changes = command.changes;
  message.turned_away = command.turned_away;
  return message;
}

void add_transitions(ros::BehaviourState& message, const gaitway::BehaviourState& behaviour) {
  constexpr double kSecond = 1e-9;
  const auto count = std::min<std::uint64_t>(behaviour.transitions, kTreeTransitions);
  for (std::uint64_t i = behaviour.transitions - count; i < behaviour.transitions; ++i) {
    const auto place = static_cast<std::size_t>(i % kTreeTransitions);
    message.transition_time.push_back(static_cast<double>(behaviour.transition_ns[place]) * kSecond);
    message.transition_node.push_back(behaviour.transition_node[place]);
    message.transition_to.push_back(static_cast<std::int8_t>(behaviour.transition_to[place]));
  }
}

ros::BehaviourState behaviour_state_of(const gaitway::BehaviourState& behaviour) {
  ros::BehaviourState message;
  message.header.stamp = ros_time(behaviour.stamp_ns);
  message.mission = text_of(behaviour.mission);
  message.state = word_of(kBehaviourStates, behaviour.state);
  message.text = text_of(behaviour.text);
  message.revision = behaviour.revision;
  message.node_count = behaviour.node_count;
  message.ticks = behaviour.ticks;
  message.transitions = behaviour.transitions;
  const std::size_t told = std::min<std::size_t>(behaviour.node_count, kMaxTreeNodes);
  message.status.assign(behaviour.status, behaviour.status + told);
  add_transitions(message, behaviour);
  return message;
}

bool differs(const gaitway::CommandState& command, const gaitway::CommandState& told) {
  return command.changes != told.changes || command.since_ns != told.since_ns ||
         command.may_get_up != told.may_get_up || !std::ranges::equal(command.in_force, told.in_force);
}

// Else than that time passes.
bool differs(const gaitway::BehaviourState& behaviour, const gaitway::BehaviourState& told) {
  return behaviour.state != told.state || behaviour.revision != told.revision ||
         behaviour.transitions != told.transitions || behaviour.answered != told.answered ||
         !std::ranges::equal(behaviour.text, told.text) ||
         !std::ranges::equal(behaviour.mission, told.mission);
}

}  // namespace

CommandNews::CommandNews(msgclient::Client& client)
    : command_(client, "command_state"),
      behaviour_(client, "behaviour_state"),
      nodes_(client, "behaviour_nodes") {}

void CommandNews::forget() noexcept {
  any_command_told_ = any_behaviour_told_ = false;
  tree_.forget();
}

void CommandNews::publish(PublicationSink& sink, std::int64_t robot_ns) {
  publish_command(sink, robot_ns);
  publish_behaviour(sink, robot_ns);
  publish_nodes(sink, robot_ns);
}

void CommandNews::publish_command(PublicationSink& sink, std::int64_t robot_ns) {
  if (!command_.update()) return;
  const gaitway::CommandState& command = command_.value();
  // A behaviour that goes on with its orders while it does not command counts up all the time.
  const bool more = command.turned_away != command_told_.turned_away &&
                    command.stamp_ns - command_told_.stamp_ns >= facts::kSecond_ns;
  if (any_command_told_ && !more && !differs(command, command_told_)) return;
  command_told_ = command;
  any_command_told_ = true;
  if (sink.wants(Topic::command_state)) {
    sink.publish(Topic::command_state, command_state_of(command), robot_ns);
  }
}

void CommandNews::publish_behaviour(PublicationSink& sink, std::int64_t robot_ns) {
  if (!behaviour_.update()) return;
  const gaitway::BehaviourState& behaviour = behaviour_.value();
  const bool a_second = behaviour.stamp_ns - behaviour_told_.stamp_ns >= facts::kSecond_ns;
  if (any_behaviour_told_ && !a_second && !differs(behaviour, behaviour_told_)) return;
  behaviour_told_ = behaviour;
  any_behaviour_told_ = true;
  if (sink.wants(Topic::behaviour_state)) {
    sink.publish(Topic::behaviour_state, behaviour_state_of(behaviour), robot_ns);
  }
}

void CommandNews::publish_nodes(PublicationSink& sink, std::int64_t robot_ns) {
  if (!nodes_.update() || !tree_.take(nodes_.value()) || !sink.wants(Topic::behaviour_nodes)) return;
  sink.publish(Topic::behaviour_nodes, tree_.message(), robot_ns);
}

}  // namespace gaitway::api
