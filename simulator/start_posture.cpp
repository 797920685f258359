// How the body stands where it begins: in the posture that is asked, on the sole that is lower, or in the
// home posture on both.
#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "plant_implementation.hpp"

namespace gaitway::simulator {
namespace {

// On which sole a robot with these joints stands, and how its base lies then: with heading 0, above its own
// place.
struct Stand {
  Eigen::Quaterniond base_tilt = Eigen::Quaterniond::Identity();
  std::array<Eigen::Isometry3d, 2> soles{};  // in the frame of the base without its tilt
  double height_m = 0.0;                     // of the base above the lowest corner of a sole
};

double lowest_corner_m(const urdf::RobotModel& robot, const std::array<Eigen::Isometry3d, 2>& soles) {
  double lowest_m = std::numeric_limits<double>::infinity();
  for (std::size_t side = 0; side < 2; ++side) {
    for (const Eigen::Vector2d& corner : robot.feet[side].corners_m()) {
      lowest_m = std::min(lowest_m, (soles[side] * Eigen::Vector3d(corner.x(), corner.y(), 0.0)).z());
    }
  }
  return lowest_m;
}

// With the one sole level. The other one may be a little askew: joints are measured with errors.
Stand stand_on(const urdf::RobotModel& robot, const std::array<Eigen::Isometry3d, 2>& soles_in_base,
               std::size_t side) {
  Stand stand;
  const Eigen::Vector3d up = soles_in_base[side].linear().col(2);  // of the sole, in the base
  stand.base_tilt = Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ());
  for (std::size_t i = 0; i < 2; ++i) stand.soles[i] = stand.base_tilt * soles_in_base[i];
  stand.height_m = -lowest_corner_m(robot, stand.soles);
  return stand;
}

// In the home posture both soles are level.
Stand stand_in(const urdf::RobotModel& robot, const std::vector<double>& joint_rad, bool is_home) {
  if (joint_rad.size() != robot.joints.size()) {
    throw std::invalid_argument(robot.name + ": a start has " + std::to_string(robot.joints.size()) +
                                " joints, not " + std::to_string(joint_rad.size()));
  }
  for (std::size_t j = 0; j < joint_rad.size(); ++j) {
    const urdf::Joint& joint = robot.joints[j];
    if (!(joint_rad[j] >= joint.lower_rad && joint_rad[j] <= joint.upper_rad)) {
      throw std::invalid_argument(joint.name + " begins at " + std::to_string(joint_rad[j]) +
                                  " rad, but must be from " + std::to_string(joint.lower_rad) + " to " +
                                  std::to_string(joint.upper_rad) + " rad");
    }
  }
  urdf::ForwardKinematics kinematics(robot);
  kinematics.compute(joint_rad);
  const std::array<Eigen::Isometry3d, 2> soles{kinematics.sole_pose(urdf::Side::left),
                                               kinematics.sole_pose(urdf::Side::right)};
  if (is_home)
    return {.soles = soles, .height_m = -std::min(soles[0].translation().z(), soles[1].translation().z())};
  const Stand left = stand_on(robot, soles, 0), right = stand_on(robot, soles, 1);
  return left.soles[0].translation().z() <= left.soles[1].translation().z() ? left : right;
}

}  // namespace

// Posture of the start, soles on the ground; things where the model has them.
void Plant::Implementation::set_home(const std::vector<double>& start_rad) {
  std::vector<double> home_rad = start_rad;
  for (std::size_t j = 0; start_rad.empty() && j < robot.joints.size(); ++j) {
    home_rad.push_back(robot.joints[j].home_rad);
  }
  const Stand stand = stand_in(robot, home_rad, start_rad.empty());
  Eigen::Vector3d place = ground * Eigen::Vector3d(0.0, 0.0, stand.height_m);
  Eigen::Quaterniond rotation = ground * stand.base_tilt;
  if (world) {
    const Eigen::Isometry3d base = world_ground->start_pose(*world, robot, stand.soles, stand.height_m);
    place = base.translation();
    rotation = Eigen::Quaterniond(base.linear()) * stand.base_tilt;
  }
  home.assign(model->qpos0, model->qpos0 + model->nq);
  std::copy_n(place.data(), 3, home.begin());
  home[3] = rotation.w();
  home[4] = rotation.x();
  home[5] = rotation.y();
  home[6] = rotation.z();
  for (std::size_t j = 0; j < home_rad.size(); ++j) {
    home[static_cast<std::size_t>(position_address[j])] = home_rad[j];
  }
}

}  // namespace gaitway::simulator
