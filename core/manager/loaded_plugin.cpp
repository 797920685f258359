// Calls over the border, and what happens when they fail.
#include "gaitway/manager/loaded_plugin.hpp"

#include <fmt/format.h>

#include "gaitway/plugin/detail/plugin_border.hpp"
#include "host_functions.hpp"

namespace gaitway::core {
namespace {

// Errors of loading get the plug-in's name and place in front.
PluginLibrary load(const PluginEntry& entry, const PluginSource& source, const std::string& place) {
  try {
    return PluginLibrary(entry.library, source.configuration_file.parent_path(), source.search_path);
  } catch (const PluginError& error) {
    throw PluginError(fmt::format("{}: {}", place, error.what()));
  }
}

}  // namespace

LoadedPlugin::LoadedPlugin(const PluginEntry& entry, const PluginSource& source, EventLog& events)
    : ManagedPlugin(entry, source.configuration_file, events),
      robot_directory_(source.robot_directory.string()),
      memory_socket_(source.memory_socket.string()),
      library_(load(entry, source, place_)),
      host_(HostFunctions::table(*this)) {
  construct();
  try {
    parameters_.require_all_declared();
  } catch (...) {
    instance_.destroy(instance_.context);
    throw;
  }
}

void LoadedPlugin::construct() {
  const gaitway_text text = error_text();
  const gaitway_status status = library_.entry().create(&host_, &instance_, &text);
  phase_ = Phase::idle;
  if (status != GAITWAY_OK) {
    instance_ = {};
    if (parameter_error_ && std::string_view(parameter_error_->what()) == fault()) {
      throw ConfigurationError(*parameter_error_);
    }
    fail("its constructor failed");
  }
  const bool complete = instance_.activate != nullptr && instance_.step != nullptr &&
                        instance_.deactivate != nullptr && instance_.destroy != nullptr;
  if (!complete) {
    if (instance_.destroy != nullptr) {
      instance_.destroy(instance_.context);
    }
    throw PluginError(fmt::format(
        "{}: create left out one of activate, step, deactivate and destroy. Fill in all four", place_));
  }
}

LoadedPlugin::~LoadedPlugin() {
  LoadedPlugin::deactivate();
  instance_.destroy(instance_.context);
}

void LoadedPlugin::activate() {
  take_snapshots();
  const gaitway_text text = error_text();
  if (instance_.activate(instance_.context, &text) != GAITWAY_OK) {
    fail("activation failed");
  }
  phase_ = Phase::active;
}

void LoadedPlugin::deactivate() noexcept {
  if (phase_ != Phase::active) {
    return;
  }
  phase_ = Phase::idle;
  const gaitway_text text = error_text();
  if (instance_.deactivate(instance_.context, &text) != GAITWAY_OK) {
    events_.post(EventKind::error, name_, fault());
  }
}

bool LoadedPlugin::run(const Tick& tick) noexcept {
  const gaitway_tick plain{.now_ns = tick.now_ns,
                           .batch_start_ns = tick.batch_start_ns,
                           .batch_sequence = tick.batch_sequence,
                           .tick = tick.tick,
                           .batch = tick.batch ? 1U : 0U,
                           .reserved = 0};
  const gaitway_text text = error_text();
  phase_ = Phase::stepping;
  const gaitway_status status = instance_.step(instance_.context, &plain, &text);
  phase_ = Phase::active;
  if (status != GAITWAY_OK && fault().empty()) {
    fmt::format_to_n(text.data, text.capacity - 1, "step answered {} without a text", status).out[0] = '\0';
  }
  return status == GAITWAY_OK;
}

bool LoadedPlugin::save_state(PluginState& state) noexcept {
  state.size = 0;
  state.version = 0;
  const gaitway_state_functions* const functions = detail::state_functions(instance_);
  if (functions == nullptr) {
    return true;
  }
  gaitway_state plain{state.bytes.data(), PluginState::kCapacity, 0, 0, 0};
  const gaitway_text text = error_text();
  if (functions->save_state(instance_.context, &plain, &text) != GAITWAY_OK) {
    return false;
  }
  if (plain.size > PluginState::kCapacity) {
    set_fault("save_state claims more bytes than there is room for");
    return false;
  }
  state.size = plain.size;
  state.version = plain.version;
  return true;
}

bool LoadedPlugin::restore_state(const PluginState& state) noexcept {
  const gaitway_text text = error_text();
  if (state.version == 0) {
    return true;  // nothing was handed on
  }
  const gaitway_state_functions* const functions = detail::state_functions(instance_);
  if (functions == nullptr) {
    set_fault("takes no state over, but its predecessor hands some on");
    return false;
  }
  const gaitway_state plain{const_cast<std::byte*>(state.bytes.data()), PluginState::kCapacity, state.size,
                            state.version, 0};
  return functions->restore_state(instance_.context, &plain, &text) == GAITWAY_OK;
}

bool LoadedPlugin::set_parameter(const char* name, const gaitway_value& value) noexcept {
  const gaitway_text text = error_text();
  if (instance_.set_parameter == nullptr) {
    set_fault("changes no parameter while it runs");
    return false;
  }
  return instance_.set_parameter(instance_.context, name, &value, &text) == GAITWAY_OK;
}

}  // namespace gaitway::core
