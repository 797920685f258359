// Motions that a measurement has robots play.
#pragma once

#include <string>
#include <vector>

#include "tools/measure/gait_table.hpp"
#include "tools/measure/gait_trial.hpp"

namespace gaitway::tools {

// Takes out the rows whose robots get up by a motion that was not prepared for this robot as it is described
// now: none of them would. Returns which rows, why, and the remedy; empty: none.
std::string without_rise_motions(std::vector<GaitRow>& rows, const TrialRobot& robot);

}  // namespace gaitway::tools
