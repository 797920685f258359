// What each type of node does when it is visited, and when a child has answered.
#pragma once

#include "node_array.hpp"

namespace gaitway::behaviour {

// Visit a child, or say this to the parent.
struct Step {
  NodeIndex child = kNoNode;
  NodeStatus result = NodeStatus::idle;
};

// The node is visited: begins, or goes on.
[[nodiscard]] Step enter(NodeArray& nodes, NodeIndex node) noexcept;
// Its child has answered: running, success, failure or skipped.
[[nodiscard]] Step after(NodeArray& nodes, NodeIndex node, NodeIndex child, NodeStatus answer) noexcept;

}  // namespace gaitway::behaviour
