// What a plug-in in this process is offered, and what happens when its calls fail.
#include "gaitway/manager/loaded_plugin.hpp"

#include <fmt/format.h>

#include "plugin_instance.hpp"

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

// What stands behind the C ABI: the plug-in's own ports, parameters and events.
class LoadedPlugin::Border final : public PluginDeclarations, public PluginSurroundings {
 public:
  explicit Border(LoadedPlugin& plugin) noexcept : plugin_(plugin) {}

  gaitway_port* open_topic(const gaitway_topic& topic, gaitway_access access) override {
    plugin_.declare_topic(topic, access);
    return reinterpret_cast<gaitway_port*>(&plugin_.ports_.back());
  }
  gaitway_value declare_parameter(const gaitway_parameter& parameter) override {
    return plugin_.declare_parameter(parameter);
  }
  void set_period(gaitway_period period) override { plugin_.period_ = static_cast<Period>(period); }
  void report(gaitway_severity severity, std::string_view text) noexcept override {
    plugin_.post_report(severity, text);
  }
  const char* robot_directory() const noexcept override { return plugin_.robot_directory_.c_str(); }
  const char* memory_socket() const noexcept override { return plugin_.memory_socket_.c_str(); }
  const char* write_folder() const noexcept override { return ""; }  // of a process of its own alone
  gaitway_status read(gaitway_port& port, void* value, gaitway_sample& sample) noexcept override {
    return reinterpret_cast<TopicPort&>(port).read(value, sample);
  }
  gaitway_status publish(gaitway_port& port, const void* value) noexcept override {
    return reinterpret_cast<TopicPort&>(port).stage(value);
  }

 private:
  LoadedPlugin& plugin_;

 public:
  PluginInstance instance{*this, *this};
};

LoadedPlugin::LoadedPlugin(const PluginEntry& entry, const PluginSource& source, EventLog& events)
    : ManagedPlugin(entry, source.configuration_file, events),
      robot_directory_(source.robot_directory.string()),
      memory_socket_(source.memory_socket.string()),
      library_(at_place(place_,
                        [&] {
                          return PluginLibrary(entry.library, source.configuration_file.parent_path(),
                                               source.search_path);
                        })),
      border_(std::make_unique<Border>(*this)) {
  at_place(place_, [this] {
    if (border_->instance.create(library_.entry(), error_text()) != GAITWAY_OK) {
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
  if (border_->instance.activate(error_text()) != GAITWAY_OK) {
    fail("activation failed");
  }
  active_ = true;
}

void LoadedPlugin::deactivate() noexcept {
  if (std::exchange(active_, false) && border_->instance.deactivate(error_text()) != GAITWAY_OK) {
    events_.post(EventKind::error, name_, fault());
  }
}

bool LoadedPlugin::run(const Tick& tick) noexcept {
  return border_->instance.step({.now_ns = tick.now_ns,
                                 .batch_start_ns = tick.batch_start_ns,
                                 .batch_sequence = tick.batch_sequence,
                                 .tick = tick.tick,
                                 .batch = tick.batch ? 1U : 0U,
                                 .reserved = 0},
                                error_text()) == GAITWAY_OK;
}

bool LoadedPlugin::save_state(PluginState& state) noexcept {
  gaitway_state plain{state.bytes.data(), PluginState::kCapacity, 0, 0, 0};
  const gaitway_status status = border_->instance.save_state(plain, error_text());
  state.size = plain.size;
  state.version = plain.version;
  return status == GAITWAY_OK;
}

bool LoadedPlugin::restore_state(const PluginState& state) noexcept {
  const gaitway_text text = error_text();
  if (state.version == 0) {
    return true;  // nothing was handed on
  }
  return border_->instance.restore_state({const_cast<std::byte*>(state.bytes.data()), PluginState::kCapacity,
                                          state.size, state.version, 0},
                                         text) == GAITWAY_OK;
}

bool LoadedPlugin::set_parameter(const char* name, const gaitway_value& value) noexcept {
  return border_->instance.set_parameter(name, value, error_text()) == GAITWAY_OK;
}

}  // namespace gaitway::core
