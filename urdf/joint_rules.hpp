// What must hold for a joint, in the URDF alone and together with the network file.
#pragma once

#include "network_file.hpp"
#include "urdf_file.hpp"

namespace gaitway::urdf {

// Axis, origin and limits in the URDF. Throws RobotError.
void check_geometry(const UrdfFile& urdf, const UrdfJoint& joint);

// URDF and network file together: motor and wire can do what the limits allow. Throws RobotError.
void check_drive(const UrdfFile& urdf, const UrdfJoint& geometry, const NetworkFile& network,
                 const NetworkJoint& drive);

}  // namespace gaitway::urdf
