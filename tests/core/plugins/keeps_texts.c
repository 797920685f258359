/* Keeps the addresses of the texts that its live parameter `words` has had, and reports in each step what
 * they hold: the host says that they live until destroy returns. */
#include <stdio.h>
#include <stdlib.h>

#include "gaitway/plugin/abi.h"

enum { kMost = 8 };

struct keeper {
  const gaitway_host* host;
  const char* texts[kMost];
  int count;
};

static gaitway_status fine(void* context, const gaitway_text* error) {
  (void)context;
  (void)error;
  return GAITWAY_OK;
}

static gaitway_status step(void* context, const gaitway_tick* tick, const gaitway_text* error) {
  const struct keeper* self = context;
  char line[160];
  int length = 0;
  (void)tick;
  (void)error;
  for (int i = 0; i < self->count; ++i) {
    length +=
        snprintf(line + length, sizeof line - (size_t)length, "%s%s", i == 0 ? "" : "|", self->texts[i]);
  }
  self->host->report(self->host->context, GAITWAY_INFO, line);
  return GAITWAY_OK;
}

static gaitway_status set_parameter(void* context, const char* name, const gaitway_value* value,
                                    const gaitway_text* error) {
  struct keeper* self = context;
  (void)name;
  if (self->count == kMost) {
    snprintf(error->data, error->capacity, "keeps no more texts");
    return GAITWAY_FAILED;
  }
  self->texts[self->count++] = value->text;
  return GAITWAY_OK;
}

static gaitway_status create(const gaitway_host* host, gaitway_instance* instance,
                             const gaitway_text* error) {
  const gaitway_parameter words = {"words", "", "kept", {GAITWAY_TEXT, 0, 0, 0, "at first"}, 0, 0, 1, 0};
  gaitway_value value;
  struct keeper* self = calloc(1, sizeof *self);
  if (self == NULL || host->parameter(host->context, &words, &value, error) != GAITWAY_OK) {
    free(self);
    return GAITWAY_FAILED;
  }
  self->host = host;
  self->texts[self->count++] = value.text;
  instance->context = self;
  instance->activate = instance->deactivate = fine;
  instance->step = step;
  instance->destroy = free;
  instance->set_parameter = set_parameter;
  return GAITWAY_OK;
}

const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_HEAD, "keeps_texts", "1.0.0",
                                             "Believes what it was promised", &create};
