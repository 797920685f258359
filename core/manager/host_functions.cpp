// Each function finds its plug-in in `context`.
#include "host_functions.hpp"

#include <cstring>

#include "gaitway/plugin/detail/plugin_border.hpp"
#include "plugin_declarations.hpp"

namespace gaitway::core {
namespace {

LoadedPlugin& plugin_of(void* context) noexcept {
  return *static_cast<LoadedPlugin*>(context);
}
TopicPort& port_of(gaitway_port* port) noexcept {
  return *reinterpret_cast<TopicPort*>(port);
}

}  // namespace

gaitway_host HostFunctions::table(LoadedPlugin& plugin) noexcept {
  return {.context = &plugin,
          .open_topic = &open_topic,
          .parameter = &parameter,
          .set_period = &set_period,
          .robot_directory = &robot_directory,
          .read = &read,
          .publish = &publish,
          .report = &report,
          .get_extension = &get_extension};
}

// For what only create may ask.
template <class Function>
gaitway_status HostFunctions::in_create(void* context, const gaitway_text* error,
                                        const Function& function) noexcept {
  LoadedPlugin& plugin = plugin_of(context);
  try {
    if (plugin.phase_ != LoadedPlugin::Phase::creating) {
      throw PluginError(kConstructorOnly);
    }
    function(plugin);
    return GAITWAY_OK;
  } catch (const ConfigurationError& problem) {
    detail::write_text(error, problem.what());
    plugin.parameter_error_ = std::make_unique<ConfigurationError>(problem);
  } catch (const std::exception& problem) {
    detail::write_text(error, problem.what());
  }
  return GAITWAY_FAILED;
}

gaitway_status HostFunctions::open_topic(void* context, const gaitway_topic* topic, gaitway_access access,
                                         gaitway_port** port, const gaitway_text* error) noexcept {
  return in_create(context, error, [&](LoadedPlugin& plugin) {
    plugin.declare_topic(topic, access);
    *port = reinterpret_cast<gaitway_port*>(&plugin.ports_.back());
  });
}

gaitway_status HostFunctions::parameter(void* context, const gaitway_parameter* parameter,
                                        gaitway_value* value, const gaitway_text* error) noexcept {
  return in_create(context, error, [&](LoadedPlugin& plugin) {
    check_parameter(parameter);
    *value = plugin.parameters_.declare(*parameter);
  });
}

gaitway_status HostFunctions::set_period(void* context, gaitway_period period,
                                         const gaitway_text* error) noexcept {
  return in_create(context, error, [&](LoadedPlugin& plugin) {
    check_period(period);
    plugin.period_ = static_cast<Period>(period);
  });
}

const char* HostFunctions::robot_directory(void* context) noexcept {
  return plugin_of(context).robot_directory_.c_str();
}

const char* HostFunctions::memory_socket(void* context) noexcept {
  return plugin_of(context).memory_socket_.c_str();
}

const char* HostFunctions::write_folder(void*) noexcept {
  return "";  // of a process of its own alone
}

gaitway_status HostFunctions::read(void*, gaitway_port* port, void* value, gaitway_sample* sample) noexcept {
  return port == nullptr ? gaitway_status{GAITWAY_FAILED} : port_of(port).read(value, *sample);
}

gaitway_status HostFunctions::publish(void* context, gaitway_port* port, const void* value) noexcept {
  const bool allowed = port != nullptr && plugin_of(context).phase_ == LoadedPlugin::Phase::stepping;
  return allowed ? port_of(port).stage(value) : gaitway_status{GAITWAY_FAILED};
}

const void* HostFunctions::get_extension(void*, const char* name) noexcept {
  static constexpr gaitway_network kNetwork{&memory_socket, &write_folder};
  return std::strcmp(name, GAITWAY_NETWORK_EXTENSION) == 0 ? &kNetwork : nullptr;
}

void HostFunctions::report(void* context, gaitway_severity severity, const char* text) noexcept {
  LoadedPlugin& plugin = plugin_of(context);
  const EventKind kind = severity == GAITWAY_INFO      ? EventKind::info
                         : severity == GAITWAY_WARNING ? EventKind::warning
                                                       : EventKind::error;
  plugin.events_.post(kind, plugin.name_, {text, text == nullptr ? 0 : strnlen(text, kLongestReport)});
}

}  // namespace gaitway::core
