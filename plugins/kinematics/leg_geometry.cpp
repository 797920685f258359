// Recognises a leg with a closed-form inverse kinematics from the axes of its joints in the zero posture.
#include "gaitway/kinematics/leg_geometry.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/leg_joints.hpp"

namespace gaitway::kinematics {
namespace {

constexpr double kLengthTolerance_m = 1e-6;
constexpr double kDirectionTolerance = 1e-6;
constexpr double kShortestSegment_m = 1e-3;
constexpr double kLeastAcross = 0.1;  // of an axis that is to be turned to a right angle with another

enum Joint : std::size_t { hip_yaw, hip_roll, hip_pitch, knee, ankle_pitch, ankle_roll };
std::string_view name_of(std::size_t joint) {
  return urdf::leg_joint_name(static_cast<urdf::LegJoint>(joint));
}

struct Line {  // a joint's axis in the base frame, zero posture
  Eigen::Vector3d point;
  Eigen::Vector3d direction;
};
using Axes = std::array<Line, 6>;

urdf::ForwardKinematics zero_posture(const urdf::RobotModel& model) {
  urdf::ForwardKinematics kinematics(model);
  kinematics.compute(std::vector<double>(model.joints.size(), 0.0));
  return kinematics;
}

Line axis_of(const urdf::RobotModel& model, const urdf::ForwardKinematics& zero, int index) {
  const urdf::Joint& joint = model.joints[static_cast<std::size_t>(index)];
  return {zero.link_position_m(joint.child_link), zero.joint_axis(model, index).normalized()};
}

Axes joint_axes(const urdf::RobotModel& model, const urdf::LegJoints& joints,
                const urdf::ForwardKinematics& zero) {
  Axes axes;
  for (std::size_t i = 0; i < 6; ++i) axes[i] = axis_of(model, zero, joints[static_cast<urdf::LegJoint>(i)]);
  return axes;
}

// The leg's axes about which its first three joints turn.
std::array<Eigen::Index, 3> hip_order(const urdf::Leg& leg, const urdf::LegJoints& joints) {
  std::array<Eigen::Index, 3> order{};
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = leg.joints[i] == joints[urdf::LegJoint::hip_yaw]    ? 2
               : leg.joints[i] == joints[urdf::LegJoint::hip_roll] ? 0
                                                                   : 1;
  }
  return order;
}

// The point of the first line that is nearest to the second; the lines must be at right angles.
Eigen::Vector3d nearest_point(const Line& line, const Line& other) {
  return line.point + line.direction * line.direction.dot(other.point - line.point);
}

double distance_to(const Line& line, const Eigen::Vector3d& point) {
  return line.direction.cross(point - line.point).norm();
}

std::string check_directions(const Axes& axes) {
  for (const auto& [a, b] : {std::pair{hip_yaw, hip_roll}, std::pair{hip_roll, hip_pitch},
                             std::pair{hip_yaw, hip_pitch}, std::pair{ankle_pitch, ankle_roll}}) {
    if (std::abs(axes[a].direction.dot(axes[b].direction)) > kDirectionTolerance) {
      return fmt::format("the {} and {} axes are not at right angles", name_of(a), name_of(b));
    }
  }
  for (const auto pitch : {knee, ankle_pitch}) {
    if (axes[hip_pitch].direction.cross(axes[pitch].direction).norm() > kDirectionTolerance) {
      return fmt::format("the {} axis is not parallel to the hip pitch axis", name_of(pitch));
    }
  }
  return {};
}

std::string check_intersections(const Axes& axes, const Eigen::Vector3d& hip, const Eigen::Vector3d& ankle) {
  for (const auto joint : {hip_roll, hip_pitch}) {
    if (const double gap = distance_to(axes[joint], hip); gap > kLengthTolerance_m) {
      return fmt::format("the {} axis misses the point where the hip axes should meet by {:.3f} mm",
                         name_of(joint), gap * 1e3);
    }
  }
  if (const double gap = distance_to(axes[ankle_roll], ankle); gap > kLengthTolerance_m) {
    return fmt::format("the ankle roll axis misses the ankle pitch axis by {:.3f} mm", gap * 1e3);
  }
  return {};
}

double sign_of(double value) {
  return value < 0.0 ? -1.0 : 1.0;
}

// Signed angle about y from the thigh to the shin in the zero posture.
double knee_angle_at_zero(const LegGeometry& geometry) {
  const Eigen::Vector2d& thigh = geometry.thigh_m;
  const Eigen::Vector2d& shin = geometry.shin_m;
  return std::atan2(thigh.y() * shin.x() - thigh.x() * shin.y(), thigh.dot(shin));
}

// The knee bends to the side on which the standing posture has it, or, if that is straight, its limits.
double knee_sign(const LegGeometry& geometry, const urdf::Joint& joint) {
  const double zero = knee_angle_at_zero(geometry);
  const double sign = geometry.axis_sign[knee];
  const double home = std::remainder(zero + sign * joint.home_rad, 2.0 * M_PI);
  if (std::abs(home) > 1e-3) return sign_of(home);
  return sign_of(zero + sign * 0.5 * (joint.lower_rad + joint.upper_rad));
}

// Of the two directions of the ankle roll axis the one with which the hip is above the ankle while standing.
double upright_sign(const Axes& axes, const LegGeometry& geometry, const Eigen::Isometry3d& home_sole) {
  const Eigen::Vector3d roll = geometry.base_from_leg.transpose() * axes[ankle_roll].direction;
  const Eigen::Vector3d ankle_to_hip =
      geometry.sole_from_leg.transpose() * (home_sole.inverse() * geometry.hip_m) - geometry.ankle_m;
  return sign_of(ankle_to_hip.dot(roll.cross(Eigen::Vector3d::UnitY())));
}

LegGeometry measure(const Axes& axes, const Eigen::Vector3d& hip, const Eigen::Vector3d& ankle,
                    const Eigen::Isometry3d& zero_sole) {
  LegGeometry geometry;
  const Eigen::Vector3d y = axes[hip_pitch].direction;
  const Eigen::Vector3d z = axes[hip_yaw].direction;
  const Eigen::Vector3d x = y.cross(z);
  geometry.base_from_leg << x, y, z;
  geometry.sole_from_leg = zero_sole.linear().transpose() * geometry.base_from_leg;
  geometry.hip_m = hip;
  geometry.ankle_m = geometry.base_from_leg.transpose() * (ankle - zero_sole.translation());
  const Eigen::Vector3d hip_to_knee = geometry.base_from_leg.transpose() * (axes[knee].point - hip);
  const Eigen::Vector3d hip_to_ankle = geometry.base_from_leg.transpose() * (ankle - hip);
  geometry.thigh_m = {hip_to_knee.x(), hip_to_knee.z()};
  geometry.shin_m = Eigen::Vector2d(hip_to_ankle.x(), hip_to_ankle.z()) - geometry.thigh_m;
  geometry.lateral_m = hip_to_ankle.y();
  geometry.axis_sign = {1.0,
                        sign_of(axes[hip_roll].direction.dot(x)),
                        1.0,
                        sign_of(axes[knee].direction.dot(y)),
                        sign_of(axes[ankle_pitch].direction.dot(y)),
                        1.0};
  return geometry;
}

// Behind a check that there is a closed form: with the axes of its joints, and where they meet.
LegGeometry geometry_of(const urdf::RobotModel& model, urdf::Side side, const urdf::LegJoints& joints,
                        const Axes& axes, const Eigen::Vector3d& hip, const Eigen::Vector3d& ankle) {
  const urdf::Leg& leg = model.legs[urdf::index_of(side)];
  LegGeometry geometry = measure(axes, hip, ankle, zero_posture(model).sole_pose(side));
  const double upright = upright_sign(axes, geometry, urdf::ForwardKinematics(model).sole_pose(side));
  const Eigen::Vector3d roll = geometry.base_from_leg.transpose() * axes[ankle_roll].direction;
  geometry.ankle_roll_axis = upright * Eigen::Vector2d(roll.x(), roll.z()).normalized();
  geometry.axis_sign[ankle_roll] = upright;
  geometry.knee_sign = knee_sign(geometry, model.joints[static_cast<std::size_t>(leg.joints[knee])]);
  geometry.hip_order = hip_order(leg, joints);
  geometry.ankle_rolls_first = joints[urdf::LegJoint::ankle_roll] == leg.joints[4];
  geometry.limits = leg_limits(model, side);
  return geometry;
}

bool has_segments(const LegGeometry& geometry) {
  return std::min(geometry.thigh_m.norm(), geometry.shin_m.norm()) >= kShortestSegment_m;
}

}  // namespace

std::string leg_chain_fault(const urdf::RobotModel& model, urdf::Side side) {
  const urdf::Leg& leg = model.legs[static_cast<std::size_t>(side)];
  int parent = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const urdf::Joint& joint = model.joints.at(static_cast<std::size_t>(leg.joints[i]));
    if (joint.parent_link != parent) {
      return fmt::format("joint '{}' ({}) does not follow the one before it in the leg", joint.name,
                         name_of(i));
    }
    parent = joint.child_link;
  }
  if (parent != model.feet[static_cast<std::size_t>(side)].link) {
    return "the sole is not on the link that the ankle roll joint moves";
  }
  return {};
}

Eigen::Vector3d hip_centre(const urdf::RobotModel& model, urdf::Side side) {
  const urdf::ForwardKinematics zero = zero_posture(model);
  const urdf::LegJoints joints(model, urdf::ForwardKinematics(model), side);
  const Line roll = axis_of(model, zero, joints[urdf::LegJoint::hip_roll]);
  const Line pitch = axis_of(model, zero, joints[urdf::LegJoint::hip_pitch]);
  const double cosine = roll.direction.dot(pitch.direction);
  const double sine_squared = 1.0 - cosine * cosine;
  if (sine_squared < kDirectionTolerance) return pitch.point;
  const Eigen::Vector3d gap = roll.point - pitch.point;
  const double along = (gap.dot(pitch.direction) - cosine * gap.dot(roll.direction)) / sine_squared;
  return pitch.point + along * pitch.direction;
}

LegRecognition recognise_leg(const urdf::RobotModel& model, urdf::Side side) {
  if (std::string reason = leg_chain_fault(model, side); !reason.empty()) return {std::nullopt, reason};
  const urdf::LegJoints joints(model, urdf::ForwardKinematics(model), side);
  const Axes axes = joint_axes(model, joints, zero_posture(model));
  if (std::string reason = check_directions(axes); !reason.empty()) return {std::nullopt, reason};

  const Eigen::Vector3d hip = nearest_point(axes[hip_yaw], axes[hip_roll]);
  const Eigen::Vector3d ankle = nearest_point(axes[ankle_pitch], axes[ankle_roll]);
  if (std::string reason = check_intersections(axes, hip, ankle); !reason.empty()) {
    return {std::nullopt, reason};
  }
  const LegGeometry geometry = geometry_of(model, side, joints, axes, hip, ankle);
  if (!has_segments(geometry)) {
    return {std::nullopt, "the knee axis coincides with the hip or the ankle pitch axis"};
  }
  return {geometry, {}};
}

std::optional<LegGeometry> nearest_closed_form(const urdf::RobotModel& model, urdf::Side side) {
  const urdf::LegJoints joints(model, urdf::ForwardKinematics(model), side);
  Axes axes = joint_axes(model, joints, zero_posture(model));
  const Eigen::Vector3d& y = axes[hip_pitch].direction;
  for (const auto upright : {hip_yaw, ankle_roll}) {
    Eigen::Vector3d& axis = axes[upright].direction;
    axis -= y * y.dot(axis);
    if (axis.norm() < kLeastAcross) return std::nullopt;
    axis.normalize();
  }
  const Eigen::Vector3d ankle = nearest_point(axes[ankle_pitch], axes[ankle_roll]);
  const LegGeometry geometry = geometry_of(model, side, joints, axes, hip_centre(model, side), ankle);
  if (!has_segments(geometry)) return std::nullopt;
  return geometry;
}

}  // namespace gaitway::kinematics
