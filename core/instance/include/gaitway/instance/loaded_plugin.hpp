// A plug-in in this process: its library is loaded, its calls go straight over the C ABI.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "gaitway/instance/managed_plugin.hpp"
#include "gaitway/instance/plugin_library.hpp"

namespace gaitway::core {

struct PluginSource {  // what is needed to load plug-ins
  const std::filesystem::path& configuration_file;
  const std::filesystem::path& robot_directory;
  const SearchPath& search_path;
  std::filesystem::path memory_socket = {};  // empty: there is none
};

class LoadedPlugin final : public ManagedPlugin, private PluginSurroundings {
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
  bool run(const Tick& tick) noexcept override;

  // What the plug-in is offered.
  [[nodiscard]] const char* robot_directory() const noexcept override { return robot_directory_.c_str(); }
  [[nodiscard]] const char* memory_socket() const noexcept override { return memory_socket_.c_str(); }
  gaitway_status read(gaitway_port& port, void* value, gaitway_sample& sample) noexcept override {
    return reinterpret_cast<TopicPort&>(port).read(value, sample);
  }
  gaitway_status publish(gaitway_port& port, const void* value) noexcept override {
    return reinterpret_cast<TopicPort&>(port).stage(value);
  }

  std::string robot_directory_, memory_socket_;
  PluginLibrary library_;
  PluginInstance instance_{*this, *this};
  bool active_ = false;
};

}  // namespace gaitway::core
