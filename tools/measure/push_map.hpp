// A map of pushes: sectors are directions, rings are phases of the gait cycle, the colour says which share
// survived.
#pragma once

#include <string>

#include "tools/measure/gait_measurement.hpp"

namespace gaitway::tools {

// Of one level of a row of pushes, as inline SVG.
std::string push_map(const RowResult& row, const LevelResult& level);

}  // namespace gaitway::tools
