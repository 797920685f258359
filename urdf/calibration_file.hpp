// calibration.yaml: what is known of one robot, beyond what its kind's description says.
#pragma once

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

// Puts joint zeros, the trunk's centre of mass and force cells' gains into a model that has none of them yet.
// What the file does not name stays as described. Throws RobotError.
void apply_calibration_file(const std::filesystem::path& file, RobotModel& model);

}  // namespace gaitway::urdf
