/* A parameter without a unit: the C++ class would not let it pass. */
#include <stddef.h>

#include "gaitway/msgclient/topics.h"
#include "gaitway/plugin/abi.h"

static gaitway_status done(void* context, const gaitway_text* error) {
  (void)context;
  (void)error;
  return GAITWAY_OK;
}
static gaitway_status step(void* context, const gaitway_tick* tick, const gaitway_text* error) {
  (void)tick;
  return done(context, error);
}
static void destroy(void* context) {
  (void)context;
}

static gaitway_status create(const gaitway_host* host, gaitway_instance* instance,
                             const gaitway_text* error) {
  static const gaitway_parameter gain = {"gain", "", "", {GAITWAY_NUMBER, 0, 0.5, 0, NULL}, 0.0, 1.0, 0, 0};
  static const gaitway_topic topic = {"imu", "Imu", GAITWAY_IMU_TYPE_HASH, sizeof(struct gaitway_imu),
                                      0,     NULL};
  gaitway_value value;
  gaitway_port* port = NULL;
  if (host->parameter(host->context, &gain, &value, error) != GAITWAY_OK ||
      host->open_topic(host->context, &topic, GAITWAY_READ, &port, error) != GAITWAY_OK) {
    return GAITWAY_FAILED;
  }
  instance->activate = done;
  instance->step = step;
  instance->deactivate = done;
  instance->destroy = destroy;
  return GAITWAY_OK;
}

const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_HEAD, "no_unit", "1.0.0",
                                             "Has a parameter without a unit", &create};
