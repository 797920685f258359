// Compares two descriptions, and what runs in one with what the other has room for.
#include "hot_change.hpp"

#include <fmt/format.h>

#include <map>
#include <string_view>
#include <utility>

namespace gaitway::behaviour {
namespace {

bool same(const DescribedNode& a, const DescribedNode& b) {
  return a.segment == b.segment && a.type == b.type && a.id == b.id;
}

// Parents come before their children, so each node is compared with the children of its parent's counterpart.
void match_nodes(const NodeArray& running, const NodeArray& next, Counterparts& found) {
  const Description& old = running.description();
  const Description& fresh = next.description();
  const auto pair = [&found](NodeIndex fresh_node, NodeIndex old_node) {
    found.nodes[static_cast<std::size_t>(fresh_node)] = old_node;
    found.kept[static_cast<std::size_t>(old_node)] = fresh_node;
  };
  if (fresh.main_tree == old.main_tree && same(fresh.nodes[0], old.nodes[0])) pair(0, 0);
  for (NodeIndex parent = 0; parent < static_cast<NodeIndex>(found.nodes.size()); ++parent) {
    const NodeIndex counterpart = found.nodes[static_cast<std::size_t>(parent)];
    if (counterpart == kNoNode || next.at(parent).children == 0 || running.at(counterpart).children == 0)
      continue;
    std::map<std::string_view, NodeIndex> there;
    for (NodeIndex i = counterpart + 1; i != kNoNode; i = running.at(i).next_sibling) {
      there.emplace(old.nodes[static_cast<std::size_t>(i)].segment, i);
    }
    for (NodeIndex i = parent + 1; i != kNoNode; i = next.at(i).next_sibling) {
      const DescribedNode& node = fresh.nodes[static_cast<std::size_t>(i)];
      const auto row = there.find(node.segment);
      if (row != there.end() && same(node, old.nodes[static_cast<std::size_t>(row->second)]))
        pair(i, row->second);
    }
  }
}

void match_entries(const Description& old, const Description& fresh, Counterparts& found) {
  std::map<std::pair<NodeIndex, std::string_view>, std::size_t> there;
  for (std::size_t i = 0; i < old.entries.size(); ++i) {
    there.emplace(std::pair(old.entries[i].scope, std::string_view(old.entries[i].key)), i);
  }
  for (std::size_t i = 0; i < fresh.entries.size(); ++i) {
    const Entry& entry = fresh.entries[i];
    const bool main = entry.scope == kNoNode;
    const NodeIndex scope = main ? kNoNode : found.nodes[static_cast<std::size_t>(entry.scope)];
    if (scope == kNoNode && !main) continue;
    const auto row = there.find({scope, entry.key});
    if (row != there.end()) found.entries[i] = static_cast<std::int64_t>(row->second);
  }
}

class Check {
 public:
  Check(const NodeArray& running, const NodeArray& next, const Counterparts& counterparts,
        std::vector<std::string>* reasons)
      : running_(running), next_(next), counterparts_(counterparts), reasons_(reasons) {}

  bool passes() {
    if (counterparts_.running != running_.id()) {
      refuse([] { return std::string("it was prepared for what the tree was before: prepare it anew"); });
      return false;
    }
    for (NodeIndex i = 0; i < static_cast<NodeIndex>(counterparts_.kept.size()) && goes_on(); ++i)
      check_node(i);
    for (std::size_t i = 0; i < counterparts_.entries.size() && goes_on(); ++i) {
      if (counterparts_.entries[i] >= 0) check_entry(i, static_cast<std::size_t>(counterparts_.entries[i]));
    }
    return passes_;
  }

 private:
  [[nodiscard]] bool goes_on() const { return passes_ || reasons_ != nullptr; }
  [[nodiscard]] bool is_kept(NodeIndex node) const {
    return counterparts_.kept[static_cast<std::size_t>(node)] != kNoNode;
  }
  [[nodiscard]] const DescribedNode& described(NodeIndex node) const {
    return running_.description().nodes[static_cast<std::size_t>(node)];
  }

  // Whether what this node is doing goes on in the new tree.
  void check_node(NodeIndex node) {
    const Node& self = running_.at(node);
    if (!is_kept(node)) {
      const bool action_is_halting = running_.status(node) == NodeStatus::halting && self.children == 0;
      const bool topmost = self.parent == kNoNode || is_kept(self.parent);
      if (!action_is_halting && !(running_.active(node) && topmost)) return;
      refuse([&] {
        return fmt::format("'{}' ({}) is {} and is not in the new tree: wait for its end, or halt the tree",
                           running_.description().path(node), described(node).id,
                           name(running_.status(node)));
      });
      return;
    }
    const bool remembers = self.type == NodeType::sequence_with_memory;
    if (self.current == kNoNode || (!remembers && !running_.active(node)) || running_.active(self.current))
      return;
    if (is_kept(self.current)) return;
    refuse([&] {
      return fmt::format(
          "'{}' goes on at '{}', which is not in the new tree: wait for its end, or halt the tree",
          running_.description().path(node), described(self.current).segment);
    });
  }

  // What still holds what the old file gave it gets what the new file gives it, and so always fits.
  void check_entry(std::size_t fresh, std::size_t old) {
    const Entry& entry = next_.description().entries[fresh];
    const Entry& before = running_.description().entries[old];
    const Value& value = running_.values()[old];
    if (value == before.initial) return;
    if (!same_type(entry.type, before.type)) {
      refuse([&] {
        return fmt::format("the entry '{}' holds {} ('{}') and would become {}", entry.key,
                           describe(before.type), written(value, before.type), describe(entry.type));
      });
    } else if (!fits(value, entry.type)) {
      refuse([&] {
        return fmt::format("the entry '{}' holds '{}', which the new tree's ports do not take", entry.key,
                           written(value, before.type));
      });
    }
  }

  template <class Reason>
  void refuse(const Reason& reason) {
    constexpr std::size_t kMost = 100;
    passes_ = false;
    if (reasons_ != nullptr && reasons_->size() < kMost) reasons_->push_back(reason());
  }

  const NodeArray& running_;
  const NodeArray& next_;
  const Counterparts& counterparts_;
  std::vector<std::string>* reasons_;
  bool passes_ = true;
};

}  // namespace

Counterparts compare(const NodeArray& running, const NodeArray& next) {
  Counterparts found;
  found.running = running.id();
  found.nodes.assign(next.description().nodes.size(), kNoNode);
  found.kept.assign(running.description().nodes.size(), kNoNode);
  found.entries.assign(next.description().entries.size(), -1);
  match_nodes(running, next, found);
  match_entries(running.description(), next.description(), found);
  return found;
}

bool can_carry_over(const NodeArray& running, const NodeArray& next, const Counterparts& counterparts,
                    std::vector<std::string>* reasons) {
  return Check(running, next, counterparts, reasons).passes();
}

}  // namespace gaitway::behaviour
