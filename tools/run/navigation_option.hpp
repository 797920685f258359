// The plug-in `navigation` of a simulated robot, which has the world as its map, or what its own eyes see.
#pragma once

#include <optional>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/world/world.hpp"

namespace gaitway::tools {

inline constexpr const char* kNavigationName = "navigation";
inline constexpr const char* kVisionName = "vision";

// Puts it in, if the configuration has none of that name. It plans in its steps: the same in each run.
void add_navigation(core::Configuration& configuration, const std::optional<world::World>& world);

}  // namespace gaitway::tools
