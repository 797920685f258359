// The nodes of one tree: each element against the built-in nodes and the registry.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "definitions.hpp"
#include "gaitway/input/number.hpp"

namespace gaitway::behaviour {
namespace {

constexpr std::size_t kLongestName_bytes = Text::kMost;  // of values, too: nothing longer can be one

std::optional<NodeKind> kind_of_element(std::string_view element) {
  for (const NodeKind kind :
       {NodeKind::control, NodeKind::decorator, NodeKind::sub_tree, NodeKind::condition, NodeKind::action}) {
    if (element == name(kind)) return kind;
  }
  return std::nullopt;
}

std::string children_rule(std::size_t least, std::size_t most) {
  if (most == 0) return "must have no child";
  if (least == most) return fmt::format("must have {} {}", least, least == 1 ? "child" : "children");
  if (most > kMostNodes)
    return fmt::format("must have at least {} {}", least, least == 1 ? "child" : "children");
  return fmt::format("must have {} or {} children", least, most);
}

class NodeReader {
 public:
  NodeReader(const std::vector<XmlElement>& document, const Registry& registry, Definitions& all,
             Definition& definition, Complaints& complaints)
      : document_(document), registry_(registry), all_(all), tree_(definition), complaints_(complaints) {}

  // Elements lie in pre-order, so those of the tree are one piece of the document.
  void read() {
    const std::size_t first = tree_.element + 1;
    std::size_t behind = first;
    while (behind < document_.size() && document_[behind].parent >= static_cast<std::int32_t>(tree_.element))
      ++behind;
    tree_.nodes.resize(behind - first);
    children_.assign(behind - first, 0);
    std::size_t roots = 0;
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
      tree_.nodes[i].parent = document_[first + i].parent - static_cast<std::int32_t>(first);
      ++(tree_.nodes[i].parent >= 0 ? children_[static_cast<std::size_t>(tree_.nodes[i].parent)] : roots);
    }
    if (roots != 1) {
      complaints_.add({tree_.line, tree_.id}, "", fmt::format("{} nodes", roots),
                      "must hold exactly one node", "Put several below a Sequence or another control node");
    }
    for (node_ = 0; node_ < tree_.nodes.size() && !complaints_.full(); ++node_) {
      read_node(document_[first + node_], tree_.nodes[node_]);
    }
  }

 private:
  void complain(int line, std::string field, std::string value, std::string rule, std::string remedy) {
    complaints_.add({line, tree_.path(node_)}, std::move(field), std::move(value), std::move(rule),
                    std::move(remedy));
  }

  void read_node(const XmlElement& element, DefinedNode& node) {
    node.line = element.line;
    node.segment = element.name;  // until more is known
    const auto explicit_kind = kind_of_element(element.name);
    const XmlAttribute* const id = element.find("ID");
    if (explicit_kind && (id == nullptr || id->value.empty())) {
      return complain(element.line, "ID", "", fmt::format("<{}> needs it", element.name), "Name the node");
    }
    if (!explicit_kind && id != nullptr) {
      complain(id->line, "ID", id->value,
               "stands only in <Action>, <Condition>, <Control>, <Decorator> and <SubTree>",
               "Remove it; a name is given as name=\"...\"");
    }
    node.id = explicit_kind ? id->value : element.name;
    node.segment = node.id;
    name_node(element, node);
    if (element.has_text) complain(element.line, "", "", "has text in it", "Write values as attributes");
    if (explicit_kind == NodeKind::sub_tree) {
      read_sub_tree(element, node);
    } else if (find_type(element, node)) {
      if (explicit_kind && *explicit_kind != node.kind) {
        complain(element.line, "<" + element.name + ">", node.id,
                 fmt::format("is of the kind {}", name(node.kind)),
                 fmt::format("Write <{}>", name(node.kind)));
      }
      read_ports(element, node);
    }
  }

  void name_node(const XmlElement& element, DefinedNode& node) {
    if (const XmlAttribute* const given = element.find("name"); given != nullptr && !given->value.empty()) {
      node.segment = given->value;
    }
    if (node.segment.size() > kLongestName_bytes) {
      const std::string whole = std::exchange(node.segment, node.segment.substr(0, 20) + "...");
      complain(element.line, "name", whole, fmt::format("must have at most {} bytes", kLongestName_bytes),
               "Shorten it");
    }
    const std::string base = node.segment;
    int& count = same_name_[{node.parent, base}];
    while (!names_.insert({node.parent, node.segment}).second)
      node.segment = fmt::format("{}#{}", base, ++count + 1);
  }

  // Sets type, kind and specs; false: it is no node that can be used.
  bool find_type(const XmlElement& element, DefinedNode& node) {
    if (const Unsupported* const refused = find_unsupported_node(node.id)) {
      complain(element.line, "", "", fmt::format("{} is not supported", node.id),
               std::string(refused->remedy));
      return false;
    }
    std::size_t least = 0, most = 0;
    if (const Builtin* const builtin = find_builtin(node.id)) {
      node.type = builtin->type;
      node.kind = builtin->kind;
      node.specs = &builtin->ports;
      least = builtin->least_children;
      most = builtin->most_children;
    } else if (const Registry::Leaf* const leaf = registry_.find(node.id)) {
      const bool condition = std::holds_alternative<ConditionMaker>(leaf->maker);
      node.type = condition ? NodeType::condition : NodeType::action;
      node.kind = condition ? NodeKind::condition : NodeKind::action;
      node.specs = &leaf->spec.ports;
    } else {
      const bool tree = all_.by_id.contains(node.id);
      complain(element.line, "", "", fmt::format("no node '{}' is known", node.id),
               tree ? fmt::format("To use the tree of this name, write <SubTree ID=\"{}\"/>", node.id)
                    : input::suggest(node.id, known_nodes()));
      return false;
    }
    check_children(element, least, most);
    return true;
  }

  void check_children(const XmlElement& element, std::size_t least, std::size_t most) {
    const std::size_t children = children_[node_];
    if (children >= least && children <= most) return;
    complain(element.line, "children", fmt::format("{}", children), children_rule(least, most),
             children > most && most == 1 ? "Put them below a Sequence or another control node"
             : children > most            ? "Remove what is too much"
                                          : "Add what is missing");
  }

  [[nodiscard]] std::vector<std::string> known_nodes() const {
    std::vector<std::string> known;
    for (const auto& [id, leaf] : registry_.leaves()) known.push_back(id);
    for (const Builtin& builtin : builtin_nodes()) known.push_back(builtin.id);
    known.emplace_back("SubTree");
    return known;
  }

  // Whether an attribute is a port, by its name; complains about one that is refused.
  bool is_port(const XmlAttribute& attribute, const DefinedNode& node) {
    if (attribute.name == "ID" || attribute.name == "name" || is_editor_attribute(attribute.name))
      return false;
    if (const Unsupported* const refused = find_unsupported_attribute(attribute.name)) {
      complain(attribute.line, attribute.name, attribute.value,
               "scripts before and after nodes are not supported", std::string(refused->remedy));
      return false;
    }
    return node.kind != NodeKind::sub_tree || attribute.name != "_autoremap";
  }

  void read_ports(const XmlElement& element, DefinedNode& node) {
    node.ports.resize(node.specs->size());
    for (const XmlAttribute& attribute : element.attributes) {
      if (!is_port(attribute, node)) continue;
      const auto spec = std::ranges::find(*node.specs, attribute.name, &PortSpec::name);
      if (spec == node.specs->end()) {
        std::vector<std::string> known;
        for (const PortSpec& port : *node.specs) known.push_back(port.name);
        complain(attribute.line, attribute.name, attribute.value, fmt::format("is no port of {}", node.id),
                 input::suggest(attribute.name, known));
        continue;
      }
      if (!check_length(attribute.name, attribute.value, attribute.line)) {
        node.ports[static_cast<std::size_t>(spec - node.specs->begin())].line = attribute.line;
        continue;
      }
      node.written.emplace_back(attribute.name, attribute.value);
      read_port(*spec, attribute.value, attribute.line, node,
                node.ports[static_cast<std::size_t>(spec - node.specs->begin())]);
    }
    for (std::size_t i = 0; i < node.ports.size(); ++i) {
      const PortSpec& spec = (*node.specs)[i];
      if (node.ports[i].kind != PortText::Kind::none || node.ports[i].line != 0) continue;
      if (spec.standard) {
        read_port(spec, *spec.standard, node.line, node, node.ports[i]);
      } else if (spec.direction == PortDirection::input || node.type == NodeType::set_blackboard) {
        complain(node.line, spec.name, "", fmt::format("must be given ({})", describe(spec.type)),
                 fmt::format("Write {}=\"...\" or {}=\"{{key}}\"", spec.name, spec.name));
      }
    }
    check_thresholds(node);
  }

  void read_port(const PortSpec& spec, const std::string& value, int line, const DefinedNode& node,
                 PortText& port) {
    port.line = line;
    const Reference reference = reference_of(value, spec.name);
    if (node.type == NodeType::set_blackboard && spec.direction == PortDirection::output) {
      const bool plain =
          !reference.is_key && !value.empty() && value.find_first_of("{} ") == std::string::npos;
      if (!plain) {
        return complain(line, spec.name, value, "must be the entry's name, without braces",
                        reference.is_key ? fmt::format("Write '{}'", reference.key) : "Write a name");
      }
      port = {PortText::Kind::key, line, value};
    } else if (reference.is_key) {
      if (!check_key(reference.key, spec.name, value, line)) return;
      if (node.type == NodeType::switch_cases && spec.name != "variable") {
        return complain(line, spec.name, value, "must be a value",
                        "Cases are fixed: only the variable changes");
      }
      port = {PortText::Kind::key, line, reference.key};
    } else if (spec.direction != PortDirection::input) {
      complain(line, spec.name, value, "is an output: must name an entry of the blackboard",
               value.empty() ? "Write {key}" : fmt::format("Write {{{}}}", value));
    } else if (node.type == NodeType::set_blackboard || node.type == NodeType::switch_cases) {
      port = {PortText::Kind::untyped, line, value};
    } else {
      read_constant(spec, value, line, port);
    }
  }

  bool check_length(const std::string& field, const std::string& value, int line) {
    if (value.size() <= kLongestName_bytes) return true;
    complain(line, field, value, fmt::format("must have at most {} bytes", kLongestName_bytes), "Shorten it");
    return false;
  }

  bool check_key(const std::string& key, const std::string& field, const std::string& value, int line) {
    const std::string_view bare = std::string_view(key).substr(key.starts_with('@') ? 1 : 0);
    if (!bare.empty() && bare.find_first_of("{}@ ") == std::string_view::npos &&
        key.size() <= kLongestName_bytes) {
      return true;
    }
    complain(line, field, value,
             fmt::format("a key has 1 to {} bytes, no blanks, braces or @ inside", kLongestName_bytes),
             "Rename it");
    return false;
  }

  void read_constant(const PortSpec& spec, const std::string& value, int line, PortText& port) {
    try {
      port = {PortText::Kind::constant, line, value, parse_value(value, spec.type)};
    } catch (const input::ValueError& error) {
      complain(line, spec.name, value, explained(error.rule, spec.type), error.remedy);
    }
  }

  // No threshold is higher than there are children: it would never be reached.
  void check_thresholds(const DefinedNode& node) {
    if (node.type != NodeType::parallel && node.type != NodeType::parallel_all) return;
    for (std::size_t i = 0; i < node.ports.size(); ++i) {
      const std::int64_t* const threshold = std::get_if<std::int64_t>(&node.ports[i].constant);
      if (threshold == nullptr || *threshold <= static_cast<std::int64_t>(children_[node_])) continue;
      complain(node.ports[i].line, (*node.specs)[i].name, node.ports[i].text,
               fmt::format("must be at most {}, the number of children", children_[node_]),
               "-1 means all of them");
    }
  }

  void read_sub_tree(const XmlElement& element, DefinedNode& node) {
    node.type = NodeType::sub_tree;
    node.kind = NodeKind::sub_tree;
    check_children(element, 0, 0);
    const auto found = all_.by_id.find(node.id);
    if (found == all_.by_id.end()) {
      std::vector<std::string> ids;
      for (const Definition& tree : all_.trees) ids.push_back(tree.id);
      complain(element.line, "ID", node.id, "is no tree of this file", input::suggest(node.id, ids));
      return;
    }
    node.tree = found->second;
    for (const XmlAttribute& attribute : element.attributes) {
      if (attribute.name == "_autoremap") {
        try {
          node.autoremap = std::get<bool>(parse_value(attribute.value, {.kind = ValueKind::boolean}));
        } catch (const input::ValueError& error) {
          complain(attribute.line, attribute.name, attribute.value, error.rule, error.remedy);
        }
      } else if (is_port(attribute, node)) {
        remap(attribute.name, attribute.value, attribute.line, node);
      }
    }
    apply_model(node);
  }

  void remap(const std::string& inner, const std::string& value, int line, DefinedNode& node) {
    if (inner.starts_with('_') || inner.find_first_of(":.") != std::string::npos) {
      return complain(line, inner, value, "is no port that a sub-tree can have", "Begin it with a letter");
    }
    if (!check_length(inner, value, line)) return;
    node.written.emplace_back(inner, value);
    const Reference reference = reference_of(value, inner);
    if (reference.is_key && !check_key(reference.key, inner, value, line)) return;
    node.remappings.push_back({inner, !reference.is_key, reference.is_key ? reference.key : value, line});
  }

  // What TreeNodesModel says of this sub-tree's ports, if it does.
  void apply_model(DefinedNode& node) {
    const auto model = all_.models.find(node.id);
    if (model == all_.models.end()) return;
    std::vector<std::string> known;
    for (const auto& [port, row] : model->second.ports) known.push_back(port);
    for (Remapping& given : node.remappings) {
      given.from_model = model->second.ports.contains(given.inner);
      if (!given.from_model) {
        complain(given.line, given.inner, given.outer, fmt::format("is no port of the sub-tree {}", node.id),
                 input::suggest(given.inner, known));
      }
    }
    for (const auto& [port, row] : model->second.ports) {
      if (node.autoremap ||
          std::ranges::find(node.remappings, port, &Remapping::inner) != node.remappings.end()) {
        continue;
      }
      if (row.has_standard) {
        remap(port, row.standard, node.line, node);
        if (!node.remappings.empty()) node.remappings.back().from_model = true;
      } else {
        complain(node.line, port, "", fmt::format("the sub-tree {} needs it", node.id),
                 fmt::format("Write {}=\"{{key}}\"", port));
      }
    }
  }

  const std::vector<XmlElement>& document_;
  const Registry& registry_;
  const Definitions& all_;
  Definition& tree_;
  Complaints& complaints_;
  std::size_t node_ = 0;
  std::vector<std::size_t> children_;
  std::map<std::pair<std::int32_t, std::string>, int> same_name_;
  std::set<std::pair<std::int32_t, std::string>> names_;
};

}  // namespace

std::string explained(const std::string& rule, const ValueType& type) {
  const bool told = type.unit.empty() || rule.ends_with(type.unit) || rule.find("unit") != std::string::npos;
  return told ? rule : fmt::format("{} (in {})", rule, type.unit);
}

Reference reference_of(std::string_view value, std::string_view port) {
  const std::string_view text = input::trimmed(value);
  if (text == "=" || text == "{=}") return {true, std::string(port)};
  if (text.size() < 2 || text.front() != '{' || text.back() != '}') return {};
  return {true, std::string(text.substr(1, text.size() - 2))};
}

void define_nodes(const std::vector<XmlElement>& document, const Registry& registry, Definitions& all,
                  std::size_t tree, Complaints& complaints) {
  NodeReader(document, registry, all, all.trees[tree], complaints).read();
}

}  // namespace gaitway::behaviour
