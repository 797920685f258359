// A plug-in's shared library: found on the search path, opened, and checked before anything in it is called.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/core/plugin_abi.h"
#include "gaitway/core/plugin_error.hpp"

namespace gaitway::core {

using SearchPath = std::vector<std::filesystem::path>;

// `given`, then the folders of the environment variable GAITWAY_PLUGIN_PATH (colons between them), then the
// folder ../lib beside the running executable; each once.
[[nodiscard]] SearchPath plugin_search_path(const SearchPath& given);

// Keeps the library open for its life. Movable.
class PluginLibrary {
 public:
  // `library`: a file name that is looked for on `path`, or a path (with a slash), relative to `base`. Throws
  // PluginError: no such file (with all places tried), not loadable, no entry symbol, another ABI or struct
  // size.
  PluginLibrary(const std::string& library, const std::filesystem::path& base, const SearchPath& path);
  ~PluginLibrary();
  PluginLibrary(PluginLibrary&& other) noexcept
      : file_(std::move(other.file_)),
        handle_(std::exchange(other.handle_, nullptr)),
        entry_(std::exchange(other.entry_, nullptr)) {}
  PluginLibrary& operator=(PluginLibrary&&) = delete;

  [[nodiscard]] const gaitway_plugin& entry() const noexcept { return *entry_; }
  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }

 private:
  std::filesystem::path file_;
  void* handle_ = nullptr;
  const gaitway_plugin* entry_ = nullptr;
};

}  // namespace gaitway::core
