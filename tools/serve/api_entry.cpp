// One entry, and its parameter.
#include "tools/serve/api_entry.hpp"

#include <algorithm>
#include <utility>

#include "gaitway/process/installation.hpp"

namespace gaitway::tools {

core::PluginEntry& api_of(core::Configuration& configuration) {
  const auto keeps_link = [](const core::PluginEntry& entry) { return entry.child.local_sockets; };
  const auto api = std::ranges::find_if(configuration.plugins, keeps_link);
  if (api != configuration.plugins.end()) return *api;
  core::Configuration shipped = core::read_configuration(process::config_directory() / "serve.yaml");
  core::PluginEntry added = std::move(*std::ranges::find_if(shipped.plugins, keeps_link));
  added.line = 0;  // in no file of whoever gave this one
  return configuration.plugins.emplace_back(std::move(added));
}

void set_link(core::PluginEntry& api, const std::string& link) {
  std::erase_if(api.parameters, [](const core::ParameterEntry& entry) { return entry.name == "link"; });
  api.parameters.push_back({"link", link, api.line});
}

}  // namespace gaitway::tools
