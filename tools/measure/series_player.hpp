// Plays series of trials that are asked for by lines: what a worker of `gaitway measure gait --on PLACE`
// runs.
#pragma once

#include <string>
#include <vector>

#include "tools/measure/gait_table.hpp"

namespace gaitway::tools {

// Lines of JSON on standard input and output:
//
//   from it: {"fingerprint":…}   first: what outcomes depend on
//   to it:   {"row":…,"level":…,"seed":…,"first":…,"count":…}
//   from it: {"outcomes":[…]}    up to the trial that decides; or {"error":"…"}
//
// One line is answered after the other, each by a copy of the process. Returns when nobody asks any more,
// also in the midst of a series. Call it where there is a single thread.
void play_series(const TrialRobot& robot, const std::vector<GaitRow>& rows, std::uint64_t fingerprint);

}  // namespace gaitway::tools
