// One pass through the nodes: a loop that goes down to children and up to parents, without calls of itself.
#include "gaitway/behaviour/tree.hpp"

#include <utility>

#include "hot_change.hpp"
#include "node_array.hpp"
#include "node_rules.hpp"

namespace gaitway::behaviour {
namespace {

NodeStatus pass_from_root(NodeArray& nodes) noexcept {
  constexpr NodeIndex kRoot = 0;
  if (nodes.waits(kRoot)) return NodeStatus::running;
  NodeIndex node = kRoot;
  Step step = enter(nodes, kRoot);
  for (;;) {
    if (step.child == kNoNode) {
      const NodeStatus answer = nodes.finish(node, step.result);
      if (node == kRoot) return answer;
      const NodeIndex child = std::exchange(node, nodes.at(node).parent);
      step = after(nodes, node, child, answer);
    } else if (nodes.waits(step.child)) {
      step = after(nodes, node, step.child, NodeStatus::running);
    } else {
      node = step.child;
      step = enter(nodes, node);
    }
  }
}

}  // namespace

Tree::Tree(Description description, const Registry& registry)
    : nodes_(std::make_unique<NodeArray>(std::move(description))) {
  nodes_->make_leaves(registry);
}
Tree::~Tree() = default;
Tree::Tree(Tree&&) noexcept = default;
Tree& Tree::operator=(Tree&&) noexcept = default;

NodeStatus Tree::tick(std::int64_t now_ns) noexcept {
  nodes_->begin_pass(now_ns);
  const NodeStatus answer = pass_from_root(*nodes_);
  nodes_->end_pass();
  return answer;
}

bool Tree::halt(std::int64_t now_ns) noexcept {
  nodes_->begin_pass(now_ns);
  if (nodes_->active(0)) {
    nodes_->halt(0);
  } else {
    nodes_->forget(0);
  }
  nodes_->end_pass();
  return !nodes_->any_halting();
}

void Tree::reset() noexcept {
  nodes_->reset();
}

const Description& Tree::description() const noexcept {
  return nodes_->description();
}
std::span<const NodeStatus> Tree::statuses() const noexcept {
  return nodes_->statuses();
}
std::span<const Transition> Tree::transitions() const noexcept {
  return nodes_->transitions();
}

std::optional<std::size_t> Tree::entry(std::string_view key) const noexcept {
  const std::vector<Entry>& entries = description().entries;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].scope == kNoNode && entries[i].key == key) return i;
  }
  return std::nullopt;
}
std::span<const Value> Tree::values() const noexcept {
  return nodes_->values();
}
bool Tree::set_value(std::size_t entry, const Value& value) noexcept {
  return nodes_->set_value(entry, value);
}

PreparedChange::PreparedChange(std::unique_ptr<NodeArray> nodes,
                               std::unique_ptr<Counterparts> counterparts) noexcept
    : nodes_(std::move(nodes)), counterparts_(std::move(counterparts)) {}
PreparedChange::~PreparedChange() = default;
PreparedChange::PreparedChange(PreparedChange&&) noexcept = default;
PreparedChange& PreparedChange::operator=(PreparedChange&&) noexcept = default;

PreparedChange Tree::prepare(Description next, const Registry& registry) const {
  auto nodes = std::make_unique<NodeArray>(std::move(next));
  auto counterparts = std::make_unique<Counterparts>(compare(*nodes_, *nodes));
  nodes->make_leaves(registry, counterparts->nodes);
  return {std::move(nodes), std::move(counterparts)};
}

bool Tree::adopt(PreparedChange& change) noexcept {
  if (!can_carry_over(*nodes_, *change.nodes_, *change.counterparts_, nullptr)) return false;
  change.nodes_->take_over(*nodes_, *change.counterparts_);
  std::swap(nodes_, change.nodes_);
  return true;
}

std::vector<std::string> Tree::refusals(const PreparedChange& change) const {
  std::vector<std::string> reasons;
  (void)can_carry_over(*nodes_, *change.nodes_, *change.counterparts_, &reasons);
  return reasons;
}

Change Tree::change(Description next, const Registry& registry) {
  PreparedChange prepared = prepare(std::move(next), registry);
  Change report{.refused = refusals(prepared)};
  for (const NodeIndex node : prepared.counterparts_->nodes) report.kept += node != kNoNode ? 1 : 0;
  report.added = prepared.counterparts_->nodes.size() - report.kept;
  report.removed = prepared.counterparts_->kept.size() - report.kept;
  if (report.done()) (void)adopt(prepared);
  return report;
}

}  // namespace gaitway::behaviour
