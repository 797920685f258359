/* Claims that the values of its topic have as many bytes as its parameter `bytes` says. */
#include <stdio.h>

#include "gaitway/plugin/abi.h"

static gaitway_status create(const gaitway_host* host, gaitway_instance* instance,
                             const gaitway_text* error) {
  (void)instance;
  const gaitway_parameter bytes = {
      "bytes", "1", "of a value", {GAITWAY_INTEGER, 0, 0, 1, NULL}, 1, 4294967295.0, 0, 0};
  gaitway_value value;
  gaitway_port* port = NULL;
  if (host->parameter(host->context, &bytes, &value, error) != GAITWAY_OK) {
    return GAITWAY_FAILED;
  }
  /* Twice: more than one block holds may also come in parts. */
  const gaitway_topic first = {"first", "Huge", 1, (uint32_t)value.integer, 0, NULL};
  const gaitway_topic second = {"second", "Huge", 1, (uint32_t)value.integer, 0, NULL};
  if (host->open_topic(host->context, &first, GAITWAY_READ_OPTIONAL, &port, error) != GAITWAY_OK ||
      host->open_topic(host->context, &second, GAITWAY_READ_OPTIONAL, &port, error) != GAITWAY_OK) {
    return GAITWAY_FAILED;
  }
  snprintf(error->data, error->capacity, "nobody refused it");
  return GAITWAY_FAILED;
}

const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_HEAD, "huge_topic", "1.0.0", "Claims memory",
                                             &create};
