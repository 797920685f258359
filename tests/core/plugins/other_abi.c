/* Says that it was built for the next ABI; create must not be called. */
#include "never_created.h"

const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_MAGIC,
                                             GAITWAY_PLUGIN_ABI + 1,
                                             GAITWAY_PLUGIN_ABI_MINOR,
                                             sizeof(gaitway_plugin),
                                             sizeof(gaitway_host),
                                             sizeof(gaitway_instance),
                                             sizeof(gaitway_tick),
                                             sizeof(gaitway_topic),
                                             sizeof(gaitway_float_field),
                                             sizeof(gaitway_sample),
                                             sizeof(gaitway_parameter),
                                             sizeof(gaitway_value),
                                             "other_abi",
                                             "1.0.0",
                                             "From the future",
                                             &never_created};
