/* Its tick has another size than ours; create must not be called. */
#include "never_created.h"

const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_MAGIC,
                                             GAITWAY_PLUGIN_ABI,
                                             GAITWAY_PLUGIN_ABI_MINOR,
                                             sizeof(gaitway_plugin),
                                             sizeof(gaitway_host),
                                             sizeof(gaitway_instance),
                                             sizeof(gaitway_tick) + 8,
                                             sizeof(gaitway_topic),
                                             sizeof(gaitway_float_field),
                                             sizeof(gaitway_sample),
                                             sizeof(gaitway_parameter),
                                             sizeof(gaitway_value),
                                             "wrong_size",
                                             "1.0.0",
                                             "Edited its header",
                                             &never_created};
