// Merges all masses that do not move against the base, and nests those of the legs.
#include "gaitway/kinematics/body_mass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::kinematics {
namespace {

// Which links a leg moves: 0 none, 1 the left one, 2 the right one.
std::vector<int> links_of_legs(const urdf::RobotModel& model) {
  std::vector<int> owner(model.links.size(), 0);
  for (const urdf::Side side : urdf::kSides) {
    for (const int joint : model.legs[static_cast<std::size_t>(side)].joints) {
      const urdf::Joint& leg_joint = model.joints.at(static_cast<std::size_t>(joint));
      owner.at(static_cast<std::size_t>(leg_joint.child_link)) = static_cast<int>(side) + 1;
    }
  }
  for (const urdf::Joint& joint : model.joints) {
    const int parent = owner.at(static_cast<std::size_t>(joint.parent_link));
    if (parent != 0 && owner.at(static_cast<std::size_t>(joint.child_link)) != parent) {
      throw urdf::RobotError(
          fmt::format("{}: joint '{}' hangs on a leg but is none of its six joints", model.name, joint.name));
    }
  }
  return owner;
}

}  // namespace

LegMass::LegMass(const urdf::RobotModel& model, urdf::Side side) {
  urdf::ForwardKinematics zero(model);
  zero.compute(std::vector<double>(model.joints.size(), 0.0));
  const urdf::Leg& leg = model.legs[static_cast<std::size_t>(side)];
  Eigen::Vector3d next_joint = Eigen::Vector3d::Zero();
  for (std::size_t i = 6; i-- > 0;) {
    const urdf::Joint& joint = model.joints.at(static_cast<std::size_t>(leg.joints[i]));
    const urdf::Link& link = model.links.at(static_cast<std::size_t>(joint.child_link));
    const Eigen::Isometry3d pose = zero.link_pose(joint.child_link);
    axis_[i] = pose.linear() * joint.axis.normalized();  // an axis is the same before and after its rotation
    moment_kg_m_[i] = link.mass_kg * (pose * link.com_m - pose.translation()) +
                      mass_kg_ * (next_joint - pose.translation());
    mass_kg_ += link.mass_kg;
    next_joint = pose.translation();
  }
  root_moment_kg_m_ = mass_kg_ * next_joint;
}

Eigen::Vector3d LegMass::moment_kg_m(const std::array<double, 6>& angle_rad) const noexcept {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (std::size_t i = 6; i-- > 0;) {
    moment += moment_kg_m_[i];
    const Eigen::Vector3d across = axis_[i].cross(moment);  // Rodrigues' rotation
    moment += std::sin(angle_rad[i]) * across + (1.0 - std::cos(angle_rad[i])) * axis_[i].cross(across);
  }
  return moment + root_moment_kg_m_;
}

BodyMass::BodyMass(const urdf::RobotModel& model)
    : legs_{LegMass(model, urdf::Side::left), LegMass(model, urdf::Side::right)} {
  const std::vector<int> owner = links_of_legs(model);
  const urdf::ForwardKinematics home(model);
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const urdf::Link& link = model.links[i];
    total_mass_kg_ += link.mass_kg;
    if (owner[i] == 0) rest_moment_kg_m_ += link.mass_kg * (home.link_pose(static_cast<int>(i)) * link.com_m);
  }
  if (!(total_mass_kg_ > 0.0)) {
    throw urdf::RobotError(
        fmt::format("{}: total mass is {} kg; it must be positive", model.name, total_mass_kg_));
  }
}

Eigen::Vector3d BodyMass::com_m(const std::array<double, 6>& left_rad,
                                const std::array<double, 6>& right_rad) const noexcept {
  return (rest_moment_kg_m_ + legs_[0].moment_kg_m(left_rad) + legs_[1].moment_kg_m(right_rad)) /
         total_mass_kg_;
}

}  // namespace gaitway::kinematics
