// `gaitway calibrate camera`: the robot's camera.yaml, from pictures of a board.
#pragma once

#include "tools/command_line.hpp"

namespace gaitway::calibration {

void declare_camera(const tools::CommandLine& calibrate);

}  // namespace gaitway::calibration
