// Starting, ending and halting of nodes. All memory is asked for in the constructor.
#include "node_array.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <stdexcept>
#include <utility>

#include "hot_change.hpp"

namespace gaitway::behaviour {
namespace {

// Relaxed: only that ids differ matters.
std::uint64_t next_id() noexcept {
  static std::atomic<std::uint64_t> last{0};
  return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

}  // namespace

NodeArray::NodeArray(Description description)
    : id_(next_id()),
      description_(std::move(description)),
      now_ns_(std::numeric_limits<std::int64_t>::min()) {
  const std::size_t count = description_.nodes.size();
  if (count == 0) throw std::invalid_argument("a behaviour tree without nodes");
  nodes_.reserve(count);
  std::int32_t leaves = 0;
  for (const DescribedNode& described : description_.nodes) {
    Node node;
    node.type = described.type;
    node.parent = described.parent;
    node.next_sibling = described.next_sibling;
    node.end = described.end;
    node.children = described.children;
    if (node.type == NodeType::condition || node.type == NodeType::action) node.leaf = leaves++;
    nodes_.push_back(node);
  }
  statuses_.assign(count, NodeStatus::idle);
  leaves_.resize(static_cast<std::size_t>(leaves));
  for (const Entry& entry : description_.entries) values_.push_back(entry.initial);
  halting_.reserve(leaves_.size());
  changed_.reserve(count);
  before_.assign(count, NodeStatus::idle);
  is_changed_.assign(count, 0);
  transitions_.reserve(count);
}

void NodeArray::make_leaves(const Registry& registry, std::span<const NodeIndex> counterparts) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].leaf < 0 || (!counterparts.empty() && counterparts[i] != kNoNode)) continue;
    Leaf& leaf = leaves_[static_cast<std::size_t>(nodes_[i].leaf)];
    const DescribedNode& described = description_.nodes[i];
    const Registry::Leaf* const found = registry.find(described.id);
    const bool condition = described.type == NodeType::condition;
    if (found == nullptr || std::holds_alternative<ConditionMaker>(found->maker) != condition ||
        found->spec.ports.size() != described.ports) {
      throw std::invalid_argument(
          fmt::format("behaviour leaf '{}' is not registered as the tree was checked against", described.id));
    }
    if (condition) {
      leaf.condition = std::get<ConditionMaker>(found->maker)();
    } else {
      leaf.action = std::get<ActionMaker>(found->maker)();
    }
    if (!leaf.condition && !leaf.action) {
      throw std::invalid_argument(fmt::format("behaviour leaf '{}': its maker makes nothing", described.id));
    }
  }
}

void NodeArray::begin_pass(std::int64_t now_ns) noexcept {
  now_ns_ = std::max(now_ns_, now_ns);
  ++pass_;
  transitions_.clear();
  advance_halting();
}

void NodeArray::end_pass() noexcept {
  for (const NodeIndex node : changed_) {
    const auto i = static_cast<std::size_t>(node);
    is_changed_[i] = 0;
    if (before_[i] != statuses_[i]) transitions_.push_back({node, before_[i], statuses_[i], now_ns_});
  }
  changed_.clear();
}

void NodeArray::set_status(NodeIndex node, NodeStatus status) noexcept {
  const auto i = static_cast<std::size_t>(node);
  if (statuses_[i] == status) return;
  if (is_changed_[i] == 0) {
    is_changed_[i] = 1;
    before_[i] = statuses_[i];
    changed_.push_back(node);
  }
  statuses_[i] = status;
}

// An idle node has only idle ones below it, besides actions that are halting, so whole branches are passed
// over.
void NodeArray::forget(NodeIndex node) noexcept {
  for (NodeIndex i = node; i < at(node).end;) {
    if (status(i) == NodeStatus::idle) {
      i = at(i).end;
    } else {
      if (status(i) != NodeStatus::halting) set_status(i, NodeStatus::idle);
      ++i;
    }
  }
}

void NodeArray::reset() noexcept {
  for (Node& node : nodes_) {
    node.remembered = NodeStatus::idle;
    node.counted = false;
    node.current = kNoNode;
    node.skipped = node.count = node.failures = 0;
    node.until_ns = 0;
  }
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = description_.entries[i].initial;
}

void NodeArray::start(NodeIndex node) noexcept {
  for (NodeIndex child = node + 1; child < at(node).end; child = at(child).end) forget(child);
  at(node).started = pass_;
}

NodeStatus NodeArray::finish(NodeIndex node, NodeStatus result) noexcept {
  Node& self = at(node);
  if (result == NodeStatus::running) {
    set_status(node, NodeStatus::running);
    return result;
  }
  for (NodeIndex child = node + 1; child < self.end; child = at(child).end) halt(child);
  const bool ended = self.halting_below == 0;
  self.pending = ended ? NodeStatus::idle : result;
  set_status(node, ended ? result : NodeStatus::halting);
  return ended ? result : NodeStatus::running;
}

void NodeArray::halt(NodeIndex node) noexcept {
  if (!active(node)) return;
  for (NodeIndex i = node; i < at(node).end;) {
    Node& self = at(i);
    if (status(i) == NodeStatus::idle) {
      i = self.end;
      continue;
    }
    if (self.type == NodeType::action && status(i) == NodeStatus::running) {
      halt_action(i);
    } else if (self.type != NodeType::action || status(i) != NodeStatus::halting) {
      self.pending = NodeStatus::idle;
      set_status(i, NodeStatus::idle);
    }
    ++i;
  }
}

void NodeArray::halt_action(NodeIndex node) noexcept {
  Call parameters = call(node);
  Action& action = *leaves_[static_cast<std::size_t>(at(node).leaf)].action;
  if (action.on_halt(parameters) == Action::Halt::ended) {
    set_status(node, NodeStatus::idle);
  } else {
    begin_halting(node);
  }
}

void NodeArray::begin_halting(NodeIndex leaf) noexcept {
  set_status(leaf, NodeStatus::halting);
  halting_.push_back(leaf);
  for (NodeIndex i = leaf; i != kNoNode; i = at(i).parent) ++at(i).halting_below;
}

void NodeArray::advance_halting() noexcept {
  std::size_t kept = 0;
  for (const NodeIndex leaf : halting_) {
    Call parameters = call(leaf);
    Action& action = *leaves_[static_cast<std::size_t>(at(leaf).leaf)].action;
    if (action.on_halting(parameters) == Action::Halt::ending) {
      halting_[kept++] = leaf;
      continue;
    }
    set_status(leaf, NodeStatus::idle);
    for (NodeIndex i = leaf; i != kNoNode; i = at(i).parent) --at(i).halting_below;
  }
  halting_.resize(kept);
}

NodeStatus NodeArray::call_condition(NodeIndex node) noexcept {
  Call parameters = call(node);
  Condition& condition = *leaves_[static_cast<std::size_t>(at(node).leaf)].condition;
  return condition.holds(parameters) ? NodeStatus::success : NodeStatus::failure;
}

NodeStatus NodeArray::call_action(NodeIndex node) noexcept {
  Call parameters = call(node);
  Action& action = *leaves_[static_cast<std::size_t>(at(node).leaf)].action;
  const Outcome outcome =
      status(node) == NodeStatus::running ? action.on_running(parameters) : action.on_start(parameters);
  return static_cast<NodeStatus>(outcome);
}

Call NodeArray::call(NodeIndex node) noexcept {
  return {now_ns_, description_.ports(node), description_.constants, values_, description_.entries};
}

bool NodeArray::set_value(std::size_t entry, const Value& value) noexcept {
  if (entry >= values_.size() || !fits(value, description_.entries[entry].type)) return false;
  values_[entry] = value;
  return true;
}

// Counts of children as these are now: some may have come or gone. Their statuses stay while the parent runs.
void NodeArray::recount(NodeIndex node) noexcept {
  Node& self = at(node);
  const bool parallel = self.type == NodeType::parallel || self.type == NodeType::parallel_all;
  const bool in_turn = self.type == NodeType::sequence || self.type == NodeType::sequence_with_memory ||
                       self.type == NodeType::fallback;
  if (!active(node) || (!parallel && !in_turn)) return;
  if (parallel) self.count = self.failures = 0;
  self.skipped = 0;
  for (NodeIndex child = node + 1; child != kNoNode; child = at(child).next_sibling) {
    if (parallel) {
      self.count += at(child).counted ? 1 : 0;
      self.failures += at(child).counted && status(child) == NodeStatus::failure ? 1 : 0;
    }
    if (in_turn && child == self.current) break;
    self.skipped += status(child) == NodeStatus::skipped ? 1 : 0;
  }
}

void NodeArray::take_over(NodeArray& other, const Counterparts& counterparts) noexcept {
  now_ns_ = other.now_ns_;
  pass_ = other.pass_;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (counterparts.nodes[i] == kNoNode) continue;
    const auto from = static_cast<std::size_t>(counterparts.nodes[i]);
    const Node& old = other.nodes_[from];
    Node& self = nodes_[i];
    self.pending = old.pending;
    self.remembered = old.remembered;
    self.counted = old.counted;
    self.current =
        old.current == kNoNode ? kNoNode : counterparts.kept[static_cast<std::size_t>(old.current)];
    self.skipped = old.skipped;
    self.count = old.count;
    self.failures = old.failures;
    self.until_ns = old.until_ns;
    self.started = old.started;
    statuses_[i] = other.statuses_[from];
    if (self.leaf >= 0) {
      leaves_[static_cast<std::size_t>(self.leaf)] =
          std::move(other.leaves_[static_cast<std::size_t>(old.leaf)]);
    }
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) recount(static_cast<NodeIndex>(i));
  for (const NodeIndex leaf : other.halting_)
    begin_halting(counterparts.kept[static_cast<std::size_t>(leaf)]);
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (counterparts.entries[i] < 0) continue;
    const auto from = static_cast<std::size_t>(counterparts.entries[i]);
    if (other.values_[from] != other.description_.entries[from].initial) values_[i] = other.values_[from];
  }
}

}  // namespace gaitway::behaviour
