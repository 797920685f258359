// dlopen with checks.
#include "gaitway/manager/plugin_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "gaitway/process/installation.hpp"
#include "library_copy.hpp"

namespace gaitway::core {
namespace {

constexpr const char* kEntrySymbol = "gaitway_plugin_entry";

std::filesystem::path find_library(const std::string& library, const std::filesystem::path& base,
                                   const SearchPath& path) {
  SearchPath places;
  if (library.find('/') != std::string::npos) {
    places.push_back(base / library);
  } else {
    for (const std::filesystem::path& folder : path) {
      places.push_back(folder / library);
    }
  }
  std::string tried;
  for (const std::filesystem::path& place : places) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(place, ignored)) {
      return place;
    }
    tried += (tried.empty() ? "" : ", ") + place.string();
  }
  throw PluginError(
      fmt::format("no library '{}'; tried {}. Build it, or put its folder into GAITWAY_PLUGIN_PATH", library,
                  tried.empty() ? "nowhere: the search path is empty" : tried));
}

}  // namespace

void check_border(const gaitway_plugin& entry, const std::filesystem::path& file, std::uint32_t minor) {
  constexpr std::string_view kRemedy = "Build the plug-in anew against this version's headers";
  if (entry.magic != GAITWAY_PLUGIN_MAGIC) {
    throw PluginError(
        fmt::format("{}: '{}' is no plug-in descriptor (magic {:#010x} instead of {:#010x}). {}",
                    file.string(), kEntrySymbol, entry.magic, GAITWAY_PLUGIN_MAGIC, kRemedy));
  }
  if (entry.abi != GAITWAY_PLUGIN_ABI) {
    throw PluginError(
        fmt::format("{}: built for plug-in ABI {}, but this main controller speaks ABI {}.{}. {}",
                    file.string(), entry.abi, GAITWAY_PLUGIN_ABI, minor, kRemedy));
  }
  if (entry.abi_minor > minor) {
    throw PluginError(
        fmt::format("{}: built for plug-in ABI {}.{}, but this main controller speaks ABI {}.{}. Build it "
                    "against older headers, or take a newer main controller",
                    file.string(), entry.abi, entry.abi_minor, GAITWAY_PLUGIN_ABI, minor));
  }
  struct Size {
    std::string_view type;
    std::uint32_t theirs;
    std::size_t first, ours;  // as minor number 0 has it, and as we have it
  };
  const std::array sizes{Size{"gaitway_plugin", entry.plugin_size, 80, sizeof(gaitway_plugin)},
                         Size{"gaitway_host", entry.host_size, 72, sizeof(gaitway_host)},
                         Size{"gaitway_instance", entry.instance_size, 56, sizeof(gaitway_instance)},
                         Size{"gaitway_tick", entry.tick_size, 32, sizeof(gaitway_tick)},
                         Size{"gaitway_topic", entry.topic_size, 40, sizeof(gaitway_topic)},
                         Size{"gaitway_float_field", entry.float_field_size, 40, sizeof(gaitway_float_field)},
                         Size{"gaitway_sample", entry.sample_size, 16, sizeof(gaitway_sample)},
                         Size{"gaitway_parameter", entry.parameter_size, 80, sizeof(gaitway_parameter)},
                         Size{"gaitway_value", entry.value_size, 32, sizeof(gaitway_value)}};
  for (const Size& size : sizes) {
    if (size.theirs < size.first || size.theirs > size.ours) {
      throw PluginError(fmt::format("{}: its {} has {} bytes, this main controller's {}. {}", file.string(),
                                    size.type, size.theirs, size.ours, kRemedy));
    }
  }
  if (entry.name == nullptr || entry.version == nullptr || entry.description == nullptr ||
      entry.create == nullptr) {
    throw PluginError(fmt::format(
        "{}: its descriptor lacks name, version, description or create. Fill them in", file.string()));
  }
}

namespace {

// What the loader says, with the library's own name instead of its copy's.
std::string loader_error(const std::string& copy, const std::filesystem::path& file) {
  std::string text = dlerror();
  for (std::size_t at = text.find(copy); at != std::string::npos; at = text.find(copy)) {
    text.replace(at, copy.size(), file.filename().string());
  }
  return text;
}

}  // namespace

SearchPath plugin_search_path(const SearchPath& given) {
  SearchPath path;
  const auto add = [&path](const std::filesystem::path& folder) {
    if (!folder.empty() && std::find(path.begin(), path.end(), folder) == path.end()) {
      path.push_back(folder);
    }
  };
  std::for_each(given.begin(), given.end(), add);
  if (const char* const variable = std::getenv("GAITWAY_PLUGIN_PATH")) {
    std::string_view rest = variable;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(':'), rest.size());
      add(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  add(process::shipped_plugin_directory());
  return path;
}

PluginLibrary::PluginLibrary(const std::string& library, const std::filesystem::path& base,
                             const SearchPath& path)
    : file_(find_library(library, base, path)) {
  copy_ = std::make_unique<LibraryCopy>(file_);
  handle_ = dlopen(copy_->path().c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ == nullptr) {
    throw PluginError(fmt::format("{} cannot be loaded: {}. Is all that it links to installed?",
                                  file_.string(), loader_error(copy_->path(), file_)));
  }
  try {
    entry_ = static_cast<const gaitway_plugin*>(dlsym(handle_, kEntrySymbol));
    if (entry_ == nullptr) {
      throw PluginError(
          fmt::format("{}: has no symbol '{}'. A plug-in ends in GAITWAY_PLUGIN(Class, name, version, "
                      "description) and is built with gaitway_plugin()",
                      file_.string(), kEntrySymbol));
    }
    check_border(*entry_, file_);
  } catch (...) {
    dlclose(handle_);
    throw;
  }
}

PluginLibrary::PluginLibrary(PluginLibrary&& other) noexcept
    : file_(std::move(other.file_)),
      copy_(std::move(other.copy_)),
      handle_(std::exchange(other.handle_, nullptr)),
      entry_(std::exchange(other.entry_, nullptr)) {}

PluginLibrary::~PluginLibrary() {
  if (handle_ != nullptr) {
    dlclose(handle_);
  }
}

}  // namespace gaitway::core
