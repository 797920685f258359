// Inertia of what the hips carry, about each of their axes.
#include "gaitway/stability/body_balance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/leg_joints.hpp"

namespace gaitway::stability {
namespace {

constexpr double kMostHipRateGain_s = 1.5 * facts::kSlot_s;  // humanoid22's
// Of a turn of the hips, what answers the trunk's rate: humanoid22's share. At 0.75, light bodies tremble.
constexpr double kMostAnswer = 0.615;

// Links that move with the trunk while the feet stand.
std::vector<bool> links_above_hips(const urdf::RobotModel& robot) {
  std::vector<bool> above(robot.links.size(), true);
  for (const urdf::Leg& leg : robot.legs) {
    for (const int index : leg.joints) {
      above[static_cast<std::size_t>(robot.joints[static_cast<std::size_t>(index)].child_link)] = false;
    }
  }
  for (const urdf::Joint& joint : robot.joints) {  // parents before children: toes
    if (!above[static_cast<std::size_t>(joint.parent_link)]) {
      above[static_cast<std::size_t>(joint.child_link)] = false;
    }
  }
  return above;
}

// What the hip joint of either leg turns at this axis, at the home posture: trunk and rotors.
double carried_inertia_kg_m2(const urdf::RobotModel& robot, const urdf::ForwardKinematics& home,
                             const std::array<const urdf::Joint*, 2>& hips) {
  const Eigen::Vector3d place_m =
      0.5 * (home.link_position_m(hips[0]->child_link) + home.link_position_m(hips[1]->child_link));
  const Eigen::Vector3d axis = home.link_rotation(hips[0]->child_link) * hips[0]->axis;
  const std::vector<bool> above = links_above_hips(robot);
  double inertia_kg_m2 = hips[0]->motor.armature_kg_m2 + hips[1]->motor.armature_kg_m2;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (!above[i]) continue;
    const urdf::Link& link = robot.links[i];
    const Eigen::Isometry3d pose = home.link_pose(static_cast<int>(i));
    const Eigen::Vector3d axis_in_link = pose.linear().transpose() * axis;
    inertia_kg_m2 += axis_in_link.dot(link.inertia_kg_m2 * axis_in_link) +
                     link.mass_kg * axis.cross(pose * link.com_m - place_m).squaredNorm();
  }
  return inertia_kg_m2;
}

double largest_rate_gain_s(const urdf::RobotModel& robot, const urdf::ForwardKinematics& home,
                           urdf::LegJoint which) {
  std::array<const urdf::Joint*, 2> hips{};
  for (const urdf::Side side : urdf::kSides) {
    const int index = urdf::LegJoints(robot, home, side)[which];
    hips[urdf::index_of(side)] = &robot.joints[static_cast<std::size_t>(index)];
  }
  const double damping_Nms_per_rad = hips[0]->servo.damping_Nms_per_rad + hips[1]->servo.damping_Nms_per_rad;
  const double inertia_kg_m2 = carried_inertia_kg_m2(robot, home, hips);
  const double followed = -std::expm1(-facts::kSlot_s * damping_Nms_per_rad / inertia_kg_m2);
  return std::min(kMostHipRateGain_s, kMostAnswer * facts::kSlot_s / followed);
}

}  // namespace

BalanceParameters balance_of(const urdf::RobotModel& robot) {
  BalanceParameters balance;
  scale_to_body(balance.numbers(), robot.body_scale());
  const urdf::ForwardKinematics home(robot);
  const auto limit = [&](JointGain& gain, urdf::LegJoint which) {
    gain.rate_rad_per_rad_per_s =
        std::min(gain.rate_rad_per_rad_per_s, largest_rate_gain_s(robot, home, which));
  };
  limit(balance.hip_pitch, urdf::LegJoint::hip_pitch);
  limit(balance.hip_roll, urdf::LegJoint::hip_roll);
  return balance;
}

}  // namespace gaitway::stability
