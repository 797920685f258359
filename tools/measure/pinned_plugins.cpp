// Copies libraries.
#include "tools/measure/pinned_plugins.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/measure/content_hash.hpp"

namespace gaitway::tools {

void pin_plugins(core::Configuration& plugins, const core::SearchPath& plugin_path,
                 const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (core::PluginEntry& plugin : plugins.plugins) {
    const std::filesystem::path original =
        core::PluginLibrary(plugin.library, plugins.file.parent_path(), core::plugin_search_path(plugin_path))
            .file();
    const std::filesystem::path draft = folder / fmt::format("draft_{}", getpid());
    std::filesystem::copy_file(original, draft, std::filesystem::copy_options::overwrite_existing);
    ContentHash hash;
    hash.add_file(draft);  // of the copy: the original may change at any instant
    const std::filesystem::path pinned =
        folder / fmt::format("{}_{:016x}.so", original.stem().string(), hash.value());
    std::filesystem::rename(draft, pinned);
    plugin.library = std::filesystem::absolute(pinned).string();
  }
}

void remove_other_plugins(const core::Configuration& plugins, const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> others;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string file = std::filesystem::absolute(entry.path()).string();
    if (std::none_of(plugins.plugins.begin(), plugins.plugins.end(),
                     [&file](const core::PluginEntry& plugin) { return plugin.library == file; })) {
      others.push_back(entry.path());
    }
  }
  for (const std::filesystem::path& other : others) {
    std::filesystem::remove(other);
  }
}

}  // namespace gaitway::tools
