// A checked behaviour tree as a value: sub-trees are put in, names are resolved, every value has its type.
// read.hpp makes it; Tree runs it; draw.hpp draws it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/behaviour/node_type.hpp"
#include "gaitway/behaviour/value.hpp"

namespace gaitway::behaviour {

inline constexpr std::size_t kMostNodes = 10'000;  // with every sub-tree put in where it is used
inline constexpr std::size_t kMostDepth = 1'000;   // nodes from the root to a leaf, both counted

using NodeIndex = std::int32_t;
inline constexpr NodeIndex kNoNode = -1;

struct PortBinding {
  enum class Source : std::uint8_t { none, constant, entry };
  Source source = Source::none;
  bool writable = false;    // an output
  std::uint32_t index = 0;  // into constants or entries
};

// One entry of one blackboard. Each use of a sub-tree has a blackboard of its own.
struct Entry {
  std::string key;
  NodeIndex scope = kNoNode;  // the SubTree node whose blackboard it is in; none: the main tree's
  ValueType type{};
  Value initial{};  // std::monostate: not set
};

struct DescribedNode {
  NodeType type = NodeType::always_success;
  NodeKind kind = NodeKind::action;
  std::string id;       // as registered: "Switch3", "GoTo"; of a SubTree, the tree's ID
  std::string segment;  // its name (as given, otherwise the id), made unique among its siblings by "#2"
  int line = 0;
  NodeIndex parent = kNoNode;
  NodeIndex next_sibling = kNoNode;
  NodeIndex end = 0;  // the first node behind those below it
  std::int32_t children = 0;
  std::int32_t depth = 0;  // of the root 0
  std::uint32_t first_port = 0;
  std::uint32_t ports = 0;
  std::vector<std::pair<std::string, std::string>> written{};  // its ports as they stand in the file
};

// Nodes lie in pre-order: the root first, each node before its children, the first child right behind it.
struct Description {
  std::string main_tree;
  std::vector<DescribedNode> nodes;
  std::vector<PortBinding> bindings;
  std::vector<Value> constants;
  std::vector<Entry> entries;
  bool may_succeed = true;  // as outcomes.hpp has it

  [[nodiscard]] std::span<const PortBinding> ports(NodeIndex node) const {
    const DescribedNode& described = nodes[static_cast<std::size_t>(node)];
    return std::span(bindings).subspan(described.first_port, described.ports);
  }
  // Segments from the root, between slashes.
  [[nodiscard]] std::string path(NodeIndex node) const;
};

}  // namespace gaitway::behaviour
