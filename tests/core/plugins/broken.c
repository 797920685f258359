/* Libraries that the host must refuse or must not believe: all are built from this file, and a definition
 * with the library's name chooses. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "gaitway/msgclient/topics.h"
#include "gaitway/plugin/abi.h"

#if defined(GAITWAY_BROKEN_missing_symbol) /* a shared library, but no plug-in */

const int gaitway_plugin_entries = 1;

#elif defined(GAITWAY_BROKEN_huge_topic) /* of values that have as many bytes as its parameter `bytes` says \
                                          */

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

#elif defined( \
    GAITWAY_BROKEN_no_field_table) /* writes a standard topic and does not say where its numbers lie */

struct commander {
  const gaitway_host* host;
  gaitway_port* command;
};

static gaitway_status fine(void* context, const gaitway_text* error) {
  (void)context;
  (void)error;
  return GAITWAY_OK;
}

static void destroy(void* context) {
  (void)context;
}

static gaitway_status step(void* context, const gaitway_tick* tick, const gaitway_text* error) {
  const struct commander* self = context;
  struct gaitway_walk_command value = {0};
  (void)error;
  value.stamp_ns = tick->now_ns;
  value.velocity[0] = tick->tick % 2 == 0 ? 0.25 : 1e9;
  return self->host->publish(self->host->context, self->command, &value);
}

static gaitway_status create(const gaitway_host* host, gaitway_instance* instance,
                             const gaitway_text* error) {
  static struct commander self;
  const gaitway_topic topic = {"walk_command",
                               "WalkCommand",
                               GAITWAY_WALK_COMMAND_TYPE_HASH,
                               sizeof(struct gaitway_walk_command),
                               0,
                               NULL};
  self.host = host;
  instance->context = &self;
  instance->activate = instance->deactivate = fine;
  instance->step = step;
  instance->destroy = destroy;
  return host->open_topic(host->context, &topic, GAITWAY_WRITE, &self.command, error);
}

const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_HEAD, "no_field_table", "1.0.0",
                                             "Hides its numbers", &create};

#else /* refused before create is called */

#if defined(GAITWAY_BROKEN_unresolved_symbol)
void gaitway_test_defined_nowhere(void);
#endif

static gaitway_status create(const gaitway_host* host, gaitway_instance* instance,
                             const gaitway_text* error) {
  (void)host;
  (void)instance;
  (void)error;
#if defined(GAITWAY_BROKEN_unresolved_symbol)
  gaitway_test_defined_nowhere();
#endif
  abort();
}

#if defined(GAITWAY_BROKEN_unresolved_symbol) /* was linked without what it needs */
const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_HEAD, "unresolved_symbol", "1.0.0",
                                             "Calls what no library defines", &create};
#else /* other_abi: built for the next ABI; wrong_size: whose header was edited, its tick is larger */
#if defined(GAITWAY_BROKEN_other_abi)
enum { kLaterAbi = 1, kLargerTick = 0 };
#else
enum { kLaterAbi = 0, kLargerTick = 8 };
#endif
const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_MAGIC,
                                             GAITWAY_PLUGIN_ABI + kLaterAbi,
                                             GAITWAY_PLUGIN_ABI_MINOR,
                                             sizeof(gaitway_plugin),
                                             sizeof(gaitway_host),
                                             sizeof(gaitway_instance),
                                             sizeof(gaitway_tick) + kLargerTick,
                                             sizeof(gaitway_topic),
                                             sizeof(gaitway_float_field),
                                             sizeof(gaitway_sample),
                                             sizeof(gaitway_parameter),
                                             sizeof(gaitway_value),
                                             "other_border",
                                             "1.0.0",
                                             "Must not be called",
                                             &create};
#endif

#endif
