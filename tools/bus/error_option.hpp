// How a bus may be disturbed, as written on the command line:
//
//   burst:4,interval:10ms   four errors at once, then one every 10 ms
//   jam:2ms                 the bus is unusable for 2 ms, once
//   jam:2ms,interval:100ms  and again every 100 ms
#pragma once

#include <string>

#include "gaitway/can/analysis/error_model.hpp"

namespace gaitway::tools {

// Parts: `burst:N` (1 when left out), `interval:TIME`, `jam:TIME`, in any order, each at most once; TIME is a
// number with the unit us, ms or s. Throws std::invalid_argument that names part, value and rule.
[[nodiscard]] can::ErrorSource parse_errors(const std::string& text);

}  // namespace gaitway::tools
