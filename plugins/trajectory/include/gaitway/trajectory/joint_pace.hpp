// How fast a gait makes the joints of the legs turn, before anybody walks it.
#pragma once

#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/urdf/leg_joints.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::trajectory {

// The joint that comes nearest to what a reference may ask of it.
struct JointPace {
  urdf::LegJoint joint = urdf::LegJoint::knee;
  double share = 0.0;  // of Joint::velocity_limit_rad_per_s
};

// Of hip pitch, knee and ankle pitch of both legs in a walk straight ahead, from the stand to the steady
// steps, safe tails included. The legs are taken as two links in the plane of their motion with level soles,
// the hips above the CoM's place in the stand. Some milliseconds; allocates.
[[nodiscard]] JointPace fastest_joint(const GaitParameters& parameters, const urdf::RobotModel& robot,
                                      double forward_m_per_s);

}  // namespace gaitway::trajectory
