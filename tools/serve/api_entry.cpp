// One entry, and its parameter.
#include "tools/serve/api_entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace gaitway::tools {

core::PluginEntry& api_of(core::Configuration& configuration) {
  const auto api = std::ranges::find_if(
      configuration.plugins, [](const core::PluginEntry& entry) { return entry.child.local_sockets; });
  if (api == configuration.plugins.end()) {
    throw std::invalid_argument(fmt::format(
        "--config {}: has no plug-in that keeps a link to the user interface module. Add `api` with "
        "`isolation: process` and `sockets: local`, as the shipped serve.yaml does",
        configuration.file.string()));
  }
  return *api;
}

void set_link(core::PluginEntry& api, const std::string& link) {
  std::erase_if(api.parameters, [](const core::ParameterEntry& entry) { return entry.name == "link"; });
  api.parameters.push_back({"link", link, api.line});
}

}  // namespace gaitway::tools
