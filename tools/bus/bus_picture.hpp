// Draws who has the bus when: one time slot with a row for every identifier, and a whole cycle with a row for
// every message. Stand-alone SVG files.
#pragma once

#include <string>

#include "tools/bus/bus_measurement.hpp"

namespace gaitway::tools {

// The fullest time slot of the newest whole cycle. Marks how late each frame might have come, by the
// analysis, where its release is known. Both are empty when there was no whole cycle.
[[nodiscard]] std::string slot_picture(const BusMeasurement& measurement, const BusRobot& robot);
[[nodiscard]] std::string cycle_picture(const BusMeasurement& measurement, const BusRobot& robot);

}  // namespace gaitway::tools
