// Each function finds its plug-in in `context`.
#include "host_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "gaitway/core/detail/plugin_border.hpp"

namespace gaitway::core {
namespace {

constexpr std::size_t kLongestReport = 160;

LoadedPlugin& plugin_of(void* context) noexcept {
  return *static_cast<LoadedPlugin*>(context);
}
TopicPort& port_of(gaitway_port* port) noexcept {
  return *reinterpret_cast<TopicPort*>(port);
}

void check_topic(const gaitway_topic* topic, gaitway_access access) {
  if (topic == nullptr || topic->name == nullptr || topic->type_name == nullptr || topic->size == 0) {
    throw PluginError("opens a topic without name, type or size");
  }
  if (access > GAITWAY_WRITE) {
    throw PluginError(fmt::format("opens topic '{}' with the unknown access {}", topic->name, access));
  }
  if (topic->float_field_count > 0 && topic->float_fields == nullptr) {
    throw PluginError(fmt::format("opens topic '{}' without its floating-point fields", topic->name));
  }
}

void check_parameter(const gaitway_parameter* parameter) {
  if (parameter == nullptr || parameter->name == nullptr || parameter->name[0] == '\0') {
    throw PluginError("declares a parameter without a name");
  }
  if (parameter->fallback.kind > GAITWAY_TEXT ||
      (parameter->fallback.kind == GAITWAY_TEXT && parameter->fallback.text == nullptr)) {
    throw PluginError(fmt::format("declares its parameter '{}' without a default", parameter->name));
  }
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
          .report = &report};
}

// For what only create may ask.
template <class Function>
gaitway_status HostFunctions::in_create(void* context, const gaitway_text* error,
                                        const Function& function) noexcept {
  LoadedPlugin& plugin = plugin_of(context);
  try {
    if (plugin.phase_ != LoadedPlugin::Phase::creating) {
      throw PluginError("topics, parameters and period are declared in the constructor only");
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
    check_topic(topic, access);
    const auto kind = static_cast<Access>(access);
    const bool twice = std::any_of(plugin.ports_.begin(), plugin.ports_.end(), [&](const TopicPort& other) {
      return kind == Access::write && other.use().access == kind && other.use().topic == topic->name;
    });
    if (twice) {
      throw PluginError(fmt::format("opens topic '{}' twice for writing. Keep the one Output", topic->name));
    }
    plugin.ports_.emplace_back(*topic, kind);
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
    if (period > GAITWAY_EVERY_BATCH) {
      throw PluginError(fmt::format("sets the unknown period {}", period));
    }
    plugin.period_ = static_cast<Period>(period);
  });
}

const char* HostFunctions::robot_directory(void* context) noexcept {
  return plugin_of(context).robot_directory_.c_str();
}

gaitway_status HostFunctions::read(void*, gaitway_port* port, void* value, gaitway_sample* sample) noexcept {
  return port == nullptr ? gaitway_status{GAITWAY_FAILED} : port_of(port).read(value, *sample);
}

gaitway_status HostFunctions::publish(void* context, gaitway_port* port, const void* value) noexcept {
  const bool allowed = port != nullptr && plugin_of(context).phase_ == LoadedPlugin::Phase::stepping;
  return allowed ? port_of(port).stage(value) : gaitway_status{GAITWAY_FAILED};
}

void HostFunctions::report(void* context, gaitway_severity severity, const char* text) noexcept {
  LoadedPlugin& plugin = plugin_of(context);
  const EventKind kind = severity == GAITWAY_INFO      ? EventKind::info
                         : severity == GAITWAY_WARNING ? EventKind::warning
                                                       : EventKind::error;
  plugin.events_->add(plugin.tick_.now_ns, plugin.tick_.tick, kind, plugin.name_,
                      {text, text == nullptr ? 0 : strnlen(text, kLongestReport)});
}

}  // namespace gaitway::core
