// Whether the motors of the legs carry the robot on one leg, and swing the other, before anybody walks it.
#pragma once

#include <string>
#include <vector>

#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/urdf/leg_joints.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::trajectory {

// Of one joint of a leg.
struct JointTorque {
  int index = 0;  // in RobotModel::joints
  urdf::LegJoint joint = urdf::LegJoint::knee;
  double holds_Nm = 0.0;   // at rest on this leg alone, in the standing posture
  double swings_Nm = 0.0;  // to swing this leg through the longest step; hip pitch alone
  double limit_Nm = 0.0;   // Motor::torque_limit_Nm

  // A walk takes more than standing: the body sways, and a motor that turns has less.
  static constexpr double kWalking = 1.4;
  [[nodiscard]] double needs_Nm() const noexcept {
    return kWalking * (holds_Nm > swings_Nm ? holds_Nm : swings_Nm);
  }
  [[nodiscard]] bool holds() const noexcept { return holds_Nm <= limit_Nm; }
  [[nodiscard]] bool walks() const noexcept { return needs_Nm() <= limit_Nm; }
};

// Hip roll and pitch, knee, ankle pitch and roll of both legs.
[[nodiscard]] std::vector<JointTorque> leg_torques(const GaitParameters& parameters,
                                                   const urdf::RobotModel& robot);

// "joint 'left_knee' needs 4.1 N*m to walk (2.7 to stand on one leg), its motor has 2.9", of the joint that
// lacks most; empty: all are strong enough.
[[nodiscard]] std::string weakest_joint(const std::vector<JointTorque>& torques,
                                        const urdf::RobotModel& robot);

// Throws std::invalid_argument naming joint, torques and remedy if a motor cannot even hold the robot on one
// leg.
void require_strong_enough(const GaitParameters& parameters, const urdf::RobotModel& robot);

}  // namespace gaitway::trajectory
