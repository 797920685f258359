// Sizes first, without building anything, so that a small file can't ask for a large tree; then the nodes.
#include "expansion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "blackboard_layout.hpp"

namespace gaitway::behaviour {
namespace {

// Nodes and levels of a tree with all its sub-trees; both stop counting far above what is allowed.
struct Extent {
  std::size_t nodes = 0;
  std::size_t levels = 0;
};

class Extents {
 public:
  Extents(const Definitions& all, Complaints& complaints)
      : all_(all),
        complaints_(complaints),
        extents_(all.trees.size()),
        state_(all.trees.size(), State::unseen) {}

  // Visits every tree, those below it first. False: there is something wrong.
  bool check() {
    bool good = true;
    for (std::size_t i = 0; i < all_.trees.size(); ++i) good = visit(i) && good;
    if (!good) return false;
    const Definition& main = all_.trees[all_.main];
    const Extent extent = extents_[all_.main];
    if (extent.nodes > kMostNodes) {
      complaints_.add({main.line, main.id}, "nodes", fmt::format("{}", extent.nodes),
                      fmt::format("with its sub-trees, must have at most {} nodes", kMostNodes),
                      "Make it smaller");
    }
    if (extent.levels > kMostDepth) {
      complaints_.add({main.line, main.id}, "depth", fmt::format("{}", extent.levels),
                      fmt::format("with its sub-trees, must be at most {} nodes deep", kMostDepth),
                      "Make it flatter");
    }
    return extent.nodes <= kMostNodes && extent.levels <= kMostDepth;
  }

 private:
  enum class State : std::uint8_t { unseen, open, done };
  struct Visit {
    std::size_t tree;
    std::size_t next;  // node to look at
  };

  bool visit(std::size_t first) {
    if (state_[first] != State::unseen) return true;
    std::vector<Visit> open{{first, 0}};
    state_[first] = State::open;
    while (!open.empty()) {
      Visit& top = open.back();
      const std::vector<DefinedNode>& nodes = all_.trees[top.tree].nodes;
      while (top.next < nodes.size() &&
             (nodes[top.next].kind != NodeKind::sub_tree || state_[nodes[top.next].tree] == State::done)) {
        ++top.next;
      }
      if (top.next == nodes.size()) {
        measure(top.tree);
        state_[top.tree] = State::done;
        open.pop_back();
        continue;
      }
      const std::size_t below = nodes[top.next].tree;
      if (state_[below] == State::open) return complain_of_cycle(open, below);
      state_[below] = State::open;
      open.push_back({below, 0});
    }
    return true;
  }

  bool complain_of_cycle(const std::vector<Visit>& open, std::size_t again) {
    std::vector<std::string> cycle;
    for (auto visit = std::ranges::find(open, again, &Visit::tree); visit != open.end(); ++visit) {
      cycle.push_back(all_.trees[visit->tree].id);
    }
    cycle.push_back(all_.trees[again].id);
    const Definition& tree = all_.trees[open.back().tree];
    const std::size_t node = open.back().next;
    complaints_.add({tree.nodes[node].line, tree.path(node)}, "ID", all_.trees[again].id,
                    fmt::format("the sub-tree contains itself: {}", fmt::join(cycle, " > ")),
                    "Use Repeat or KeepRunningUntilFailure for what shall go on");
    return false;
  }

  void measure(std::size_t tree) {
    constexpr std::size_t kStop = 1'000'000'000;
    const std::vector<DefinedNode>& nodes = all_.trees[tree].nodes;
    Extent extent{nodes.size(), 0};
    std::vector<std::size_t> level(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      level[i] = nodes[i].parent < 0 ? 1 : level[static_cast<std::size_t>(nodes[i].parent)] + 1;
      std::size_t deepest = level[i];
      if (nodes[i].kind == NodeKind::sub_tree) {
        extent.nodes = std::min(kStop, extent.nodes + extents_[nodes[i].tree].nodes);
        deepest = std::min(kStop, deepest + extents_[nodes[i].tree].levels);
      }
      extent.levels = std::max(extent.levels, deepest);
    }
    extents_[tree] = extent;
  }

  const Definitions& all_;
  Complaints& complaints_;
  std::vector<Extent> extents_;
  std::vector<State> state_;
};

class Expansion {
 public:
  Expansion(const Definitions& all, Complaints& complaints) : all_(all), layout_(description_, complaints) {
    description_.main_tree = all.trees[all.main].id;
  }

  Description build() {
    enter(all_.main, kNoNode, 0);
    while (!frames_.empty()) {
      Frame& frame = frames_.back();
      if (frame.next == frame.tree->nodes.size()) {
        frames_.pop_back();
      } else {
        add(frame, frame.next++);
      }
    }
    link();
    layout_.finish();
    return std::move(description_);
  }

 private:
  struct Frame {
    const Definition* tree;
    std::size_t next = 0;
    NodeIndex parent = kNoNode;
    ScopeIndex scope = 0;
    std::vector<NodeIndex> places;  // where the tree's nodes lie in the description
  };

  void enter(std::size_t tree, NodeIndex parent, ScopeIndex scope) {
    frames_.push_back(
        {&all_.trees[tree], 0, parent, scope, std::vector<NodeIndex>(all_.trees[tree].nodes.size())});
  }

  // Makes `frame` invalid where the node is a SubTree.
  void add(Frame& frame, std::size_t index) {
    const DefinedNode& defined = frame.tree->nodes[index];
    const auto place = static_cast<NodeIndex>(description_.nodes.size());
    frame.places[index] = place;
    DescribedNode node;
    node.type = defined.type;
    node.kind = defined.kind;
    node.id = defined.id;
    node.segment = defined.segment;
    node.line = defined.line;
    node.parent = defined.parent < 0 ? frame.parent : frame.places[static_cast<std::size_t>(defined.parent)];
    node.written = defined.written;
    node.first_port = static_cast<std::uint32_t>(description_.bindings.size());
    node.ports = static_cast<std::uint32_t>(defined.ports.size());
    description_.nodes.push_back(std::move(node));
    bind_ports(defined, place, frame.scope);
    if (defined.kind != NodeKind::sub_tree) return;
    const ScopeIndex scope = layout_.add_scope(frame.scope, place, *frame.tree, index);
    enter(defined.tree, place, scope);
  }

  void bind_ports(const DefinedNode& defined, NodeIndex node, ScopeIndex scope) {
    const std::size_t first = description_.bindings.size();
    description_.bindings.resize(first + defined.ports.size());
    for (std::size_t i = 0; i < defined.ports.size(); ++i) {
      const PortText& text = defined.ports[i];
      const PortSpec& spec = (*defined.specs)[i];
      PortBinding& binding = description_.bindings[first + i];
      if (text.kind == PortText::Kind::constant) {
        binding = {.source = PortBinding::Source::constant,
                   .index = static_cast<std::uint32_t>(description_.constants.size())};
        description_.constants.push_back(text.constant);
      } else if (text.kind == PortText::Kind::key) {
        const std::uint32_t entry = layout_.entry(scope, text.text);
        binding = {PortBinding::Source::entry, spec.direction != PortDirection::input, entry};
        layout_.use(entry, spec, text.line, node);
      }
    }
    bind_untyped(defined, first, node);
  }

  // The ports of SetBlackboard and Switch have the type of the entry that they are connected with.
  void bind_untyped(const DefinedNode& defined, std::size_t first, NodeIndex node) {
    if (defined.type != NodeType::set_blackboard && defined.type != NodeType::switch_cases) return;
    const std::size_t typing = defined.type == NodeType::set_blackboard ? port::kOutputKey : port::kVariable;
    const PortBinding typed = description_.bindings[first + typing];
    const bool by_entry = typed.source == PortBinding::Source::entry;
    for (std::size_t i = 0; i < defined.ports.size(); ++i) {
      const PortBinding& binding = description_.bindings[first + i];
      if (defined.ports[i].kind == PortText::Kind::untyped) {
        layout_.write_later(first + i, by_entry ? static_cast<std::int64_t>(typed.index) : -1,
                            defined.ports[i], (*defined.specs)[i].name, node);
      } else if (i != typing && by_entry && binding.source == PortBinding::Source::entry) {
        layout_.unite(binding.index, typed.index);
      }
    }
  }

  // What follows from parents: siblings, ends, counts and depths.
  void link() {
    std::vector<DescribedNode>& nodes = description_.nodes;
    std::vector<NodeIndex> last_child(nodes.size(), kNoNode);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      nodes[i].end = static_cast<NodeIndex>(i) + 1;
      if (nodes[i].parent == kNoNode) continue;
      const auto parent = static_cast<std::size_t>(nodes[i].parent);
      nodes[i].depth = nodes[parent].depth + 1;
      ++nodes[parent].children;
      if (last_child[parent] != kNoNode) {
        nodes[static_cast<std::size_t>(last_child[parent])].next_sibling = static_cast<NodeIndex>(i);
      }
      last_child[parent] = static_cast<NodeIndex>(i);
    }
    for (std::size_t i = nodes.size(); i-- > 0;) {
      if (nodes[i].parent == kNoNode) continue;
      NodeIndex& end = nodes[static_cast<std::size_t>(nodes[i].parent)].end;
      end = std::max(end, nodes[i].end);
    }
  }

  const Definitions& all_;
  Description description_;
  BlackboardLayout layout_;
  std::vector<Frame> frames_;
};

}  // namespace

std::string Description::path(NodeIndex node) const {
  std::vector<std::string_view> segments;
  for (NodeIndex i = node; i != kNoNode; i = nodes[static_cast<std::size_t>(i)].parent) {
    segments.push_back(nodes[static_cast<std::size_t>(i)].segment);
  }
  std::string text = main_tree;
  for (auto segment = segments.rbegin(); segment != segments.rend(); ++segment) {
    text += '/';
    text += *segment;
  }
  return text;
}

Description expand(const Definitions& definitions, Complaints& complaints) {
  if (!Extents(definitions, complaints).check()) return {};
  return Expansion(definitions, complaints).build();
}

}  // namespace gaitway::behaviour
