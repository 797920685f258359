// One more entry, or one more parameter.
#include "tools/run/mission_option.hpp"

#include <algorithm>

namespace gaitway::tools {

void set_mission(core::Configuration& configuration, const std::string& mission) {
  auto entry = std::ranges::find_if(configuration.plugins,
                                    [](const auto& plugin) { return plugin.name == kBehaviourName; });
  if (entry == configuration.plugins.end()) {
    core::PluginEntry added;
    added.name = kBehaviourName;
    added.library = "libgaitway_plugin_behaviour.so";
    added.parameters.push_back({"loads_in_step", "true", 0});
    configuration.plugins.push_back(std::move(added));
    entry = std::prev(configuration.plugins.end());
  }
  std::erase_if(entry->parameters, [](const auto& parameter) { return parameter.name == "mission"; });
  if (mission != kNoMission) entry->parameters.push_back({"mission", mission, entry->line});
}

}  // namespace gaitway::tools
