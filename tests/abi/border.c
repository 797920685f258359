/* A library from which all types of the plug-in border can be reached, with debug information: what abidiff
 * compares with the record of this ABI number. */
#ifdef GAITWAY_TEST_GROWN
#define reserved reserved, grown /* every struct with room for later grows without a new ABI number */
#endif
#include "gaitway/plugin/abi.h"

static gaitway_status create(const gaitway_host* host, gaitway_instance* instance,
                             const gaitway_text* error) {
  (void)host;
  (void)instance;
  (void)error;
  return GAITWAY_FAILED;
}

/* Reached by name alone: these make them part of the record. */
extern __attribute__((visibility("default"))) const gaitway_network gaitway_border_network;
const gaitway_network gaitway_border_network = {0};
extern __attribute__((visibility("default"))) const gaitway_state_functions gaitway_border_state;
const gaitway_state_functions gaitway_border_state = {0};

const gaitway_plugin gaitway_plugin_entry = {GAITWAY_PLUGIN_HEAD, "border", "1.0.0", "The border's types",
                                             &create};
