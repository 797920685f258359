// From a running tree to another description of it: which node is which, and whether nothing is lost.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "node_array.hpp"

namespace gaitway::behaviour {

// What two descriptions have in common.
struct Counterparts {
  std::uint64_t running = 0;          // NodeArray::id() of the tree that goes on
  std::vector<NodeIndex> nodes;       // of each new node, the old one
  std::vector<NodeIndex> kept;        // of each old node, the new one
  std::vector<std::int64_t> entries;  // of each new entry, the old one; -1: none
};

// Nodes are the same when their paths and types are; entries, when their keys and places are.
[[nodiscard]] Counterparts compare(const NodeArray& running, const NodeArray& next);

// Whether all that goes on in `running` has its place in `next`. With `reasons`, goes through everything and
// adds why it has not; without, asks for no memory.
bool can_carry_over(const NodeArray& running, const NodeArray& next, const Counterparts& counterparts,
                    std::vector<std::string>* reasons);

}  // namespace gaitway::behaviour
