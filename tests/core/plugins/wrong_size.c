/* Its tick has another size than ours; create must not be called. */
#include <stdlib.h>

#include "gaitway/core/plugin_abi.h"

static gaitway_status create(const gaitway_host* host, gaitway_instance* instance,
                             const gaitway_text* error) {
  (void)host;
  (void)instance;
  (void)error;
  abort();
}

const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_MAGIC,
                                             GAITWAY_PLUGIN_ABI,
                                             sizeof(gaitway_plugin),
                                             sizeof(gaitway_host),
                                             sizeof(gaitway_instance),
                                             sizeof(gaitway_tick) + 8,
                                             sizeof(gaitway_topic),
                                             sizeof(gaitway_float_field),
                                             sizeof(gaitway_sample),
                                             0,
                                             "wrong_size",
                                             "1.0.0",
                                             "Edited its header",
                                             &create};
