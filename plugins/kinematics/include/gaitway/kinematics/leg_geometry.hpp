// The dimensions of a leg whose inverse kinematics has a closed form, recognised from the robot model.
//
// Such a leg has hip yaw, roll and pitch axes that meet in one point at right angles, in any order, knee and
// ankle pitch axes parallel to the hip pitch axis, and an ankle roll axis that meets the ankle pitch axis at
// a right angle, before or behind it.
//
// All quantities are taken in the zero posture. The leg's own axes are y along the hip pitch axis, z along
// the hip yaw axis, x = y × z. Lengths in m.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

#include "gaitway/kinematics/leg_solution.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {

struct LegGeometry {
  Eigen::Matrix3d base_from_leg = Eigen::Matrix3d::Identity();  // columns: the leg's axes in the base frame
  Eigen::Matrix3d sole_from_leg = Eigen::Matrix3d::Identity();  // the same axes in the sole frame
  Eigen::Vector3d hip_m = Eigen::Vector3d::Zero();              // where the hip axes meet, base frame
  Eigen::Vector3d ankle_m = Eigen::Vector3d::Zero();            // sole to ankle centre, along the leg's axes
  Eigen::Vector2d thigh_m = Eigen::Vector2d::Zero();            // hip to knee, x and z
  Eigen::Vector2d shin_m = Eigen::Vector2d::Zero();             // knee to ankle, x and z
  double lateral_m = 0.0;                                       // hip to ankle, y
  Eigen::Vector2d ankle_roll_axis = Eigen::Vector2d::UnitX();   // x and z; its sign picks the upright posture
  std::array<double, 6>
      axis_sign{};  // [LegJoint] +1: the joint turns about the axis named above, -1: against it
  std::array<Eigen::Index, 3> hip_order{2, 0,
                                        1};  // the leg's axes (0 x, 1 y, 2 z) of its joints from the base on
  bool ankle_rolls_first = false;            // before it pitches
  double knee_sign = 1.0;                    // side to which the knee bends, about y
  LegLimits limits;
};

struct LegRecognition {
  std::optional<LegGeometry> geometry;
  std::string reason;  // why the leg has no closed form; empty if it has one
};

// Lengths are compared to 1 µm and directions to 1 µrad.
[[nodiscard]] LegRecognition recognise_leg(const urdf::RobotModel& model, urdf::Side side);

// The same for the leg with a closed form that is nearest to this one: the axes turned to right angles and
// moved until they meet. Its posture for a pose is a start for iterations. Nothing if there is no such leg.
[[nodiscard]] std::optional<LegGeometry> nearest_closed_form(const urdf::RobotModel& model, urdf::Side side);

// Why the leg's six joints are not the chain from the base to the sole; empty if they are.
[[nodiscard]] std::string leg_chain_fault(const urdf::RobotModel& model, urdf::Side side);

// Where the hip axes meet, base frame, m: the point whose height above the ground is the hip height. For a
// leg whose axes do not meet: the point of the pitch axis that is nearest to the roll axis in the zero
// posture. (It is the pitch axis whose height robot.yaml gives.)
[[nodiscard]] Eigen::Vector3d hip_centre(const urdf::RobotModel& model, urdf::Side side);

}  // namespace gaitway::kinematics
