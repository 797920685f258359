// Trees that are deeper than a file's elements may be: chains of sub-trees.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace gaitway::behaviour::test {

// A file whose main tree T is a chain of so many nodes: inverters, a SubTree after every 49 of them, and
// `leaf` as the last.
inline std::string deep_file(std::size_t nodes, const std::string& leaf) {
  constexpr std::size_t kOfOneTree = 50;
  std::string trees;
  for (std::size_t made = 0, number = 0; made < nodes; ++number) {
    const std::size_t part = std::min(kOfOneTree, nodes - made);
    const bool last = made + part == nodes;
    trees += number == 0 ? "<BehaviorTree ID=\"T\">" : fmt::format("<BehaviorTree ID=\"T{}\">", number);
    for (std::size_t i = 1; i < part; ++i) trees += "<Inverter>";
    trees += last ? leaf : fmt::format("<SubTree ID=\"T{}\"/>", number + 1);
    for (std::size_t i = 1; i < part; ++i) trees += "</Inverter>";
    trees += "</BehaviorTree>";
    made += part;
  }
  return "<root BTCPP_format=\"4\" main_tree_to_execute=\"T\">" + trees + "</root>";
}

}  // namespace gaitway::behaviour::test
