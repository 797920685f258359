// The robot as a KDL tree.
#pragma once

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

// Segments bear the links' names, KDL joints the joints'. The model's links and joints must be complete.
[[nodiscard]] KDL::Tree make_kdl_tree(const RobotModel& model);

}  // namespace gaitway::urdf
