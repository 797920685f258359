// The nodes of a running tree in one contiguous array, their statuses, values and leaves; starting, ending
// and halting, which are the same for every type of node. node_rules.hpp has what differs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gaitway/behaviour/description.hpp"
#include "gaitway/behaviour/leaf.hpp"
#include "gaitway/behaviour/registry.hpp"
#include "gaitway/behaviour/tree.hpp"

namespace gaitway::behaviour {

struct Node {
  // What it is.
  NodeType type = NodeType::always_success;
  NodeIndex parent = kNoNode;
  NodeIndex next_sibling = kNoNode;
  NodeIndex end = 0;
  std::int32_t children = 0;
  std::int32_t leaf = -1;  // into the leaves
  // How it stands.
  NodeStatus pending =
      NodeStatus::idle;  // its result, while it waits for actions below it to end; idle: none
  NodeStatus remembered = NodeStatus::idle;  // RunOnce: the result of that one run
  bool counted = false;                      // below a Parallel: has ended in this run of it
  NodeIndex current = kNoNode;               // the child at which it goes on
  std::int32_t skipped = 0;                  // children in this run, or in this pass
  std::int32_t count = 0;                    // rounds, attempts, successes, ended children
  std::int32_t failures = 0;
  std::int32_t halting_below = 0;  // actions that come to their end, itself included
  std::int64_t until_ns = 0;       // a deadline
  std::int64_t started = -1;       // in which pass
};

class NodeArray {
 public:
  struct Leaf {
    std::unique_ptr<Condition> condition;
    std::unique_ptr<Action> action;
  };

  // Without leaves. Throws std::invalid_argument for a description without nodes.
  explicit NodeArray(Description description);
  // Makes leaves, but for nodes with a counterpart, whose leaves take_over() brings. Throws
  // std::invalid_argument where the registry is not the one that the description was checked against.
  void make_leaves(const Registry& registry, std::span<const NodeIndex> counterparts = {});

  // A pass begins: time goes on, and what is halting comes a step further.
  void begin_pass(std::int64_t now_ns) noexcept;
  // And ends: transitions() tells what it has changed.
  void end_pass() noexcept;

  [[nodiscard]] Node& at(NodeIndex node) noexcept { return nodes_[static_cast<std::size_t>(node)]; }
  [[nodiscard]] const Node& at(NodeIndex node) const noexcept {
    return nodes_[static_cast<std::size_t>(node)];
  }
  [[nodiscard]] NodeStatus status(NodeIndex node) const noexcept {
    return statuses_[static_cast<std::size_t>(node)];
  }
  void set_status(NodeIndex node, NodeStatus status) noexcept;

  // It has begun and has not ended.
  [[nodiscard]] bool active(NodeIndex node) const noexcept {
    return status(node) == NodeStatus::running || at(node).pending != NodeStatus::idle;
  }
  // It must not begin yet: actions below it come to their end.
  [[nodiscard]] bool waits(NodeIndex node) const noexcept {
    return !active(node) && at(node).halting_below > 0;
  }

  // A new run of a node: what is below it is idle.
  void start(NodeIndex node) noexcept;
  // What the parent is told when a node's rule says `result`: that, or running as long as actions below it
  // have to come to their end first.
  NodeStatus finish(NodeIndex node, NodeStatus result) noexcept;
  // The node and all below it; nothing where it is not active.
  void halt(NodeIndex node) noexcept;
  // Whatever nodes remember of former runs, and the values; only while none is active or halting.
  void reset() noexcept;
  // Results that are still shown are forgotten; the node is not active.
  void forget(NodeIndex node) noexcept;

  NodeStatus call_condition(NodeIndex node) noexcept;
  NodeStatus call_action(NodeIndex node) noexcept;  // on_start() or on_running()

  [[nodiscard]] std::int64_t now_ns() const noexcept { return now_ns_; }
  [[nodiscard]] bool started_in_this_pass(NodeIndex node) const noexcept { return at(node).started == pass_; }
  [[nodiscard]] bool any_halting() const noexcept { return !halting_.empty(); }
  [[nodiscard]] Call call(NodeIndex node) noexcept;

  [[nodiscard]] const Description& description() const noexcept { return description_; }
  [[nodiscard]] std::span<const NodeStatus> statuses() const noexcept { return statuses_; }
  [[nodiscard]] std::span<const Transition> transitions() const noexcept { return transitions_; }
  [[nodiscard]] std::span<const Value> values() const noexcept { return values_; }
  bool set_value(std::size_t entry, const Value& value) noexcept;

  // Differs from that of every other array of this process.
  [[nodiscard]] std::uint64_t id() const noexcept { return id_; }
  // Takes over the time; state, status and leaf of each node's counterpart in the other array
  // (hot_change.hpp); and the value of each entry's, where it is another than the first. The other array is
  // left without those leaves.
  void take_over(NodeArray& other, const Counterparts& counterparts) noexcept;

 private:
  void recount(NodeIndex node) noexcept;
  void begin_halting(NodeIndex leaf) noexcept;
  void advance_halting() noexcept;
  void halt_action(NodeIndex node) noexcept;

  std::uint64_t id_;
  Description description_;
  std::vector<Node> nodes_;
  std::vector<NodeStatus> statuses_;
  std::vector<Value> values_;
  std::vector<Leaf> leaves_;
  std::vector<NodeIndex> halting_;  // actions
  std::int64_t now_ns_;
  std::int64_t pass_ = 0;
  // What this pass has changed: nodes, and what they were before.
  std::vector<NodeIndex> changed_;
  std::vector<NodeStatus> before_;
  std::vector<std::uint8_t> is_changed_;
  std::vector<Transition> transitions_;
};

}  // namespace gaitway::behaviour
