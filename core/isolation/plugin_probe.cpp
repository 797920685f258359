// An isolated plug-in that is constructed, described and destroyed.
#include "gaitway/isolation/plugin_probe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "isolated_plugin.hpp"

namespace gaitway::core {

bool PluginDescription::writes(std::string_view topic) const noexcept {
  return std::ranges::any_of(topics, [topic](const TopicUse& other) {
    return other.access == Access::write && other.topic == topic;
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
  const LibraryDescription& library = plugin.library();
  const auto& parameters = plugin.parameters().declared();
  PluginDescription description{.file = library.file,
                                .name = library.name,
                                .version = library.version,
                                .text = library.text,
                                .period = plugin.period(),
                                .topics = plugin.node().uses,
                                .parameters = {parameters.begin(), parameters.end()}};
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
