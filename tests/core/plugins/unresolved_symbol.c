/* Calls a function that no library defines. */
#include "never_created.h"

void gaitway_test_defined_nowhere(void);
static gaitway_status create(const gaitway_host* host, gaitway_instance* instance,
                             const gaitway_text* error) {
  gaitway_test_defined_nowhere();
  return never_created(host, instance, error);
}

const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_HEAD, "unresolved_symbol", "1.0.0",
                                             "Was linked without what it needs", &create};
