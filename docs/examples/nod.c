/* A plug-in in plain C: the robot bows a little and rises again while it walks, and its ankles press against
 * the trunk's lean. In the place of the shipped balance feedback: it writes the same topics. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

#include "gaitway/msgclient/topics.h"
#include "gaitway/plugin/abi.h"

static const double kNod_rad = 0.03, kPeriod_s = 2.0, kGain = 0.25;

struct nod {
  const gaitway_host* host;
  gaitway_port *estimate_in, *trim_out, *correction_out;
  struct gaitway_estimate estimate;
  gaitway_sample sample; /* which estimate that is */
  struct gaitway_trim_command trim;
  struct gaitway_correction correction;
};

static gaitway_status activate(void* context, const gaitway_text* error) {
  (void)context;
  (void)error;
  return GAITWAY_OK;
}

static gaitway_status step(void* context, const gaitway_tick* tick, const gaitway_text* error) {
  (void)error;
  struct nod* self = context;
  const gaitway_host* host = self->host;
  if (host->read(host->context, self->estimate_in, &self->estimate, &self->sample) != GAITWAY_OK) {
    return GAITWAY_OK; /* nothing has been estimated yet */
  }
  self->trim.stamp_ns = self->correction.stamp_ns = tick->now_ns;
  self->trim.channel_count = 8;
  self->trim.angle[4] = self->trim.angle[5] =
      kGain * self->estimate.attitude[1]; /* ankle pitch, both sides */
  self->trim.angle[6] = self->trim.angle[7] = kGain * self->estimate.attitude[0]; /* ankle roll */
  const double turns = (double)tick->now_ns * 1e-9 / kPeriod_s;
  self->correction.base_attitude_offset[1] = 0.5 * kNod_rad * (1.0 - cos(6.283185307179586 * turns));
  if (host->publish(host->context, self->trim_out, &self->trim) != GAITWAY_OK) {
    return GAITWAY_FAILED;
  }
  return host->publish(host->context, self->correction_out, &self->correction);
}

/* A run of numbers that the host checks before it publishes them. */
#define NUMBERS(type, field, rows, lowest, highest)                                                          \
  {                                                                                                          \
#field, offsetof(type, field), sizeof(((type*)0)->field) / sizeof(double), sizeof(double), rows, lowest, \
        highest                                                                                              \
  }

static gaitway_status open_topics(struct nod* self, const gaitway_text* error) {
  static const gaitway_float_field trim_numbers[] = {
      NUMBERS(struct gaitway_trim_command, angle, 8, -0.35, 0.35)};
  static const gaitway_float_field correction_numbers[] = {
      NUMBERS(struct gaitway_correction, base_attitude_offset, 2, -0.35, 0.35)};
  const gaitway_topic estimate = {"estimate", "Estimate", GAITWAY_ESTIMATE_TYPE_HASH, sizeof self->estimate,
                                  0,          NULL};
  const gaitway_topic trim = {"trim", "TrimCommand", GAITWAY_TRIM_COMMAND_TYPE_HASH, sizeof self->trim,
                              1,      trim_numbers};
  const gaitway_topic correction = {
      "correction",      "Correction", GAITWAY_CORRECTION_TYPE_HASH, sizeof self->correction, 1,
      correction_numbers};
  const gaitway_host* host = self->host;
  const int opened =
      host->open_topic(host->context, &estimate, GAITWAY_READ, &self->estimate_in, error) == GAITWAY_OK &&
      host->open_topic(host->context, &trim, GAITWAY_WRITE, &self->trim_out, error) == GAITWAY_OK &&
      host->open_topic(host->context, &correction, GAITWAY_WRITE, &self->correction_out, error) == GAITWAY_OK;
  return opened ? GAITWAY_OK : GAITWAY_FAILED;
}

static gaitway_status create(const gaitway_host* host, gaitway_instance* instance,
                             const gaitway_text* error) {
  struct nod* self = calloc(1, sizeof *self);
  if (self == NULL) {
    snprintf(error->data, error->capacity, "no memory");
    return GAITWAY_FAILED;
  }
  self->host = host;
  if (open_topics(self, error) != GAITWAY_OK) {
    free(self);
    return GAITWAY_FAILED;
  }
  instance->context = self;
  instance->activate = activate;
  instance->step = step;
  instance->deactivate = activate; /* does as little */
  instance->destroy = free;
  return GAITWAY_OK;
}

const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_HEAD, "nod", "1.0.0",
                                             "Bows a little while it walks", &create};
