// An isolated plug-in that is constructed, described and destroyed.
#include "gaitway/isolation/plugin_probe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "isolated_plugin.hpp"

namespace gaitway::core {
namespace {

PluginDescription describe(const IsolatedPlugin& plugin) {
  const LibraryDescription& library = plugin.library();
  PluginDescription description{.file = library.file,
                                .name = library.name,
                                .version = library.version,
                                .text = library.text,
                                .every_tick = plugin.period() == Period::tick,
                                .topics = {},
                                .parameters = {}};
  for (const TopicUse& use : plugin.node().uses) {
    description.topics.push_back({use.topic, use.type_name, use.access});
  }
  for (const Parameter& parameter : plugin.parameters().declared()) {
    description.parameters.push_back({.name = parameter.name,
                                      .kind = std::string(parameter_kind_name(parameter.kind)),
                                      .unit = parameter.unit,
                                      .fallback = parameter.fallback,
                                      .doc = parameter.doc,
                                      .lowest = parameter.lowest,
                                      .highest = parameter.highest,
                                      .live = parameter.live});
  }
  return description;
}

}  // namespace

bool PluginDescription::writes(std::string_view topic) const noexcept {
  return std::any_of(topics.begin(), topics.end(), [topic](const DescribedTopic& other) {
    return other.access == Access::write && other.name == topic;
  });
}

PluginDescription probe_plugin(const PluginEntry& entry, const std::filesystem::path& configuration,
                               const ProbeOptions& options) {
  PluginEntry without_bounds = entry;
  without_bounds.child = {};
  IsolationOptions isolation;
  isolation.memory_limit_bytes = 0;
  isolation.start_limit_ns = std::chrono::nanoseconds(options.patience).count();
  EventLog unheard;
  IsolatedPlugin plugin(without_bounds, {configuration, options.robot_directory, options.plugin_path},
                        isolation, unheard);
  PluginDescription description = describe(plugin);
  if (!plugin.end()) {
    throw PluginError(fmt::format("{}: {}. Run it in a debugger", plugin.place(), plugin.fault()));
  }
  return description;
}

PluginDescription probe_plugin(const std::filesystem::path& library, const ProbeOptions& options) {
  const std::filesystem::path file = std::filesystem::absolute(library);
  return probe_plugin({.name = file.filename().string(), .library = file.string()}, file, options);
}

bool is_plugin_library(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  return bytes.starts_with(
             "\x7f"
             "ELF") &&
         bytes.find(std::string("\0gaitway_plugin_entry\0", 22)) != std::string::npos;
}

}  // namespace gaitway::core
