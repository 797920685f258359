// What must hold for a link: physical mass and inertia, plausible dimensions.
#pragma once

#include "urdf_file.hpp"

namespace gaitway::urdf {

// Throws RobotError.
void check_link(const UrdfFile& urdf, const Link& link);

}  // namespace gaitway::urdf
