/* What a campaign tells the library that it preloads into a robot's programs: two words in a file that all of
 * them map, whose path is in the environment. */
#ifndef GAITWAY_CAMPAIGN_DISTURBANCE_H
#define GAITWAY_CAMPAIGN_DISTURBANCE_H

#include <stdint.h>

#define GAITWAY_DISTURBANCE_VARIABLE "GAITWAY_CAMPAIGN_DISTURBANCE"

struct gaitway_disturbance {
  int64_t clock_shift_ns; /* what CLOCK_REALTIME is off by */
  int64_t write_ns;       /* that each writing to a file takes longer; 0: none does */
};

#endif
