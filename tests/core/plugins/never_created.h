/* A create for plug-ins that must be refused before it is called. */
#ifndef GAITWAY_TESTS_NEVER_CREATED_H
#define GAITWAY_TESTS_NEVER_CREATED_H

#include <stdlib.h>

#include "gaitway/plugin/abi.h"

static gaitway_status never_created(const gaitway_host* host, gaitway_instance* instance,
                                    const gaitway_text* error) {
  (void)host;
  (void)instance;
  (void)error;
  abort();
}

#endif
