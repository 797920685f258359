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

}  // namespace

std::string tree_nodes_model(const behaviour::Registry& registry, const behaviour::Description& used) {
  std::string text = "  <TreeNodesModel>\n";
  auto out = std::back_inserter(text);
  for (const auto& [id, leaf] : registry.leaves()) {
    if (std::ranges::none_of(used.nodes, [&id = id](const auto& node) { return node.id == id; })) continue;
    const bool is_action = std::holds_alternative<behaviour::ActionMaker>(leaf.maker);
    fmt::format_to(out, "    <{} ID=\"{}\"", is_action ? "Action" : "Condition", id);
    if (leaf.spec.ports.empty()) {
      text += "/>\n";
      continue;
    }
    text += ">\n";
    for (const behaviour::PortSpec& port : leaf.spec.ports) {
      fmt::format_to(out, "      <{0} name=\"{1}\"", element_of(port.direction), port.name);
      if (port.standard) fmt::format_to(out, " default=\"{}\"", escaped(*port.standard));
      fmt::format_to(out, ">{}</{}>\n", escaped(port.meaning), element_of(port.direction));
    }
    fmt::format_to(out, "    </{}>\n", is_action ? "Action" : "Condition");
  }
  return text + "  </TreeNodesModel>\n";
}

}  // namespace gaitway::behaviour_leaves
