// Plain forward kinematics, link by link: what the tests measure the solvers against.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics::test {

// base_from_link of every link for the given joint angles, order of RobotModel::joints.
inline std::vector<Eigen::Isometry3d> link_poses(const urdf::RobotModel& model,
                                                 std::span<const double> angle_rad) {
  std::vector<Eigen::Isometry3d> poses(model.links.size(), Eigen::Isometry3d::Identity());
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const urdf::Joint& joint = model.joints[i];
    poses[static_cast<std::size_t>(joint.child_link)] = poses[static_cast<std::size_t>(joint.parent_link)] *
                                                        joint.origin *
                                                        Eigen::AngleAxisd(angle_rad[i], joint.axis);
  }
  return poses;
}

inline std::vector<double> home_posture(const urdf::RobotModel& model) {
  std::vector<double> home;
  home.reserve(model.joints.size());
  for (const urdf::Joint& joint : model.joints) home.push_back(joint.home_rad);
  return home;
}

inline Eigen::Isometry3d sole_pose(const urdf::RobotModel& model, urdf::Side side,
                                   std::span<const double> angle_rad) {
  const urdf::Foot& foot = model.feet[static_cast<std::size_t>(side)];
  return link_poses(model, angle_rad)[static_cast<std::size_t>(foot.link)] * foot.sole;
}

}  // namespace gaitway::kinematics::test
