// A plug-in in this process: its library is loaded, its calls go straight over the C ABI.
#pragma once

#include <filesystem>
#include <memory>

#include "gaitway/manager/managed_plugin.hpp"
#include "gaitway/manager/plugin_library.hpp"

namespace gaitway::core {

struct PluginSource {  // what is needed to load plug-ins
  const std::filesystem::path& configuration_file;
  const std::filesystem::path& robot_directory;
  const SearchPath& search_path;
  std::filesystem::path memory_socket = {};  // empty: there is none
};

class LoadedPlugin final : public ManagedPlugin {
 public:
  // Loads the library and constructs the plug-in. `events` outlives it.
  LoadedPlugin(const PluginEntry& entry, const PluginSource& source, EventLog& events);
  ~LoadedPlugin() override;

  void activate() override;
  void deactivate() noexcept override;
  bool save_state(PluginState& state) noexcept override;
  bool restore_state(const PluginState& state) noexcept override;
  bool set_parameter(const char* name, const gaitway_value& value) noexcept override;

  [[nodiscard]] const PluginLibrary& library() const noexcept { return library_; }
  [[nodiscard]] std::string_view version() const noexcept override { return library_.entry().version; }

 private:
  class Border;

  bool run(const Tick& tick) noexcept override;

  std::string robot_directory_, memory_socket_;
  PluginLibrary library_;
  std::unique_ptr<Border> border_;
  bool active_ = false;
};

}  // namespace gaitway::core
