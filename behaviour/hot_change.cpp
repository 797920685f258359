// Nodes are the same when their paths and types are; entries, when their keys and places are.
#include "hot_change.hpp"

#include <fmt/format.h>

#include <map>
#include <string_view>
#include <utility>

namespace gaitway::behaviour {
namespace {

class Comparison {
 public:
  Comparison(const NodeArray& running, const NodeArray& next) : running_(running), next_(next) {
    match_nodes();
    match_entries();
    for (NodeIndex i = 0; i < static_cast<NodeIndex>(old().nodes.size()); ++i) check_kept(i);
  }

  [[nodiscard]] std::span<const NodeIndex> nodes() const { return nodes_; }
  [[nodiscard]] std::span<const std::int64_t> entries() const { return entries_; }
  [[nodiscard]] Change report() && {
    std::size_t kept = 0;
    for (const NodeIndex node : nodes_) kept += node != kNoNode ? 1 : 0;
    change_.kept = kept;
    change_.added = nodes_.size() - kept;
    change_.removed = old().nodes.size() - kept;
    return std::move(change_);
  }

 private:
  [[nodiscard]] const Description& old() const { return running_.description(); }
  [[nodiscard]] const Description& fresh() const { return next_.description(); }

  static bool same(const DescribedNode& a, const DescribedNode& b) {
    return a.segment == b.segment && a.type == b.type && a.id == b.id;
  }

  void pair(NodeIndex fresh_node, NodeIndex old_node) {
    nodes_[static_cast<std::size_t>(fresh_node)] = old_node;
    kept_[static_cast<std::size_t>(old_node)] = fresh_node;
  }

  // Parents come before their children, so each node is compared with the children of its parent's
  // counterpart.
  void match_nodes() {
    nodes_.assign(fresh().nodes.size(), kNoNode);
    kept_.assign(old().nodes.size(), kNoNode);
    if (fresh().main_tree == old().main_tree && same(fresh().nodes[0], old().nodes[0])) pair(0, 0);
    for (NodeIndex parent = 0; parent < static_cast<NodeIndex>(nodes_.size()); ++parent) {
      const NodeIndex counterpart = nodes_[static_cast<std::size_t>(parent)];
      if (counterpart == kNoNode || next_.at(parent).children == 0 || running_.at(counterpart).children == 0)
        continue;
      std::map<std::string_view, NodeIndex> there;
      for (NodeIndex i = counterpart + 1; i != kNoNode; i = running_.at(i).next_sibling) {
        there.emplace(old().nodes[static_cast<std::size_t>(i)].segment, i);
      }
      for (NodeIndex i = parent + 1; i != kNoNode; i = next_.at(i).next_sibling) {
        const DescribedNode& node = fresh().nodes[static_cast<std::size_t>(i)];
        const auto found = there.find(node.segment);
        if (found != there.end() && same(node, old().nodes[static_cast<std::size_t>(found->second)])) {
          pair(i, found->second);
        }
      }
    }
  }

  void match_entries() {
    entries_.assign(fresh().entries.size(), -1);
    std::map<std::pair<NodeIndex, std::string_view>, std::size_t> there;
    for (std::size_t i = 0; i < old().entries.size(); ++i) {
      there.emplace(std::pair(old().entries[i].scope, std::string_view(old().entries[i].key)), i);
    }
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const Entry& entry = fresh().entries[i];
      const NodeIndex scope =
          entry.scope == kNoNode ? kNoNode : nodes_[static_cast<std::size_t>(entry.scope)];
      if (scope == kNoNode && entry.scope != kNoNode) continue;
      const auto found = there.find({scope, entry.key});
      if (found != there.end()) match_entry(i, found->second);
    }
  }

  // What still holds what the old file gave it gets what the new file gives it.
  void match_entry(std::size_t fresh_entry, std::size_t old_entry) {
    const Entry& entry = fresh().entries[fresh_entry];
    const Entry& before = old().entries[old_entry];
    const Value& value = running_.values()[old_entry];
    if (value == before.initial) return;
    if (!same_type(entry.type, before.type)) {
      refuse(fmt::format("the entry '{}' holds {} ('{}') and would become {}", entry.key,
                         describe(before.type), written(value, before.type), describe(entry.type)));
    } else if (!fits(value, entry.type)) {
      refuse(fmt::format("the entry '{}' holds '{}', which the new tree's ports do not take", entry.key,
                         written(value, before.type)));
    } else {
      entries_[fresh_entry] = static_cast<std::int64_t>(old_entry);
    }
  }

  // Whether what this node is doing goes on in the new tree.
  void check_kept(NodeIndex node) {
    const auto i = static_cast<std::size_t>(node);
    const NodeStatus status = running_.status(node);
    if (kept_[i] == kNoNode) {
      const NodeIndex parent = running_.at(node).parent;
      const bool leaf_is_halting = status == NodeStatus::halting && running_.at(node).children == 0;
      const bool topmost = parent == kNoNode || kept_[static_cast<std::size_t>(parent)] != kNoNode;
      if (leaf_is_halting || (running_.active(node) && topmost)) {
        refuse(fmt::format("'{}' ({}) is {} and is not in the new tree: wait for its end, or halt the tree",
                           old().path(node), old().nodes[i].id, name(status)));
      }
      return;
    }
    const NodeIndex current = running_.at(node).current;
    const bool remembers = running_.at(node).type == NodeType::sequence_with_memory;
    if (current == kNoNode || (!remembers && !running_.active(node)) || running_.active(current)) return;
    if (kept_[static_cast<std::size_t>(current)] == kNoNode) {
      refuse(fmt::format(
          "'{}' goes on at '{}', which is not in the new tree: wait for its end, or halt the tree",
          old().path(node), old().nodes[static_cast<std::size_t>(current)].segment));
    }
  }

  void refuse(std::string reason) {
    constexpr std::size_t kMost = 100;
    if (change_.refused.size() < kMost) change_.refused.push_back(std::move(reason));
  }

  const NodeArray& running_;
  const NodeArray& next_;
  std::vector<NodeIndex> nodes_;       // of each new node, the old one
  std::vector<NodeIndex> kept_;        // of each old node, the new one
  std::vector<std::int64_t> entries_;  // of each new entry, the old one
  Change change_;
};

}  // namespace

Change carry_over(NodeArray& running, NodeArray& next, const Registry& registry) {
  Comparison comparison(running, next);
  const std::vector<NodeIndex> nodes(comparison.nodes().begin(), comparison.nodes().end());
  const std::vector<std::int64_t> entries(comparison.entries().begin(), comparison.entries().end());
  Change change = std::move(comparison).report();
  if (!change.done()) return change;
  next.make_leaves(registry, nodes);
  next.take_over(running, nodes, entries);
  return change;
}

}  // namespace gaitway::behaviour
