// A behaviour tree as a picture.
#pragma once

#include <span>
#include <string>

#include "gaitway/behaviour/description.hpp"

namespace gaitway::behaviour {

// A standing-alone SVG, root at the left. With statuses (as of Tree::statuses()), nodes have their colours;
// throws std::invalid_argument when these are not as many as the nodes.
[[nodiscard]] std::string draw(const Description& description, std::span<const NodeStatus> statuses = {});

}  // namespace gaitway::behaviour
