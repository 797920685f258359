// The table of leaves in docs/behaviour.md, out of the registry.
#pragma once

#include <iterator>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "gaitway/behaviour/registry.hpp"

namespace gaitway::behaviour_leaves {

inline std::string leaf_table(const behaviour::Registry& registry, bool conditions) {
  std::string text = "| leaf | ports | |\n|---|---|---|\n";
  for (const auto& [id, leaf] : registry.leaves()) {
    if (std::holds_alternative<behaviour::ConditionMaker>(leaf.maker) != conditions) continue;
    std::string ports;
    for (const behaviour::PortSpec& port : leaf.spec.ports) {
      if (!ports.empty()) ports += "<br>";
      fmt::format_to(std::back_inserter(ports), "`{}`", port.name);
      if (port.standard) fmt::format_to(std::back_inserter(ports), " = {}", *port.standard);
      const std::string type = behaviour::describe(port.type);
      fmt::format_to(std::back_inserter(ports), " ({}{}): {}",
                     port.direction == behaviour::PortDirection::output ? "written; " : "", type,
                     port.meaning);
    }
    fmt::format_to(std::back_inserter(text), "| `{}` | {} | {} |\n", id, ports, leaf.spec.meaning);
  }
  return text;
}

}  // namespace gaitway::behaviour_leaves
