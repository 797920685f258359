// Moments of the weight about the joints' axes, and of a leg that is swung like a stick.
#include "gaitway/trajectory/joint_torque.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"

namespace gaitway::trajectory {
namespace {

using urdf::LegJoint;
constexpr std::array kLoaded{LegJoint::hip_roll, LegJoint::hip_pitch, LegJoint::knee, LegJoint::ankle_pitch,
                             LegJoint::ankle_roll};
constexpr double kLeastJerkPeak = 5.7735;  // acceleration of a least-jerk way, times time squared over way

// The links beyond a joint.
struct Beyond {
  double mass_kg = 0.0;
  Eigen::Vector3d moment_kg_m = Eigen::Vector3d::Zero();
  double inertia_kg_m2 = 0.0;  // about the joint's axis
};

Beyond beyond(const urdf::RobotModel& robot, const urdf::ForwardKinematics& home, int index) {
  const urdf::Joint& joint = robot.joints[static_cast<std::size_t>(index)];
  const Eigen::Vector3d axis = home.joint_axis(robot, index);
  const Eigen::Vector3d at_m = home.link_position_m(joint.child_link);
  std::vector<bool> carried(robot.links.size(), false);
  Beyond sum;
  for (std::size_t i = static_cast<std::size_t>(joint.child_link); i < robot.links.size(); ++i) {
    const urdf::Link& link = robot.links[i];
    const bool first = i == static_cast<std::size_t>(joint.child_link);
    if (!first && (link.parent_joint < 0 ||
                   !carried[static_cast<std::size_t>(
                       robot.joints[static_cast<std::size_t>(link.parent_joint)].parent_link)])) {
      continue;
    }
    carried[i] = true;
    const Eigen::Vector3d com_m = home.link_pose(static_cast<int>(i)) * link.com_m;
    const Eigen::Vector3d own_axis = home.link_rotation(static_cast<int>(i)).transpose() * axis;
    sum.mass_kg += link.mass_kg;
    sum.moment_kg_m += link.mass_kg * com_m;
    sum.inertia_kg_m2 +=
        own_axis.dot(link.inertia_kg_m2 * own_axis) + link.mass_kg * axis.cross(com_m - at_m).squaredNorm();
  }
  return sum;
}

// What the weight of all that is not beyond the joint turns it with, the body being carried by this leg. The
// base stays upright, so that what is above a hip keeps its place beside it; the ankle's roll bears the
// weight where the ground's force acts.
double holds_Nm(const GaitParameters& p, const urdf::RobotModel& robot, const urdf::ForwardKinematics& home,
                urdf::Side side, LegJoint which, int index) {
  const double mass_kg = robot.total_mass_kg();
  const Eigen::Vector3d at_m = home.link_position_m(robot.joints[static_cast<std::size_t>(index)].child_link);
  if (which == LegJoint::ankle_roll) {
    const double inwards = side == urdf::Side::left ? -1.0 : 1.0;
    const double beside_m = home.sole_pose(side).translation().y() + inwards * p.zmp_inward_m - at_m.y();
    return mass_kg * facts::kGravity_m_per_s2 * std::abs(beside_m);
  }
  const Beyond leg = beyond(robot, home, index);
  const Eigen::Vector3d moment_kg_m = mass_kg * home.com_m() - leg.moment_kg_m;
  const Eigen::Vector3d lever_kg_m = moment_kg_m - (mass_kg - leg.mass_kg) * at_m;
  const Eigen::Vector3d down(0.0, 0.0, -facts::kGravity_m_per_s2);
  return std::abs(home.joint_axis(robot, index).dot(lever_kg_m.cross(down)));
}

double swings_Nm(const GaitParameters& p, const urdf::RobotModel& robot, const urdf::ForwardKinematics& home,
                 int index) {
  const urdf::Joint& joint = robot.joints[static_cast<std::size_t>(index)];
  const Beyond leg = beyond(robot, home, index);
  const double angle_rad = std::max(p.max_step_forward_m, p.max_step_backward_m) / p.hip_height_m;
  const double time_s = p.swing_points() * facts::kSlot_s;
  const Eigen::Vector3d com_m = leg.moment_kg_m / leg.mass_kg - home.link_position_m(joint.child_link);
  const double weight_Nm =
      leg.mass_kg * facts::kGravity_m_per_s2 * std::abs(com_m.z()) * std::sin(0.5 * angle_rad);
  return (leg.inertia_kg_m2 + joint.motor.armature_kg_m2) * kLeastJerkPeak * angle_rad / (time_s * time_s) +
         weight_Nm;
}

// How much of what a joint has it needs.
double share_of(const JointTorque& torque) noexcept {
  return torque.needs_Nm() / std::max(torque.limit_Nm, 1e-9);
}

}  // namespace

std::vector<JointTorque> leg_torques(const GaitParameters& parameters, const urdf::RobotModel& robot) {
  const urdf::ForwardKinematics home(robot);
  std::vector<JointTorque> torques;
  for (const urdf::Side side : urdf::kSides) {
    const urdf::LegJoints joints(robot, home, side);
    for (const LegJoint which : kLoaded) {
      const int index = joints[which];
      JointTorque torque{.index = index, .joint = which};
      torque.holds_Nm = holds_Nm(parameters, robot, home, side, which, index);
      if (which == LegJoint::hip_pitch) torque.swings_Nm = swings_Nm(parameters, robot, home, index);
      torque.limit_Nm = robot.joints[static_cast<std::size_t>(index)].motor.torque_limit_Nm;
      torques.push_back(torque);
    }
  }
  return torques;
}

std::string weakest_joint(const std::vector<JointTorque>& torques, const urdf::RobotModel& robot) {
  const auto less = [](const JointTorque& a, const JointTorque& b) { return share_of(a) < share_of(b); };
  const auto weakest = std::max_element(torques.begin(), torques.end(), less);
  if (weakest == torques.end() || weakest->walks()) return {};
  const bool swings = weakest->swings_Nm > weakest->holds_Nm;
  return fmt::format("joint '{}' needs {:.3g} N*m to walk ({:.3g} to {}), its motor has {:.3g}",
                     robot.joints[static_cast<std::size_t>(weakest->index)].name, weakest->needs_Nm(),
                     swings ? weakest->swings_Nm : weakest->holds_Nm,
                     swings ? "swing the leg" : "stand on one leg", weakest->limit_Nm);
}

void require_strong_enough(const GaitParameters& parameters, const urdf::RobotModel& robot) {
  for (const JointTorque& torque : leg_torques(parameters, robot)) {
    if (torque.holds()) continue;
    throw std::invalid_argument(fmt::format(
        "trajectory: joint '{}' needs {:.3g} N*m to stand on one leg, but its motor has {:.3g} "
        "(torque_limit_Nm). Stand straighter (home angles in robot.yaml), or put a stronger motor there",
        robot.joints[static_cast<std::size_t>(torque.index)].name, torque.holds_Nm, torque.limit_Nm));
  }
}

}  // namespace gaitway::trajectory
