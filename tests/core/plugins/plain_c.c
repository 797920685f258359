/* A plug-in in C: counts its steps in the topic `count`, and fails when its parameter `fail_at` says so. */
#include <stdio.h>
#include <stdlib.h>

#include "gaitway/msgclient/topics.h"
#include "gaitway/plugin/abi.h"

struct counter {
  const gaitway_host* host;
  gaitway_port* count;
  int64_t fail_at;
  uint32_t steps;
};

static gaitway_status activate(void* context, const gaitway_text* error) {
  (void)error;
  ((struct counter*)context)->steps = 0;
  return GAITWAY_OK;
}

static gaitway_status step(void* context, const gaitway_tick* tick, const gaitway_text* error) {
  struct counter* self = context;
  struct gaitway_walk_command value = {0};
  value.stamp_ns = tick->now_ns;
  value.walk = ++self->steps;
  if ((int64_t)self->steps == self->fail_at) {
    snprintf(error->data, error->capacity, "step %u of C failed", (unsigned)self->steps);
    return GAITWAY_FAILED;
  }
  return self->host->publish(self->host->context, self->count, &value);
}

static gaitway_status deactivate(void* context, const gaitway_text* error) {
  (void)context;
  (void)error;
  return GAITWAY_OK;
}

static gaitway_status create(const gaitway_host* host, gaitway_instance* instance,
                             const gaitway_text* error) {
  const gaitway_topic topic = {
      "count", "WalkCommand", GAITWAY_WALK_COMMAND_TYPE_HASH, sizeof(struct gaitway_walk_command), 0, NULL};
  struct counter* self = calloc(1, sizeof *self);
  if (self == NULL) {
    snprintf(error->data, error->capacity, "no memory");
    return GAITWAY_FAILED;
  }
  self->host = host;
  const gaitway_network* const network = host->get_extension(host->context, GAITWAY_NETWORK_EXTENSION);
  if (network == NULL || network->write_folder(host->context)[0] != '\0' ||
      host->get_extension(host->context, "gaitway.never/1") != NULL) {
    snprintf(error->data, error->capacity, "extensions are not those that there are");
    free(self);
    return GAITWAY_FAILED;
  }
  const gaitway_parameter fail_at = {
      "fail_at", "1", "step that fails; 0: none", {GAITWAY_INTEGER, 0, 0, 0, NULL}, 0, 1e6, 0, 0};
  gaitway_value value;
  if (host->parameter(host->context, &fail_at, &value, error) != GAITWAY_OK ||
      host->open_topic(host->context, &topic, GAITWAY_WRITE, &self->count, error) != GAITWAY_OK) {
    free(self);
    return GAITWAY_FAILED;
  }
  self->fail_at = value.integer;
  instance->context = self;
  instance->activate = activate;
  instance->step = step;
  instance->deactivate = deactivate;
  instance->destroy = free;
  return GAITWAY_OK;
}

const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_HEAD, "plain_c", "1.0.0", "Counts its steps",
                                             &create};
