// The tree pass: p_child = p + R·o, R_child = R·R_o·R(axis, q), CoM = Σ (m_i/M)(p_i + R_i·c_i).
#include "gaitway/urdf/forward_kinematics.hpp"

#include <cassert>
#include <cmath>
#include <stdexcept>

namespace gaitway::urdf {
namespace {

// Turns columns a and b of a rotation by an angle in their plane: the first towards the second.
void turn_columns(Eigen::Matrix3d& rotation, int a, int b, double sine, double cosine) noexcept {
  const Eigen::Vector3d first = rotation.col(a);
  const Eigen::Vector3d second = rotation.col(b);
  rotation.col(a) = cosine * first + sine * second;
  rotation.col(b) = cosine * second - sine * first;
}

}  // namespace

ForwardKinematics::ForwardKinematics(const RobotModel& model) : poses_(model.links.size()) {
  const double total_mass_kg = model.total_mass_kg();
  base_share_m_ = model.links.front().com_m * (model.links.front().mass_kg / total_mass_kg);
  std::vector<double> home_rad;
  for (const Joint& joint : model.joints) {
    assert(joint.child_link == static_cast<int>(steps_.size()) + 1 && joint.parent_link < joint.child_link);
    const Link& child = model.links[static_cast<std::size_t>(joint.child_link)];
    Step step;
    step.parent = static_cast<std::size_t>(joint.parent_link);
    step.origin_m = joint.origin.translation();
    step.origin_rotation = joint.origin.linear();
    step.turned_origin = !step.origin_rotation.isIdentity(1e-15);
    step.axis = joint.axis;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(joint.axis[axis]) == 1.0) {
        step.axis_kind = static_cast<AxisKind>(axis);
        step.sign = joint.axis[axis];
      }
    }
    step.share = child.mass_kg / total_mass_kg;
    step.share_m = child.com_m * step.share;
    steps_.push_back(step);
    home_rad.push_back(joint.home_rad);
  }
  for (std::size_t side = 0; side < sole_.size(); ++side) {
    foot_link_[side] = static_cast<std::size_t>(model.feet[side].link);
    sole_[side] = model.feet[side].sole;
  }
  compute(home_rad);
}

void ForwardKinematics::turn(Eigen::Matrix3d& rotation, const Step& step, double angle_rad) noexcept {
  const double sine = step.sign * std::sin(angle_rad);
  const double cosine = std::cos(angle_rad);
  switch (step.axis_kind) {
    case AxisKind::x:
      return turn_columns(rotation, 1, 2, sine, cosine);
    case AxisKind::y:
      return turn_columns(rotation, 2, 0, sine, cosine);
    case AxisKind::z:
      return turn_columns(rotation, 0, 1, sine, cosine);
    case AxisKind::general:
      rotation = (rotation * Eigen::AngleAxisd(angle_rad, step.axis).toRotationMatrix()).eval();
  }
}

void ForwardKinematics::compute(std::span<const double> position_rad) noexcept {
  assert(position_rad.size() == steps_.size());
  com_m_ = base_share_m_;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    const Pose& parent = poses_[step.parent];
    Pose& child = poses_[i + 1];
    child.position_m.noalias() = parent.position_m + parent.rotation * step.origin_m;
    if (step.turned_origin) {
      child.rotation.noalias() = parent.rotation * step.origin_rotation;
    } else {
      child.rotation = parent.rotation;
    }
    turn(child.rotation, step, position_rad[i]);
    com_m_.noalias() += step.share * child.position_m;
    com_m_.noalias() += child.rotation * step.share_m;
  }
}

Eigen::Isometry3d ForwardKinematics::link_pose(int link) const noexcept {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = link_rotation(link);
  pose.translation() = link_position_m(link);
  return pose;
}

Eigen::Isometry3d ForwardKinematics::sole_pose(Side side) const noexcept {
  const auto index = static_cast<std::size_t>(side);
  return link_pose(static_cast<int>(foot_link_[index])) * sole_[index];
}

double home_com_height_m(const RobotModel& model) {
  const ForwardKinematics home(model);
  const double height_m = home.com_m().z() - home.sole_pose(Side::left).translation().z();
  if (!(height_m > 0.0)) {
    throw std::invalid_argument("the CoM of robot '" + model.name +
                                "' is not above its soles in the home posture; check home_deg in robot.yaml");
  }
  return height_m;
}

}  // namespace gaitway::urdf
