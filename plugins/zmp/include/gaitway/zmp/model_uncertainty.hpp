// What the robot's description does not know about the robot, and what that does to CoM and feet.
#pragma once

#include <Eigen/Core>

#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/zmp/estimator_parameters.hpp"

namespace gaitway::zmp {

// Standard deviations at the home posture, in the level frame of a foot. No filter makes them smaller: they
// are the same in every sample.
struct ModelUncertainty {
  Eigen::Vector3d com_m = Eigen::Vector3d::Zero();   // from joint zeros, link masses, the trunk's CoM
  Eigen::Vector3d foot_m = Eigen::Vector3d::Zero();  // of the other foot's sole, from joint zeros
};

// Perturbs one joint zero after another, and adds up the squares. Not for real-time paths.
[[nodiscard]] ModelUncertainty model_uncertainty(const urdf::RobotModel& model,
                                                 const EstimatorParameters& parameters);

}  // namespace gaitway::zmp
