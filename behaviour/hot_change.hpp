// From a running tree to another description of it: which node is which, and whether nothing is lost.
#pragma once

#include "gaitway/behaviour/tree.hpp"
#include "node_array.hpp"

namespace gaitway::behaviour {

// Brings state, leaves and values of `running` into `next`, which is new. Refused, with the reasons: neither
// is changed. Throws as NodeArray::make_leaves(); then `running` is as it was.
[[nodiscard]] Change carry_over(NodeArray& running, NodeArray& next, const Registry& registry);

}  // namespace gaitway::behaviour
