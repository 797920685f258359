// Puts plug-in libraries into a configuration without editing it: each takes the place of those whose topics
// it writes.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/isolation/plugin_probe.hpp"

namespace gaitway::core {

struct AddedPlugin {
  std::string name;                       // its own, as in its descriptor
  std::filesystem::path library;          // absolute
  std::vector<std::string> replaced;      // plug-ins of the configuration that are gone
  std::vector<std::string> lost_outputs;  // topics that only those wrote
};

struct PluginExchange {
  Configuration configuration;  // the result
  std::vector<AddedPlugin> added;
  // Of each of its plug-ins; left out where the configuration names one that cannot be constructed.
  std::vector<PluginDescription> descriptions;

  // The plug-in that writes the topic; empty: none does.
  [[nodiscard]] std::string writer_of(std::string_view topic) const;
  // The plug-in that gives orders to the robot by the topics of the behaviour; empty: none does.
  [[nodiscard]] std::string behaviour() const;
};

// Throws PluginError if one of `libraries` cannot be constructed. Plug-ins of the configuration that cannot
// be are kept: who loads it gets the error with its place.
PluginExchange put_in(const Configuration& configuration, std::span<const std::filesystem::path> libraries,
                      const ProbeOptions& options);

// One line for people: what came in, and for what.
[[nodiscard]] std::string describe(const AddedPlugin& added);

}  // namespace gaitway::core
