// TreeNodesModel out of a registry.
#include "gaitway/behaviour_leaves/node_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <variant>

namespace gaitway::behaviour_leaves {
namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += c;
    }
  }
  return out;
}

const char* element_of(behaviour::PortDirection direction) {
  switch (direction) {
    case behaviour::PortDirection::input:
      return "input_port";
    case behaviour::PortDirection::output:
      return "output_port";
    case behaviour::PortDirection::inout:
      return "inout_port";
  }
  return "";
}

void append_leaf(std::string& text, const std::string& id, const behaviour::Registry::Leaf& leaf) {
  auto out = std::back_inserter(text);
  const bool is_action = std::holds_alternative<behaviour::ActionMaker>(leaf.maker);
  fmt::format_to(out, "    <{} ID=\"{}\"", is_action ? "Action" : "Condition", id);
  if (leaf.spec.ports.empty()) {
    text += "/>\n";
    return;
  }
  text += ">\n";
  for (const behaviour::PortSpec& port : leaf.spec.ports) {
    fmt::format_to(out, "      <{0} name=\"{1}\"", element_of(port.direction), port.name);
    if (port.standard) fmt::format_to(out, " default=\"{}\"", escaped(*port.standard));
    fmt::format_to(out, ">{}</{}>\n", escaped(port.meaning), element_of(port.direction));
  }
  fmt::format_to(out, "    </{}>\n", is_action ? "Action" : "Condition");
}

}  // namespace

std::string tree_nodes_model(const behaviour::Registry& registry, const behaviour::Description& used) {
  std::string text = "  <TreeNodesModel>\n";
  for (const auto& [id, leaf] : registry.leaves()) {
    if (std::ranges::any_of(used.nodes, [&id = id](const auto& node) { return node.id == id; }))
      append_leaf(text, id, leaf);
  }
  return text + "  </TreeNodesModel>\n";
}

std::string tree_nodes_model(const behaviour::Registry& registry) {
  std::string text = "  <TreeNodesModel>\n";
  for (const auto& [id, leaf] : registry.leaves()) append_leaf(text, id, leaf);
  return text +
         "    <Decorator ID=\"Cooldown\">\n"
         "      <input_port name=\"msec\">fails without a visit to its child until that time has gone since "
         "the "
         "child's last result</input_port>\n"
         "    </Decorator>\n"
         "  </TreeNodesModel>\n";
}

}  // namespace gaitway::behaviour_leaves
