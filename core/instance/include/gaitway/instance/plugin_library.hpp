// A plug-in's shared library: found on the search path, opened, and checked before anything in it is called.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/plugin/abi.h"
#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::core {

using SearchPath = std::vector<std::filesystem::path>;

// `given`, then the folders of the environment variable GAITWAY_PLUGIN_PATH (colons between them), then the
// folder of the shipped plug-ins; each once.
[[nodiscard]] SearchPath plugin_search_path(const SearchPath& given);

// The file of a plug-in: a name that is looked for on `path`, or a path (with a slash), relative to `base`.
// Throws PluginError: no such file (with all places tried).
[[nodiscard]] std::filesystem::path find_plugin_file(const std::string& library,
                                                     const std::filesystem::path& base,
                                                     const SearchPath& path);

// Two builds that disagree on the border must not call each other: throws PluginError unless a host that
// speaks this minor number of the ABI can load the plug-in. `file` is for the message.
void check_border(const gaitway_plugin& entry, const std::filesystem::path& file,
                  std::uint32_t minor = GAITWAY_PLUGIN_ABI_MINOR);

// A shared library's private copy in memory, for as long as it lives: whoever overwrites or truncates the
// file afterwards harms nobody, and nobody writes the copy. Two copies of one file are two libraries to the
// loader.
class LibraryCopy {
 public:
  // Reads the file and checks its ELF header. Throws PluginError: not readable, no shared library, one for
  // another machine.
  explicit LibraryCopy(const std::filesystem::path& file);

  // What dlopen() takes.
  [[nodiscard]] std::string path() const;

 private:
  process::FileDescriptor memory_;
};

// Keeps the library open for its life. Movable. What is loaded is a private copy; a library that looks for
// others relative to itself ($ORIGIN) does not find them.
class PluginLibrary {
 public:
  // Found as find_plugin_file() does. Throws PluginError: no such file, no shared library for this machine, a
  // symbol that is missing, no entry symbol, another ABI or struct size.
  PluginLibrary(const std::string& library, const std::filesystem::path& base, const SearchPath& path);

  [[nodiscard]] const gaitway_plugin& entry() const noexcept { return *entry_; }
  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }

 private:
  struct Close {
    void operator()(void* handle) const noexcept;
  };

  std::filesystem::path file_;
  LibraryCopy copy_;
  std::unique_ptr<void, Close> handle_;
  const gaitway_plugin* entry_ = nullptr;
};

}  // namespace gaitway::core
