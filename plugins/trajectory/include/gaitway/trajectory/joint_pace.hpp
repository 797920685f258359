// What a gait asks of the legs and of the ground, before anybody walks it: how fast joints turn, how near to
// their limits, and how much the leg in the air twists the foot on the ground.
#pragma once

#include "gaitway/trajectory/footstep_planner.hpp"
#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/urdf/leg_joints.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::trajectory {

// The joint that comes nearest to what a reference may ask of it.
struct JointPace {
  urdf::Side side = urdf::Side::left;
  urdf::LegJoint joint = urdf::LegJoint::knee;
  double share = 0.0;  // of Joint::velocity_limit_rad_per_s
};

// The joint that comes nearest to one of its limits.
struct JointRoom {
  urdf::Side side = urdf::Side::left;
  urdf::LegJoint joint = urdf::LegJoint::knee;
  double room_rad = 0.0;  // negative: beyond it
};

struct StrideDemand {
  JointPace pace;
  JointRoom room;
  // The largest moment about the vertical that the motion of legs and arms needs in the steady walk, as a
  // share of what one sole's friction bears at the robot's weight, evenly pressed. Above some share the foot
  // slips round.
  double twist_share = 0.0;
  double arm_pace_share = 0.0;  // of the slower shoulder's velocity limit, where arms swing
};

// Of all joints of both legs in a walk at this velocity, from the stand to the steady steps, safe tails
// included. The legs are taken as two links in the plane of their motion with level soles, the hips above the
// CoM's place in the stand; rolls and yaws are those of hips that yaw first and roll then. The twist is that
// of a walk straight ahead. Some milliseconds; allocates.
[[nodiscard]] StrideDemand stride_demand(const GaitParameters& parameters, const urdf::RobotModel& robot,
                                         const Velocity2& velocity);
[[nodiscard]] inline StrideDemand stride_demand(const GaitParameters& parameters,
                                                const urdf::RobotModel& robot, double forward_m_per_s) {
  return stride_demand(parameters, robot, Velocity2{.forward_m_per_s = forward_m_per_s});
}

// The joint that a demand names.
[[nodiscard]] const urdf::Joint& joint_of(const urdf::RobotModel& robot, urdf::Side side,
                                          urdf::LegJoint which);
[[nodiscard]] inline JointPace fastest_joint(const GaitParameters& parameters, const urdf::RobotModel& robot,
                                             double forward_m_per_s) {
  return stride_demand(parameters, robot, forward_m_per_s).pace;
}

}  // namespace gaitway::trajectory
