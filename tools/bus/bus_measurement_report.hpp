// Tables 6 and 7 of the published experiment, measured and published values beside each other.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tools/bus/bus_measurement.hpp"

namespace gaitway::tools {

// Which messages the bus carries, and what was measured of each.
[[nodiscard]] std::string message_table(const BusMeasurement& measurement, const BusRobot& robot);

// What the bus needs for one message of every node, and for a user command.
[[nodiscard]] std::string time_table(const BusMeasurement& measurement, const BusRobot& robot);

// Both tables.
[[nodiscard]] nlohmann::ordered_json to_json(const BusMeasurement& measurement, const BusRobot& robot);

// By how much a measured time is longer than the published one.
[[nodiscard]] constexpr double difference_percent(double measured, double published) noexcept {
  return 100.0 * (measured / published - 1.0);
}

}  // namespace gaitway::tools
