// The centre of mass from nested masses of the legs, and Newton's iteration on its horizontal position.
#include "gaitway/kinematics/whole_body_placement.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
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

constexpr int kPlacementIterationLimit = 12;
constexpr double kProbe_m = 1e-3;  // shift of the base with which the sensitivity is measured

Eigen::Matrix3d about_z(double angle_rad) noexcept {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  Eigen::Matrix3d rotation;
  rotation << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  return rotation;
}

// The standing posture as a plan point with the base above the origin.
PlanPoint standing_point(const urdf::RobotModel& model, const Eigen::Vector3d& hip_middle_m) {
  const urdf::ForwardKinematics home(model);
  PlanPoint point;
  std::array<Eigen::Isometry3d, 2> sole;
  for (const urdf::Side side : urdf::kSides) {
    const auto i = static_cast<std::size_t>(side);
    sole[i] = home.sole_pose(side);
    point.foot_m[i] = sole[i].translation();
    point.foot_m[i].z() -= sole[0].translation().z();
    point.foot_yaw_rad[i] = std::atan2(sole[i](1, 0), sole[i](0, 0));
  }
  point.hip_height_m = hip_middle_m.z() - sole[0].translation().z();
  return point;
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

WholeBodyPlacement::WholeBodyPlacement(const urdf::RobotModel& model, SolverChoice choice)
    : legs_{LegSolver(model, urdf::Side::left, choice), LegSolver(model, urdf::Side::right, choice)},
      mass_(model),
      hip_middle_m_(0.5 * (hip_centre(model, urdf::Side::left) + hip_centre(model, urdf::Side::right))) {
  measure_sensitivity(model);
}

void WholeBodyPlacement::measure_sensitivity(const urdf::RobotModel& model) {
  const PointFrames standing = frames(standing_point(model, hip_middle_m_));
  // With the planned CoM at the origin, the error at an offset is where the CoM is.
  const auto com_m = [&](const Eigen::Vector2d& base_m, Eigen::Vector2d& com) {
    const BothLegs legs = place(standing, base_m);
    if (!legs[0].reached() || !legs[1].reached()) return false;
    com = com_error_m(standing, legs, base_m);
    return true;
  };
  Eigen::Vector2d middle, ahead, behind;
  if (!com_m(Eigen::Vector2d::Zero(), middle)) return;
  standing_offset_m_ = -middle;
  Eigen::Matrix2d com_per_base;
  for (const Eigen::Index axis : {0, 1}) {
    const Eigen::Vector2d probe = kProbe_m * Eigen::Vector2d::Unit(axis);
    if (!com_m(probe, ahead) || !com_m(-probe, behind))
      return;  // a straight leg: the identity serves, slower
    com_per_base.col(axis) = (ahead - behind) / (2.0 * kProbe_m);
  }
  if (std::abs(com_per_base.determinant()) > 0.05) base_per_com_ = com_per_base.inverse();
}

PointFrames WholeBodyPlacement::frames(const PlanPoint& point) const noexcept {
  PointFrames frames;
  const double roll = point.base_attitude_rad.x();
  const double pitch = point.base_attitude_rad.y();
  const bool tilted = roll != 0.0 || pitch != 0.0;
  if (tilted) {
    frames.heading_from_base = (Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  } else {
    frames.heading_from_base.setIdentity();
  }
  frames.base_height_m = point.hip_height_m - frames.heading_from_base.row(2).dot(hip_middle_m_);
  const double c = std::cos(point.base_yaw_rad);
  const double s = std::sin(point.base_yaw_rad);
  for (std::size_t i = 0; i < 2; ++i) {
    const double x = point.foot_m[i].x() - point.com_m.x();
    const double y = point.foot_m[i].y() - point.com_m.y();
    frames.foot_m[i] = {c * x + s * y - point.com_offset_m.x(), c * y - s * x - point.com_offset_m.y(),
                        point.foot_m[i].z()};
    frames.base_from_sole[i] = about_z(point.foot_yaw_rad[i] - point.base_yaw_rad) *
                               Eigen::AngleAxisd(-point.toe_up_rad[i], Eigen::Vector3d::UnitY());
    if (tilted) frames.base_from_sole[i] = frames.heading_from_base.transpose() * frames.base_from_sole[i];
  }
  return frames;
}

BothLegs WholeBodyPlacement::place(const PointFrames& frames, const Eigen::Vector2d& offset_m,
                                   const std::optional<LegAngles>& start_rad) {
  const Eigen::Vector3d base(offset_m.x(), offset_m.y(), frames.base_height_m);
  BothLegs solutions;
  for (std::size_t i = 0; i < 2; ++i) {
    Eigen::Isometry3d base_from_sole;
    base_from_sole.linear() = frames.base_from_sole[i];
    base_from_sole.translation() = frames.heading_from_base.transpose() * (frames.foot_m[i] - base);
    base_from_sole.makeAffine();
    solutions[i] =
        start_rad ? legs_[i].solve(base_from_sole, (*start_rad)[i]) : legs_[i].solve(base_from_sole);
  }
  return solutions;
}

Eigen::Vector2d WholeBodyPlacement::com_error_m(const PointFrames& frames, const BothLegs& legs,
                                                const Eigen::Vector2d& offset_m) const noexcept {
  const Eigen::Vector3d com = mass_.com_m(legs[0].angle_rad, legs[1].angle_rad);
  return offset_m + (frames.heading_from_base * com).head<2>();
}

WholeBodyPlacement::Result WholeBodyPlacement::place_com(const PointFrames& frames,
                                                         const Eigen::Vector2d& guess_m, double tolerance_m,
                                                         std::optional<LegAngles> start_rad) {
  Result result{{}, guess_m, guess_m, false};
  for (int i = 0; i < kPlacementIterationLimit; ++i) {
    result.offset_m = result.refined_m;
    result.legs = place(frames, result.offset_m, start_rad);
    if (!result.legs[0].reached() || !result.legs[1].reached()) return result;
    const Eigen::Vector2d error = com_error_m(frames, result.legs, result.offset_m);
    result.refined_m = result.offset_m - base_per_com_ * error;
    result.converged = error.squaredNorm() <= tolerance_m * tolerance_m;
    if (result.converged) return result;
    start_rad = {result.legs[0].angle_rad, result.legs[1].angle_rad};
  }
  return result;
}

}  // namespace gaitway::kinematics
