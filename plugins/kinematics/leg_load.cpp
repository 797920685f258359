// Chains the leg from the base to the foot, and sums moments from the foot to the base.
#include "gaitway/kinematics/leg_load.hpp"

#include <cmath>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::kinematics {
namespace {

using facts::kGravity_m_per_s2;
constexpr double kFrictionSpeed_rad_per_s =
    0.2;  // below it, dry friction is taken in proportion to the speed

}  // namespace

LegLoad::LegLoad(const urdf::RobotModel& model, urdf::Side side) {
  urdf::ForwardKinematics zero(model);
  zero.compute(std::vector<double>(model.joints.size(), 0.0));
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  const urdf::Leg& leg = model.legs[static_cast<std::size_t>(side)];
  for (std::size_t i = 0; i < 6; ++i) {
    const urdf::Joint& joint = model.joints.at(static_cast<std::size_t>(leg.joints[i]));
    const urdf::Link& link = model.links.at(static_cast<std::size_t>(joint.child_link));
    const Eigen::Isometry3d pose = zero.link_pose(joint.child_link);
    axis_[i] = pose.linear() * joint.axis.normalized();
    offset_m_[i] = pose.translation() - before;
    com_m_[i] = pose * link.com_m - pose.translation();
    mass_kg_[i] = link.mass_kg;
    motor_[i] = joint.motor;
    before = pose.translation();
  }
}

LegPlaces LegLoad::places(const Eigen::Isometry3d& base,
                          const std::array<double, 6>& angle_rad) const noexcept {
  LegPlaces places;
  Eigen::Matrix3d rotation = base.linear();
  Eigen::Vector3d position = base.translation();
  for (std::size_t i = 0; i < 6; ++i) {
    position += rotation * offset_m_[i];
    places.joint_m[i] = position;
    places.axis[i] = rotation * axis_[i];
    rotation = rotation * Eigen::AngleAxisd(angle_rad[i], axis_[i]).toRotationMatrix();
    places.com_m[i] = position + rotation * com_m_[i];
  }
  return places;
}

std::array<double, 6> LegLoad::torque_Nm(const LegPlaces& places,
                                         const std::array<Eigen::Vector3d, 6>& acceleration_m_per_s2,
                                         const std::array<double, 6>& speed_rad_per_s,
                                         const std::array<double, 6>& acceleration_rad_per_s2,
                                         const GroundForce& ground) const noexcept {
  // Of all that is needed behind the joint: a force, and its moment about the frame's origin.
  Eigen::Vector3d force = -ground.force_N;
  Eigen::Vector3d moment = -ground.point_m.cross(ground.force_N);
  std::array<double, 6> torque{};
  for (std::size_t i = 6; i-- > 0;) {
    const Eigen::Vector3d needed =
        mass_kg_[i] * (acceleration_m_per_s2[i] + Eigen::Vector3d(0.0, 0.0, kGravity_m_per_s2));
    force += needed;
    moment += places.com_m[i].cross(needed);
    torque[i] = places.axis[i].dot(moment - places.joint_m[i].cross(force)) +
                motor_[i].armature_kg_m2 * acceleration_rad_per_s2[i] +
                motor_[i].damping_Nms_per_rad * speed_rad_per_s[i] +
                motor_[i].friction_Nm * std::tanh(speed_rad_per_s[i] / kFrictionSpeed_rad_per_s);
  }
  return torque;
}

}  // namespace gaitway::kinematics
