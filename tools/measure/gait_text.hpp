// How figures of the gait table are written for people.
#pragma once

#include <string>

#include "tools/measure/gait_measurement.hpp"
#include "tools/measure/gait_report.hpp"

namespace gaitway::tools {

// A figure of the row in its unit: "0.35 m/s".
std::string shown(const GaitRow& row, double value);
std::string shown_limit(const RowResult& result);
// "20 of 20", with a word where it does not hold.
std::string shown_floor(const RowResult& result);
std::string shown_head(const GaitReportHead& head);

}  // namespace gaitway::tools
