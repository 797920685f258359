/* One plug-in that uses the whole interface in C; docs/plugin-interface.md shows its parts. It commands the
 * walk: straight on, at a speed that comes in slowly, and slower while the trunk leans. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gaitway/msgclient/topics.h"
#include "gaitway/plugin/abi.h"
#include "reference/topics.h"

struct pace {
  const gaitway_host* host;
  gaitway_port *lean_in, *command_out;
  gaitway_lean_state lean;
  gaitway_sample sample; /* which value of `lean` that is */
  double wanted_m_per_s; /* the parameter */
  double speed_m_per_s;  /* what is handed on */
};

static gaitway_status fail(const gaitway_text* error, const char* text) {
  snprintf(error->data, error->capacity, "%s", text);
  return GAITWAY_FAILED;
}

static gaitway_status activate(void* context, const gaitway_text* error) {
  struct pace* self = context;
  (void)error;
  self->host->report(self->host->context, GAITWAY_INFO, "walks straight on");
  return GAITWAY_OK;
}

static gaitway_status step(void* context, const gaitway_tick* tick, const gaitway_text* error) {
  struct pace* self = context;
  const gaitway_host* host = self->host;
  const gaitway_status known = host->read(host->context, self->lean_in, &self->lean, &self->sample);
  const double slower = known == GAITWAY_OK ? fmin(1.0, 10.0 * fabs(self->lean.lean[1])) : 0.0;
  const double wanted_m_per_s = self->wanted_m_per_s * (1.0 - slower);
  const struct gaitway_walk_command command = {
      .stamp_ns = tick->now_ns, .walk = 1, .velocity = {self->speed_m_per_s, 0.0}};
  self->speed_m_per_s += 0.01 * (wanted_m_per_s - self->speed_m_per_s);
  if (host->publish(host->context, self->command_out, &command) != GAITWAY_OK) {
    return fail(error, "cannot publish the walk");
  }
  return GAITWAY_OK;
}

static gaitway_status deactivate(void* context, const gaitway_text* error) {
  (void)context;
  (void)error;
  return GAITWAY_OK;
}

static gaitway_status set_parameter(void* context, const char* name, const gaitway_value* value,
                                    const gaitway_text* error) {
  struct pace* self = context;
  if (strcmp(name, "speed") != 0) {
    return fail(error, "this parameter does not change while the plug-in runs");
  }
  self->wanted_m_per_s = value->number;
  return GAITWAY_OK;
}

static gaitway_status save_state(void* context, gaitway_state* state, const gaitway_text* error) {
  const struct pace* self = context;
  if (state->capacity < sizeof self->speed_m_per_s) {
    return fail(error, "no room for the state");
  }
  memcpy(state->data, &self->speed_m_per_s, sizeof self->speed_m_per_s);
  state->size = sizeof self->speed_m_per_s;
  state->version = 1;
  return GAITWAY_OK;
}

static gaitway_status restore_state(void* context, const gaitway_state* state, const gaitway_text* error) {
  struct pace* self = context;
  if (state->version != 1 || state->size != sizeof self->speed_m_per_s) {
    return fail(error, "takes over state of version 1 alone");
  }
  memcpy(&self->speed_m_per_s, state->data, sizeof self->speed_m_per_s);
  return GAITWAY_OK;
}

static const void* get_extension(void* context, const char* name) {
  static const gaitway_state_functions state = {save_state, restore_state};
  (void)context;
  return strcmp(name, GAITWAY_STATE_EXTENSION) == 0 ? &state : NULL;
}

static gaitway_status declare(struct pace* self, const gaitway_text* error) {
  static const gaitway_float_field velocity = {.name = "velocity",
                                               .offset = offsetof(struct gaitway_walk_command, velocity),
                                               .count = 2,
                                               .bytes = sizeof(double),
                                               .rows = 2,
                                               .lowest = -1.5,
                                               .highest = 1.5};
  const gaitway_topic command = {.name = "walk_command",
                                 .type_name = "WalkCommand",
                                 .type_hash = GAITWAY_WALK_COMMAND_TYPE_HASH,
                                 .size = sizeof(struct gaitway_walk_command),
                                 .float_field_count = 1,
                                 .float_fields = &velocity};
  const gaitway_topic lean = {.name = "lean",
                              .type_name = "LeanState",
                              .type_hash = GAITWAY_LEAN_STATE_TYPE_HASH,
                              .size = sizeof self->lean};
  const gaitway_parameter speed = {.name = "speed",
                                   .unit = "m/s",
                                   .doc = "forward",
                                   .fallback = {.kind = GAITWAY_NUMBER, .number = 0.1},
                                   .lowest = 0.0,
                                   .highest = 0.3,
                                   .live = 1};
  const gaitway_host* host = self->host;
  gaitway_value value;
  if (host->parameter(host->context, &speed, &value, error) != GAITWAY_OK ||
      host->open_topic(host->context, &lean, GAITWAY_READ_PREVIOUS, &self->lean_in, error) != GAITWAY_OK ||
      host->open_topic(host->context, &command, GAITWAY_WRITE, &self->command_out, error) != GAITWAY_OK ||
      host->set_period(host->context, GAITWAY_EVERY_TICK, error) != GAITWAY_OK) {
    return GAITWAY_FAILED; /* the host has written why */
  }
  self->wanted_m_per_s = value.number;
  return GAITWAY_OK;
}

static gaitway_status create(const gaitway_host* host, gaitway_instance* instance,
                             const gaitway_text* error) {
  struct pace* self = calloc(1, sizeof *self);
  if (self == NULL) {
    return fail(error, "no memory");
  }
  self->host = host;
  if (declare(self, error) != GAITWAY_OK) {
    free(self);
    return GAITWAY_FAILED;
  }
  *instance = (gaitway_instance){.context = self,
                                 .activate = activate,
                                 .step = step,
                                 .deactivate = deactivate,
                                 .destroy = free,
                                 .set_parameter = set_parameter,
                                 .get_extension = get_extension};
  return GAITWAY_OK;
}

const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_HEAD, "pace", "1.0.0",
                                             "Walks straight on, slower while the trunk leans", &create};
