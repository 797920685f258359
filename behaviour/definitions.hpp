// The trees of one file, each checked for itself: nodes are known, have the children and ports that they
// should have, and values of the right type. Sub-trees are not put in yet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "builtin_nodes.hpp"
#include "complaints.hpp"
#include "gaitway/behaviour/registry.hpp"
#include "xml_document.hpp"

namespace gaitway::behaviour {

// What a port is given: nothing, a value, the key of an entry, or text whose type an entry decides.
struct PortText {
  enum class Kind : std::uint8_t { none, constant, key, untyped };
  Kind kind = Kind::none;
  int line = 0;
  std::string text{};  // the key, or the text as written
  Value constant{};
};

// A port of a SubTree: in its blackboard `inner` is the entry `outer` of the blackboard around, or a
// constant.
struct Remapping {
  std::string inner;
  bool constant = false;
  std::string outer{};  // the key, or the constant as written
  int line = 0;
  bool from_model = false;  // the file says that the sub-tree has this port
};

struct DefinedNode {
  NodeType type = NodeType::always_success;
  NodeKind kind = NodeKind::action;
  std::string id{};
  std::string segment{};
  int line = 0;
  std::int32_t parent = -1;  // in the same definition
  const std::vector<PortSpec>* specs = nullptr;
  std::vector<PortText> ports{};  // in the order of specs
  std::vector<std::pair<std::string, std::string>> written{};
  // Of a SubTree:
  std::size_t tree = 0;  // which definition
  bool autoremap = false;
  std::vector<Remapping> remappings{};
};

// Nodes in pre-order.
struct Definition {
  std::string id;
  int line = 0;
  std::size_t element = 0;
  std::vector<DefinedNode> nodes{};
  [[nodiscard]] std::string path(std::size_t node) const;
};

// What TreeNodesModel says of a sub-tree: its ports and their standard values.
struct SubTreeModel {
  struct Port {
    std::string standard{};
    bool has_standard = false;
  };
  std::map<std::string, Port, std::less<>> ports{};
};

struct Definitions {
  std::vector<Definition> trees;
  std::map<std::string, std::size_t, std::less<>> by_id;
  std::map<std::string, SubTreeModel, std::less<>> models;
  std::size_t main = 0;
};

// Checks all of the document but what only shows when sub-trees are put in. What is wrong is added to
// `complaints`; then the definitions are not to be used.
[[nodiscard]] Definitions define_trees(const std::vector<XmlElement>& document, const Registry& registry,
                                       Complaints& complaints);

// The nodes of one tree. The ids of all trees are known already.
void define_nodes(const std::vector<XmlElement>& document, const Registry& registry, Definitions& all,
                  std::size_t tree, Complaints& complaints);

// What a value breaks, with the port's unit where the rule does not tell it.
[[nodiscard]] std::string explained(const std::string& rule, const ValueType& type);

// The key that "{key}" or "{=}" (the port's own name) stands for; `is_key` says whether it does.
struct Reference {
  bool is_key = false;
  std::string key{};
};
[[nodiscard]] Reference reference_of(std::string_view value, std::string_view port);

}  // namespace gaitway::behaviour
