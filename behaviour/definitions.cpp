// The outer elements of a file: root, BehaviorTree and TreeNodesModel.
#include "definitions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "gaitway/input/number.hpp"

namespace gaitway::behaviour {
namespace {

class Outline {
 public:
  Outline(const std::vector<XmlElement>& document, const Registry& registry, Complaints& complaints)
      : document_(document), registry_(registry), complaints_(complaints) {}

  Definitions read() {
    const XmlElement& root = document_[0];
    if (root.name != "root") {
      complain(root, "<" + root.name + ">", "", "the root element must be <root>",
               "Write <root BTCPP_format=\"4\">");
      return {};
    }
    check_root(root);
    for (std::int32_t i = root.first_child; i >= 0; i = at(i).next_sibling)
      read_outer(static_cast<std::size_t>(i));
    if (trees_.trees.empty()) complain(root, "<root>", "", "must hold a <BehaviorTree>", "Add one");
    choose_main(root);
    for (std::size_t i = 0; i < trees_.trees.size() && !complaints_.full(); ++i) {
      define_nodes(document_, registry_, trees_, i, complaints_);
    }
    return std::move(trees_);
  }

 private:
  [[nodiscard]] const XmlElement& at(std::int32_t index) const {
    return document_[static_cast<std::size_t>(index)];
  }

  void complain(const XmlElement& element, std::string field, std::string value, std::string rule,
                std::string remedy) {
    complaints_.add({element.line}, std::move(field), std::move(value), std::move(rule), std::move(remedy));
  }

  // All attributes are among `known`.
  void check_attributes(const XmlElement& element, std::span<const std::string> known) {
    for (const XmlAttribute& attribute : element.attributes) {
      if (std::ranges::find(known, attribute.name) != known.end() || is_editor_attribute(attribute.name))
        continue;
      complaints_.add({attribute.line}, fmt::format("<{}> {}", element.name, attribute.name), attribute.value,
                      "is no attribute here", input::suggest(attribute.name, known));
    }
  }

  void check_root(const XmlElement& root) {
    static const std::array<std::string, 3> kKnown{"BTCPP_format", "main_tree_to_execute", "project_name"};
    check_attributes(root, kKnown);
    const XmlAttribute* const format = root.find("BTCPP_format");
    if (format == nullptr || input::trimmed(format->value) != "4") {
      complain(root, "<root> BTCPP_format", format != nullptr ? format->value : "", "must be \"4\"",
               "Trees of version 3 are brought to 4 by BehaviorTree.CPP's own script");
    }
  }

  void read_outer(std::size_t index) {
    const XmlElement& element = document_[index];
    if (element.name == "BehaviorTree") return add_tree(index);
    if (element.name == "TreeNodesModel") return read_models(element);
    static const std::array<std::string, 2> kKnown{"BehaviorTree", "TreeNodesModel"};
    if (element.name == "include") {
      complain(element, "<include>", "", "other files are not read", "Put their trees into this file");
    } else {
      complain(element, "<" + element.name + ">", "", "is no element of <root>",
               input::suggest(element.name, kKnown));
    }
  }

  void add_tree(std::size_t index) {
    static const std::array<std::string, 1> kKnown{"ID"};
    const XmlElement& element = document_[index];
    check_attributes(element, kKnown);
    const XmlAttribute* const id = element.find("ID");
    if (id == nullptr || input::trimmed(id->value).empty()) {
      return complain(element, "<BehaviorTree> ID", "", "must be given", "Give the tree a name");
    }
    if (find_builtin(id->value) != nullptr || registry_.find(id->value) != nullptr ||
        is_reserved_element(id->value)) {
      return complain(element, "<BehaviorTree> ID", id->value, "is the name of a node", "Choose another");
    }
    const auto [place, is_new] = trees_.by_id.emplace(id->value, trees_.trees.size());
    if (!is_new) {
      return complain(element, "<BehaviorTree> ID", id->value,
                      fmt::format("line {} has a tree of this name", trees_.trees[place->second].line),
                      "Rename one of them");
    }
    trees_.trees.push_back({id->value, element.line, index});
  }

  void choose_main(const XmlElement& root) {
    const XmlAttribute* const wanted = root.find("main_tree_to_execute");
    if (trees_.trees.empty()) return;
    if (wanted == nullptr) {
      if (trees_.trees.size() > 1) {
        complain(root, "<root> main_tree_to_execute", "", "must be given where there are several trees",
                 "Name the one that is run");
      }
      return;
    }
    const auto found = trees_.by_id.find(wanted->value);
    if (found != trees_.by_id.end()) {
      trees_.main = found->second;
      return;
    }
    complaints_.add({wanted->line}, "<root> main_tree_to_execute", wanted->value, "is no tree of this file",
                    input::suggest(wanted->value, tree_ids()));
  }

  [[nodiscard]] std::vector<std::string> tree_ids() const {
    std::vector<std::string> ids;
    for (const Definition& tree : trees_.trees) ids.push_back(tree.id);
    return ids;
  }

  void read_models(const XmlElement& models) {
    check_attributes(models, {});
    for (std::int32_t i = models.first_child; i >= 0; i = at(i).next_sibling) read_model(at(i));
  }

  void read_model(const XmlElement& model) {
    static const std::array<std::string, 5> kKinds{"Action", "Condition", "Control", "Decorator", "SubTree"};
    if (std::ranges::find(kKinds, model.name) == kKinds.end()) {
      return complain(model, "<" + model.name + ">", "", "is no kind of node",
                      input::suggest(model.name, kKinds));
    }
    const XmlAttribute* const id = model.find("ID");
    if (id == nullptr)
      return complain(model, fmt::format("<{}> ID", model.name), "", "must be given", "Name the node");
    const Registry::Leaf* const leaf = registry_.find(id->value);
    if (leaf != nullptr) {
      const bool condition = std::holds_alternative<ConditionMaker>(leaf->maker);
      const std::string_view kind = name(condition ? NodeKind::condition : NodeKind::action);
      if (model.name != kind) {
        complain(model, fmt::format("<{}> ID", model.name), id->value,
                 fmt::format("is registered as {}", kind), fmt::format("Write <{}>", kind));
      }
    }
    SubTreeModel ports;
    for (std::int32_t i = model.first_child; i >= 0; i = at(i).next_sibling)
      read_model_port(at(i), leaf, ports);
    if (model.name == "SubTree" && !trees_.models.emplace(id->value, std::move(ports)).second) {
      complain(model, "<SubTree> ID", id->value, "is described twice", "Remove one");
    }
  }

  void read_model_port(const XmlElement& element, const Registry::Leaf* leaf, SubTreeModel& model) {
    static const std::array<std::string, 3> kPorts{"input_port", "output_port", "inout_port"};
    if (is_reserved_element(element.name)) return;  // what editors keep there
    if (std::ranges::find(kPorts, element.name) == kPorts.end()) {
      return complain(element, "<" + element.name + ">", "", "is no kind of port",
                      input::suggest(element.name, kPorts));
    }
    const XmlAttribute* const port = element.find("name");
    if (port == nullptr) {
      return complain(element, fmt::format("<{}> name", element.name), "", "must be given", "Name the port");
    }
    if (leaf != nullptr) {
      std::vector<std::string> known;
      for (const PortSpec& spec : leaf->spec.ports) known.push_back(spec.name);
      if (std::ranges::find(known, port->value) == known.end()) {
        complain(element, fmt::format("<{}> name", element.name), port->value,
                 fmt::format("is no port of the registered {}", leaf->spec.id),
                 input::suggest(port->value, known));
      }
    }
    const XmlAttribute* const standard = element.find("default");
    const SubTreeModel::Port row{standard != nullptr ? standard->value : "", standard != nullptr};
    if (!model.ports.emplace(port->value, row).second) {
      complain(element, fmt::format("<{}> name", element.name), port->value, "is there twice", "Remove one");
    }
  }

  const std::vector<XmlElement>& document_;
  const Registry& registry_;
  Complaints& complaints_;
  Definitions trees_;
};

}  // namespace

std::string Definition::path(std::size_t node) const {
  std::vector<std::string_view> segments;
  for (std::int32_t i = static_cast<std::int32_t>(node); i >= 0;
       i = nodes[static_cast<std::size_t>(i)].parent) {
    segments.push_back(nodes[static_cast<std::size_t>(i)].segment);
  }
  std::string text = id;
  for (auto segment = segments.rbegin(); segment != segments.rend(); ++segment) {
    text += '/';
    text += *segment;
  }
  return text;
}

Definitions define_trees(const std::vector<XmlElement>& document, const Registry& registry,
                         Complaints& complaints) {
  return Outline(document, registry, complaints).read();
}

}  // namespace gaitway::behaviour
