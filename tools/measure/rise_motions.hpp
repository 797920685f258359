// Motions that a measurement has robots play.
#pragma once

#include <vector>

#include "tools/measure/gait_table.hpp"
#include "tools/measure/gait_trial.hpp"

namespace gaitway::tools {

// Throws std::invalid_argument that names the row, the motion and the remedy, when a row's robots get up by a
// motion that was not prepared for this robot as it is now described: none of them would.
void require_rise_motions(const std::vector<GaitRow>& rows, const TrialRobot& robot);

}  // namespace gaitway::tools
