// Null pointers and numbers out of range, by name.
#include "plugin_declarations.hpp"

#include <fmt/format.h>

#include "gaitway/manager/data_flow.hpp"
#include "gaitway/manager/plugin_error.hpp"
#include "gaitway/msgclient/memory_block.hpp"

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

}  // namespace gaitway::core
