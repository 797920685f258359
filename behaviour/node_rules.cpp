// The semantics of BehaviorTree.CPP 4, and where they differ: README.md.
#include "node_rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "builtin_nodes.hpp"

namespace gaitway::behaviour {
namespace {

constexpr Step visit(NodeIndex child) noexcept {
  return {child, NodeStatus::idle};
}
constexpr Step say(NodeStatus result) noexcept {
  return {kNoNode, result};
}
constexpr Step kRunning = say(NodeStatus::running);
constexpr Step kSuccess = say(NodeStatus::success);
constexpr Step kFailure = say(NodeStatus::failure);
constexpr Step kSkipped = say(NodeStatus::skipped);

// The value of a port of a built-in node; nothing: its entry has not been set.
template <class T>
std::optional<T> port_value(NodeArray& nodes, NodeIndex node, std::size_t port) noexcept {
  return nodes.call(node).get<T>(port);
}

NodeIndex first_child(NodeIndex node) noexcept {
  return node + 1;
}

// ---- Sequence, SequenceWithMemory, Fallback: children in turn, each until it has ended

bool is_sequence(NodeType type) noexcept {
  return type == NodeType::sequence || type == NodeType::sequence_with_memory ||
         type == NodeType::reactive_sequence;
}

Step enter_in_turn(NodeArray& nodes, NodeIndex node, bool begins) noexcept {
  Node& self = nodes.at(node);
  if (begins) {
    self.skipped = 0;
    if (self.type != NodeType::sequence_with_memory || self.current == kNoNode)
      self.current = first_child(node);
  }
  return visit(self.current);
}

Step after_in_turn(NodeArray& nodes, NodeIndex node, NodeIndex child, NodeStatus answer) noexcept {
  Node& self = nodes.at(node);
  const NodeStatus passing = is_sequence(self.type) ? NodeStatus::success : NodeStatus::failure;
  if (answer == NodeStatus::running) return kRunning;
  if (answer != passing && answer != NodeStatus::skipped) return say(answer);
  self.skipped += answer == NodeStatus::skipped ? 1 : 0;
  self.current = nodes.at(child).next_sibling;
  if (self.current == kNoNode) return self.skipped == self.children ? kSkipped : say(passing);
  // A child that has ended at once: the next one's turn is the next tick.
  const bool yields = self.type == NodeType::sequence_with_memory && answer == passing;
  return yields && nodes.started_in_this_pass(child) ? kRunning : visit(self.current);
}

// ---- ReactiveSequence, ReactiveFallback: from the first child on at every tick

Step enter_reactive(NodeArray& nodes, NodeIndex node) noexcept {
  nodes.at(node).skipped = 0;
  return visit(first_child(node));
}

Step after_reactive(NodeArray& nodes, NodeIndex node, NodeIndex child, NodeStatus answer) noexcept {
  Node& self = nodes.at(node);
  const NodeStatus passing = is_sequence(self.type) ? NodeStatus::success : NodeStatus::failure;
  if (answer == NodeStatus::running) {
    for (NodeIndex other = first_child(node); other != kNoNode; other = nodes.at(other).next_sibling) {
      if (other == child) continue;
      nodes.halt(other);
      if (other > child) nodes.forget(other);
    }
    return kRunning;
  }
  if (answer != passing && answer != NodeStatus::skipped) return say(answer);
  self.skipped += answer == NodeStatus::skipped ? 1 : 0;
  const NodeIndex next = nodes.at(child).next_sibling;
  if (next != kNoNode) return visit(next);
  return self.skipped == self.children ? kSkipped : say(passing);
}

// ---- Parallel, ParallelAll: every child that has not ended, at every tick

// How many children a threshold means: a negative one counts from all of them down.
std::optional<std::int32_t> threshold(NodeArray& nodes, NodeIndex node, std::size_t port) noexcept {
  const auto written = port_value<std::int64_t>(nodes, node, port);
  if (!written) return std::nullopt;
  const std::int64_t children = nodes.at(node).children;
  return static_cast<std::int32_t>(*written < 0 ? std::max<std::int64_t>(children + *written + 1, 0)
                                                : std::min(*written, children));
}

Step next_in_parallel(NodeArray& nodes, NodeIndex node, NodeIndex child) noexcept {
  while (child != kNoNode && nodes.at(child).counted) child = nodes.at(child).next_sibling;
  if (child != kNoNode) return visit(child);
  Node& self = nodes.at(node);
  if (self.skipped == self.children) return kSkipped;
  if (self.type == NodeType::parallel || self.skipped + self.count < self.children) return kRunning;
  const auto failures = threshold(nodes, node, port::kMaxFailures);
  return !failures || self.failures >= *failures ? kFailure : kSuccess;
}

Step enter_parallel(NodeArray& nodes, NodeIndex node, bool begins) noexcept {
  Node& self = nodes.at(node);
  self.skipped = 0;
  if (begins) {
    self.count = 0;
    self.failures = 0;
    for (NodeIndex i = first_child(node); i != kNoNode; i = nodes.at(i).next_sibling)
      nodes.at(i).counted = false;
  }
  return next_in_parallel(nodes, node, first_child(node));
}

Step after_parallel(NodeArray& nodes, NodeIndex node, NodeIndex child, NodeStatus answer) noexcept {
  Node& self = nodes.at(node);
  if (answer == NodeStatus::skipped) ++self.skipped;
  if (answer == NodeStatus::success || answer == NodeStatus::failure) {
    nodes.at(child).counted = true;
    ++self.count;
    self.failures += answer == NodeStatus::failure ? 1 : 0;
  }
  if (self.type == NodeType::parallel) {
    const auto wanted = threshold(nodes, node, port::kSuccessCount);
    const auto failing = threshold(nodes, node, port::kFailureCount);
    if (!wanted || !failing) return kFailure;
    const std::int32_t successes = self.count - self.failures;
    const bool from_all = port_value<std::int64_t>(nodes, node, port::kSuccessCount) < 0;
    if (successes >= *wanted || (from_all && successes + self.skipped >= *wanted)) {
      return kSuccess;
    }
    if (self.children - self.failures < *wanted || self.failures >= *failing) return kFailure;
  }
  return next_in_parallel(nodes, node, nodes.at(child).next_sibling);
}

// ---- IfThenElse, WhileDoElse, Switch: one of several branches

NodeIndex sibling(const NodeArray& nodes, NodeIndex child) noexcept {
  return nodes.at(child).next_sibling;
}

// The branch that is not chosen comes to its end before the chosen one begins.
Step choose(NodeArray& nodes, NodeIndex chosen, NodeIndex other) noexcept {
  if (other != kNoNode) {
    nodes.halt(other);
    if (nodes.at(other).halting_below > 0) return kRunning;
  }
  return visit(chosen);
}

Step after_branching(NodeArray& nodes, NodeIndex node, NodeIndex child, NodeStatus answer) noexcept {
  Node& self = nodes.at(node);
  if (answer == NodeStatus::running || child != first_child(node)) return say(answer);
  if (answer == NodeStatus::skipped) return kSkipped;
  const NodeIndex then = sibling(nodes, child);
  const NodeIndex otherwise = sibling(nodes, then);
  const NodeIndex chosen = answer == NodeStatus::success ? then : otherwise;
  if (chosen == kNoNode) return kFailure;
  self.current = chosen;
  if (self.type == NodeType::if_then_else) return visit(chosen);
  return choose(nodes, chosen, chosen == then ? otherwise : then);
}

bool equal(const Value& a, const Value& b) noexcept {
  const double* const x = std::get_if<double>(&a);
  const double* const y = std::get_if<double>(&b);
  if (x == nullptr || y == nullptr) return a.index() != 0 && a == b;
  return std::abs(*x - *y) <= double{std::numeric_limits<float>::epsilon()};
}

Step enter_switch(NodeArray& nodes, NodeIndex node, bool begins) noexcept {
  Node& self = nodes.at(node);
  const Call call = nodes.call(node);
  NodeIndex chosen = first_child(node);
  for (std::size_t i = port::kFirstCase; sibling(nodes, chosen) != kNoNode; ++i) {
    if (equal(call.value(port::kVariable), call.value(i))) break;
    chosen = sibling(nodes, chosen);
  }
  const NodeIndex before = begins || self.current == chosen ? kNoNode : self.current;
  const Step step = choose(nodes, chosen, before);
  if (step.child != kNoNode) self.current = chosen;
  return step;
}

// ---- Decorators

Step enter_counted(NodeArray& nodes, NodeIndex node, bool begins) noexcept {
  Node& self = nodes.at(node);
  if (begins) self.count = 0;
  const auto rounds = port_value<std::int64_t>(nodes, node, port::kCount);
  if (!rounds) return kFailure;
  if (*rounds >= 0 && self.count >= *rounds) return self.type == NodeType::repeat ? kSuccess : kFailure;
  return visit(first_child(node));
}

Step after_counted(NodeArray& nodes, NodeIndex node, NodeStatus answer) noexcept {
  Node& self = nodes.at(node);
  const NodeStatus again = self.type == NodeType::repeat ? NodeStatus::success : NodeStatus::failure;
  if (answer != again) return say(answer);
  const auto rounds = port_value<std::int64_t>(nodes, node, port::kCount);
  if (self.count < std::numeric_limits<std::int32_t>::max()) ++self.count;
  if (!rounds) return kFailure;
  return *rounds < 0 || self.count < *rounds ? kRunning : say(answer);
}

Step enter_run_once(NodeArray& nodes, NodeIndex node) noexcept {
  const Node& self = nodes.at(node);
  if (self.remembered == NodeStatus::idle) return visit(first_child(node));
  return port_value<bool>(nodes, node, port::kThenSkip).value_or(true) ? kSkipped : say(self.remembered);
}

// now + the port's time; nothing: the entry has not been set.
std::optional<std::int64_t> time_from_now(NodeArray& nodes, NodeIndex node) noexcept {
  const auto time_ns = port_value<std::int64_t>(nodes, node, port::kTime);
  if (!time_ns) return std::nullopt;
  const std::int64_t latest = std::numeric_limits<std::int64_t>::max();
  return nodes.now_ns() > latest - *time_ns ? latest : nodes.now_ns() + *time_ns;
}

Step enter_timed(NodeArray& nodes, NodeIndex node, bool begins) noexcept {
  Node& self = nodes.at(node);
  if (begins) {
    const auto until_ns = time_from_now(nodes, node);
    if (!until_ns) return kFailure;
    self.until_ns = *until_ns;
    // A timeout of nothing is none.
    if (self.type == NodeType::timeout && *until_ns == nodes.now_ns()) {
      self.until_ns = std::numeric_limits<std::int64_t>::max();
    }
  }
  const bool over = nodes.now_ns() >= self.until_ns;
  if (self.type == NodeType::timeout) return over ? kFailure : visit(first_child(node));
  if (self.type == NodeType::sleep) return over ? kSuccess : kRunning;
  return over ? visit(first_child(node)) : kRunning;  // Delay
}

// `remembered` is success from the end of a run on, until it has cooled down.
Step enter_cooldown(NodeArray& nodes, NodeIndex node, bool begins) noexcept {
  Node& self = nodes.at(node);
  if (!begins) return visit(first_child(node));
  if (self.remembered == NodeStatus::success && nodes.now_ns() < self.until_ns) return kFailure;
  self.remembered = NodeStatus::idle;
  return visit(first_child(node));
}

Step after_cooldown(NodeArray& nodes, NodeIndex node, NodeStatus answer) noexcept {
  if (answer == NodeStatus::success || answer == NodeStatus::failure) {
    Node& self = nodes.at(node);
    if (const auto until_ns = time_from_now(nodes, node)) {
      self.until_ns = *until_ns;
      self.remembered = NodeStatus::success;
    }
  }
  return say(answer);
}

Step after_changing(NodeType type, NodeStatus answer) noexcept {
  const bool ended = answer == NodeStatus::success || answer == NodeStatus::failure;
  switch (type) {
    case NodeType::inverter:
      return !ended ? say(answer) : answer == NodeStatus::success ? kFailure : kSuccess;
    case NodeType::force_success:
      return ended ? kSuccess : say(answer);
    case NodeType::force_failure:
      return ended ? kFailure : say(answer);
    case NodeType::keep_running_until_failure:
      return answer == NodeStatus::failure ? kFailure : kRunning;
    default:
      return say(answer);
  }
}

// ---- Leaves

Step write_entry(NodeArray& nodes, NodeIndex node) noexcept {
  Call call = nodes.call(node);
  return call.set(port::kOutputKey, call.value(port::kWritten)) ? kSuccess : kFailure;
}

}  // namespace

Step enter(NodeArray& nodes, NodeIndex node) noexcept {
  if (nodes.at(node).pending != NodeStatus::idle) return say(nodes.at(node).pending);
  const bool begins = !nodes.active(node);
  if (begins) nodes.start(node);
  switch (nodes.at(node).type) {
    case NodeType::sequence:
    case NodeType::sequence_with_memory:
    case NodeType::fallback:
      return enter_in_turn(nodes, node, begins);
    case NodeType::reactive_sequence:
    case NodeType::reactive_fallback:
      return enter_reactive(nodes, node);
    case NodeType::parallel:
    case NodeType::parallel_all:
      return enter_parallel(nodes, node, begins);
    case NodeType::if_then_else:
      if (begins) nodes.at(node).current = first_child(node);
      return visit(nodes.at(node).current);
    case NodeType::switch_cases:
      return enter_switch(nodes, node, begins);
    case NodeType::repeat:
    case NodeType::retry_until_successful:
      return enter_counted(nodes, node, begins);
    case NodeType::run_once:
      return enter_run_once(nodes, node);
    case NodeType::timeout:
    case NodeType::delay:
    case NodeType::sleep:
      return enter_timed(nodes, node, begins);
    case NodeType::cooldown:
      return enter_cooldown(nodes, node, begins);
    case NodeType::while_do_else:
    case NodeType::inverter:
    case NodeType::force_success:
    case NodeType::force_failure:
    case NodeType::keep_running_until_failure:
    case NodeType::sub_tree:
      return visit(first_child(node));
    case NodeType::always_success:
      return kSuccess;
    case NodeType::always_failure:
      return kFailure;
    case NodeType::set_blackboard:
      return write_entry(nodes, node);
    case NodeType::condition:
      return say(nodes.call_condition(node));
    case NodeType::action:
      return say(nodes.call_action(node));
  }
  return kFailure;
}

Step after(NodeArray& nodes, NodeIndex node, NodeIndex child, NodeStatus answer) noexcept {
  Node& self = nodes.at(node);
  switch (self.type) {
    case NodeType::sequence:
    case NodeType::sequence_with_memory:
    case NodeType::fallback:
      return after_in_turn(nodes, node, child, answer);
    case NodeType::reactive_sequence:
    case NodeType::reactive_fallback:
      return after_reactive(nodes, node, child, answer);
    case NodeType::parallel:
    case NodeType::parallel_all:
      return after_parallel(nodes, node, child, answer);
    case NodeType::if_then_else:
    case NodeType::while_do_else:
      return after_branching(nodes, node, child, answer);
    case NodeType::repeat:
    case NodeType::retry_until_successful:
      return after_counted(nodes, node, answer);
    case NodeType::run_once:
      if (answer == NodeStatus::success || answer == NodeStatus::failure) self.remembered = answer;
      return say(answer);
    case NodeType::cooldown:
      return after_cooldown(nodes, node, answer);
    default:
      return after_changing(self.type, answer);
  }
}

}  // namespace gaitway::behaviour
