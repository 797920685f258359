// Robots of a few links, of which everything is known in closed form; and trajectories that stand still.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "gaitway/kinematic/play.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematic::test {

// A base that is both feet at once: its sole frames lie on the floor, 0.1 m to either side.
inline urdf::RobotModel standing_base() {
  urdf::RobotModel robot;
  robot.name = "hand-made";
  urdf::Link base;
  base.name = "base";
  base.mass_kg = 2.0;
  base.com_m = {0.01, 0.0, 0.4};
  base.inertia_kg_m2 = Eigen::Vector3d(0.02, 0.03, 0.01).asDiagonal();
  robot.links.push_back(base);
  for (const urdf::Side side : urdf::kSides) {
    urdf::Foot& foot = robot.feet[urdf::index_of(side)];
    foot.link = 0;
    foot.sole.translation().y() = side == urdf::Side::left ? 0.1 : -0.1;
    foot.size_m = {0.2, 0.1};
  }
  return robot;
}

// A link that hangs at `place_m` of the base and turns about y.
inline urdf::Joint& add_pendulum(urdf::RobotModel& robot, const Eigen::Vector3d& place_m, double mass_kg,
                                 double length_m, double inertia_kg_m2) {
  urdf::Link link;
  link.name = "bob" + std::to_string(robot.links.size());
  link.parent_joint = static_cast<int>(robot.joints.size());
  link.mass_kg = mass_kg;
  link.com_m = {0.0, 0.0, -length_m};
  link.inertia_kg_m2 = inertia_kg_m2 * Eigen::Matrix3d::Identity();
  urdf::Joint joint;
  joint.name = "hinge" + std::to_string(robot.joints.size());
  joint.child_link = static_cast<int>(robot.links.size());
  joint.origin.translation() = place_m;
  joint.axis = Eigen::Vector3d::UnitY();
  joint.lower_rad = -2.0;
  joint.upper_rad = 2.0;
  joint.velocity_limit_rad_per_s = 50.0;
  joint.count_rad = 0.001;
  joint.motor = {.torque_limit_Nm = 100.0, .speed_limit_rad_per_s = 60.0};
  robot.links.push_back(link);
  robot.joints.push_back(joint);
  return robot.joints.back();
}

// Of a robot that stands where it is for so many rows, all joints at home.
inline Trajectory at_home(const urdf::RobotModel& robot, std::size_t rows) {
  Trajectory trajectory{.name = "test", .kind = "test", .joint_count = robot.joints.size()};
  for (std::size_t row = 0; row < rows; ++row) {
    for (const urdf::Joint& joint : robot.joints) trajectory.joint_rad.push_back(joint.home_rad);
  }
  return trajectory;
}

inline Trajectory standing_on_base(const urdf::RobotModel& robot, std::size_t rows) {
  Trajectory trajectory = at_home(robot, rows);
  trajectory.base.assign(rows, Eigen::Isometry3d::Identity());
  trajectory.contact.assign(rows, motion::Contact::both);
  return trajectory;
}

inline double& angle(Trajectory& trajectory, std::size_t row, std::size_t joint) {
  return trajectory.joint_rad[row * trajectory.joint_count + joint];
}

inline const urdf::RobotModel& humanoid22() {
  static const urdf::RobotModel robot = urdf::load_robot(GAITWAY_ROBOT);
  return robot;
}

inline std::vector<Finding> of_rule(const std::vector<Finding>& findings, Rule rule) {
  std::vector<Finding> found;
  for (const Finding& finding : findings) {
    if (finding.rule == rule) found.push_back(finding);
  }
  return found;
}

}  // namespace gaitway::kinematic::test
