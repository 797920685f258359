// One more entry.
#include "tools/run/navigation_option.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace gaitway::tools {

void add_navigation(core::Configuration& configuration, const std::optional<world::World>& world) {
  if (std::ranges::any_of(configuration.plugins,
                          [](const auto& entry) { return entry.name == kNavigationName; })) {
    return;
  }
  core::PluginEntry entry;
  entry.name = kNavigationName;
  entry.library = "libgaitway_plugin_navigation.so";
  entry.parameters.push_back({"plans_in_step", "true", 0});
  // A robot with eyes maps what it sees, in its odometry, which a fall moves against any map that it was
  // given.
  const bool sees = std::ranges::any_of(configuration.plugins,
                                        [](const auto& plugin) { return plugin.name == kVisionName; });
  if (world && !sees) {
    entry.parameters.push_back({"world", world->file.string(), 0});
    if (world->random_seed)
      entry.parameters.push_back({"world_seed", std::to_string(*world->random_seed), 0});
  }
  configuration.plugins.push_back(std::move(entry));
}

}  // namespace gaitway::tools
