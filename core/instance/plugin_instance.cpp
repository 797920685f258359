// Calls in both directions over the C ABI; null pointers and numbers out of range, by name.
#include "gaitway/instance/plugin_instance.hpp"

#include <fmt/format.h>
#include <string.h>

#include <exception>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/topic_port.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/plugin/detail/plugin_border.hpp"

namespace gaitway::core {

void check_topic(const gaitway_topic* topic, gaitway_access access) {
  if (topic == nullptr || topic->name == nullptr || topic->type_name == nullptr || topic->size == 0) {
    throw PluginError("opens a topic without name, type or size");
  }
  if (topic->size > msgclient::kMaxBlockBytes) {
    throw PluginError(fmt::format(
        "opens topic '{}' with values of {} bytes; a value has 1 to {} bytes, which is what a memory "
        "block holds. Correct its type",
        topic->name, topic->size, msgclient::kMaxBlockBytes));
  }
  if (access >= kAccesses.size()) {
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

void check_period(gaitway_period period) {
  if (period > GAITWAY_EVERY_BATCH) {
    throw PluginError(fmt::format("sets the unknown period {}", period));
  }
}

// Each finds its plug-in in `context`.
struct PluginInstance::Functions {
  static PluginInstance& of(void* context) noexcept { return *static_cast<PluginInstance*>(context); }

  // For what only create may ask.
  template <class Function>
  static gaitway_status in_create(void* context, const gaitway_text* error,
                                  const Function& function) noexcept {
    try {
      if (!of(context).creating_) {
        throw PluginError("topics, parameters and period are declared in the constructor only");
      }
      function(of(context).declarations_);
      return GAITWAY_OK;
    } catch (const std::exception& problem) {
      detail::write_text(error, problem.what());
    }
    return GAITWAY_FAILED;
  }

  static gaitway_status open_topic(void* context, const gaitway_topic* topic, gaitway_access access,
                                   gaitway_port** port, const gaitway_text* error) noexcept {
    return in_create(context, error, [&](PluginDeclarations& declarations) {
      check_topic(topic, access);
      *port = declarations.open_topic(*topic, access);
    });
  }
  static gaitway_status parameter(void* context, const gaitway_parameter* parameter, gaitway_value* value,
                                  const gaitway_text* error) noexcept {
    return in_create(context, error, [&](PluginDeclarations& declarations) {
      check_parameter(parameter);
      *value = declarations.declare_parameter(*parameter);
    });
  }
  static gaitway_status set_period(void* context, gaitway_period period, const gaitway_text* error) noexcept {
    return in_create(context, error, [&](PluginDeclarations& declarations) {
      check_period(period);
      declarations.set_period(period);
    });
  }
  static const char* robot_directory(void* context) noexcept {
    return of(context).surroundings_.robot_directory();
  }
  static const char* memory_socket(void* context) noexcept {
    return of(context).surroundings_.memory_socket();
  }
  static const char* write_folder(void*) noexcept { return ""; }
  static gaitway_status read(void* context, gaitway_port* port, void* value,
                             gaitway_sample* sample) noexcept {
    return port == nullptr ? gaitway_status{GAITWAY_FAILED}
                           : of(context).surroundings_.read(*port, value, *sample);
  }
  static gaitway_status publish(void* context, gaitway_port* port, const void* value) noexcept {
    return port == nullptr || !of(context).stepping_ ? gaitway_status{GAITWAY_FAILED}
                                                     : of(context).surroundings_.publish(*port, value);
  }
  static const void* get_extension(void*, const char* name) noexcept {
    static constexpr gaitway_network kNetwork{&memory_socket, &write_folder};
    return std::string_view(name) == GAITWAY_NETWORK_EXTENSION ? &kNetwork : nullptr;
  }
  static void report(void* context, gaitway_severity severity, const char* text) noexcept {
    of(context).declarations_.report(severity, {text, text == nullptr ? 0 : strnlen(text, kLongestReport)});
  }
};

PluginInstance::PluginInstance(PluginDeclarations& declarations, PluginSurroundings& surroundings) noexcept
    : declarations_(declarations),
      surroundings_(surroundings),
      host_{.context = this,
            .open_topic = &Functions::open_topic,
            .parameter = &Functions::parameter,
            .set_period = &Functions::set_period,
            .robot_directory = &Functions::robot_directory,
            .read = &Functions::read,
            .publish = &Functions::publish,
            .report = &Functions::report,
            .get_extension = &Functions::get_extension} {}

gaitway_status PluginInstance::create(const gaitway_plugin& entry, const gaitway_text& error) noexcept {
  creating_ = true;
  const gaitway_status status = entry.create(&host_, &instance_, &error);
  creating_ = false;
  if (status != GAITWAY_OK) {
    instance_ = {};
    return status;
  }
  if (instance_.activate == nullptr || instance_.step == nullptr || instance_.deactivate == nullptr ||
      instance_.destroy == nullptr) {
    destroy();
    detail::write_text(&error,
                       "create left out one of activate, step, deactivate and destroy. Fill in all four");
    return GAITWAY_FAILED;
  }
  return GAITWAY_OK;
}

void PluginInstance::destroy() noexcept {
  if (instance_.destroy != nullptr) {
    instance_.destroy(instance_.context);
  }
  instance_ = {};
}

gaitway_status PluginInstance::activate(const gaitway_text& error) noexcept {
  return instance_.activate(instance_.context, &error);
}

gaitway_status PluginInstance::deactivate(const gaitway_text& error) noexcept {
  return instance_.deactivate(instance_.context, &error);
}

gaitway_status PluginInstance::step(const gaitway_tick& tick, const gaitway_text& error) noexcept {
  stepping_ = true;
  const gaitway_status status = instance_.step(instance_.context, &tick, &error);
  stepping_ = false;
  if (status != GAITWAY_OK && error.data[0] == '\0') {
    fmt::format_to_n(error.data, error.capacity - 1, "step answered {} without a text", status).out[0] = '\0';
  }
  return status;
}

gaitway_status PluginInstance::save_state(gaitway_state& state, const gaitway_text& error) noexcept {
  state.size = state.version = 0;
  const gaitway_state_functions* const functions = detail::state_functions(instance_);
  if (functions == nullptr) {
    return GAITWAY_OK;
  }
  const gaitway_status status = functions->save_state(instance_.context, &state, &error);
  if (status == GAITWAY_OK && state.size <= state.capacity) {
    return GAITWAY_OK;
  }
  if (status == GAITWAY_OK) {
    detail::write_text(&error, "save_state claims more bytes than there is room for");
  }
  state.size = state.version = 0;
  return GAITWAY_FAILED;
}

gaitway_status PluginInstance::restore_state(const gaitway_state& state, const gaitway_text& error) noexcept {
  const gaitway_state_functions* const functions = detail::state_functions(instance_);
  if (functions == nullptr) {
    detail::write_text(&error, "takes no state over, but its predecessor hands some on");
    return GAITWAY_FAILED;
  }
  return functions->restore_state(instance_.context, &state, &error);
}

gaitway_status PluginInstance::set_parameter(const char* name, const gaitway_value& value,
                                             const gaitway_text& error) noexcept {
  if (instance_.set_parameter == nullptr) {
    detail::write_text(&error, "changes no parameter while it runs");
    return GAITWAY_FAILED;
  }
  return instance_.set_parameter(instance_.context, name, &value, &error);
}

}  // namespace gaitway::core
