// The leaves as editors of behaviour trees know them: TreeNodesModel.
#pragma once

#include <string>

#include "gaitway/behaviour/description.hpp"
#include "gaitway/behaviour/registry.hpp"

namespace gaitway::behaviour_leaves {

// The element <TreeNodesModel>, with lines indented by two spaces at least: the leaves that `used` has, in
// alphabetical order.
[[nodiscard]] std::string tree_nodes_model(const behaviour::Registry& registry,
                                           const behaviour::Description& used);
// The same of all leaves, and of the nodes that are built in but that BehaviorTree.CPP does not know.
[[nodiscard]] std::string tree_nodes_model(const behaviour::Registry& registry);

}  // namespace gaitway::behaviour_leaves
