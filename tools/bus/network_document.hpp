// docs/network.md: how the network works, and every message down to the bit, for whoever builds a robot or a
// tool for it.
#pragma once

#include <string>

#include "tools/bus/network_description.hpp"

namespace gaitway::tools {

// Markdown; deterministic. `full` and `paper`: the same robot in both profiles.
[[nodiscard]] std::string network_document(const urdf::RobotModel& robot, const NetworkDescription& full,
                                           const NetworkDescription& paper);

}  // namespace gaitway::tools
