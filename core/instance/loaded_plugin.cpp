// Calls of a plug-in in this process, and what happens when they fail.
#include "gaitway/instance/loaded_plugin.hpp"

#include <fmt/format.h>

namespace gaitway::core {
namespace {

// Errors of loading get the plug-in's name and place in front.
template <class Function>
auto at_place(const std::string& place, const Function& function) {
  try {
    return function();
  } catch (const PluginError& error) {
    throw PluginError(fmt::format("{}: {}", place, error.what()));
  }
}

}  // namespace

LoadedPlugin::LoadedPlugin(const PluginEntry& entry, const PluginSource& source, EventLog& events)
    : ManagedPlugin(entry, source.configuration_file, events, source.robot_directory),
      robot_directory_(source.robot_directory.string()),
      memory_socket_(source.memory_socket.string()),
      library_(at_place(place_, [&] {
        return PluginLibrary(entry.library, source.configuration_file.parent_path(), source.search_path);
      })) {
  at_place(place_, [this] {
    if (instance_.create(library_.entry(), error_text()) != GAITWAY_OK) {
      fail_construction(fault());
    }
  });
  parameters_.require_all_declared();
}

LoadedPlugin::~LoadedPlugin() {
  LoadedPlugin::deactivate();
}

void LoadedPlugin::activate() {
  take_snapshots();
  if (instance_.activate(error_text()) != GAITWAY_OK) {
    fail("activation failed");
  }
  active_ = true;
}

void LoadedPlugin::deactivate() noexcept {
  if (std::exchange(active_, false) && instance_.deactivate(error_text()) != GAITWAY_OK) {
    events_.post(EventKind::error, name_, fault());
  }
}

bool LoadedPlugin::run(const Tick& tick) noexcept {
  return instance_.step(abi_tick(tick), error_text()) == GAITWAY_OK;
}

bool LoadedPlugin::save_state(PluginState& state) noexcept {
  gaitway_state plain{state.bytes.data(), PluginState::kCapacity, 0, 0, 0};
  const gaitway_status status = instance_.save_state(plain, error_text());
  state.size = plain.size;
  state.version = plain.version;
  return status == GAITWAY_OK;
}

bool LoadedPlugin::restore_state(const PluginState& state) noexcept {
  const gaitway_text text = error_text();
  if (state.version == 0) {
    return true;  // nothing was handed on
  }
  return instance_.restore_state({const_cast<std::byte*>(state.bytes.data()), PluginState::kCapacity,
                                  state.size, state.version, 0},
                                 text) == GAITWAY_OK;
}

bool LoadedPlugin::set_parameter(const char* name, const gaitway_value& value) noexcept {
  return instance_.set_parameter(name, value, error_text()) == GAITWAY_OK;
}

}  // namespace gaitway::core
