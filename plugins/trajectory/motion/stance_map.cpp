// Between planning coordinates and joint angles; the convex hull of the soles.
#include "gaitway/motion/stance_map.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::motion {
namespace {

void put_pose(const Eigen::Isometry3d& pose, Eigen::Index first, Eigen::VectorXd& coordinates) {
  coordinates.segment<3>(first) = pose.translation();
  coordinates.segment<3>(first + 3) = attitude_of(pose.linear());
}

}  // namespace

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& attitude_rad) {
  return (Eigen::AngleAxisd(attitude_rad.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(attitude_rad.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(attitude_rad.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

Eigen::Vector3d attitude_of(const Eigen::Matrix3d& rotation) {
  return {std::atan2(rotation(2, 1), rotation(2, 2)),
          std::atan2(-rotation(2, 0), std::hypot(rotation(2, 1), rotation(2, 2))),
          std::atan2(rotation(1, 0), rotation(0, 0))};
}

Eigen::Isometry3d pose_at(const Eigen::VectorXd& coordinates, Eigen::Index first) {
  Eigen::Isometry3d pose;
  pose.linear() = rotation_of(coordinates.segment<3>(first + 3));
  pose.translation() = coordinates.segment<3>(first);
  pose.makeAffine();
  return pose;
}

StanceMap::StanceMap(const urdf::RobotModel& robot)
    : legs_(robot.legs),
      solvers_{kinematics::LegSolver(robot, urdf::Side::left, kinematics::SolverChoice::automatic),
               kinematics::LegSolver(robot, urdf::Side::right, kinematics::SolverChoice::automatic)} {
  const auto in_leg = [this](int joint) {
    return std::ranges::any_of(legs_, [joint](const urdf::Leg& leg) {
      return std::ranges::find(leg.joints, joint) != leg.joints.end();
    });
  };
  for (int joint = 0; joint < static_cast<int>(robot.joints.size()); ++joint) {
    if (!in_leg(joint)) others_.push_back(joint);
  }
}

double StanceMap::joints(const Eigen::VectorXd& coordinates, Eigen::VectorXd& joint_rad) {
  for (std::size_t i = 0; i < others_.size(); ++i) {
    joint_rad[others_[i]] = coordinates[kOthers + static_cast<Eigen::Index>(i)];
  }
  const Eigen::Isometry3d ground_to_pelvis = pose_at(coordinates, kPelvis).inverse();
  double excess_m = 0.0;
  for (std::size_t side = 0; side < 2; ++side) {
    const kinematics::LegSolution leg =
        solvers_[side].solve(ground_to_pelvis * pose_at(coordinates, kSole[side]));
    if (!leg.reached() && leg.status != kinematics::LegStatus::joint_limit) {
      excess_m = std::max(excess_m, leg.excess);
      continue;
    }
    for (std::size_t i = 0; i < 6; ++i) {
      joint_rad[legs_[side].joints[i]] = leg.angle_rad[i];
    }
  }
  return excess_m;
}

Eigen::VectorXd StanceMap::coordinates(const Eigen::Isometry3d& pelvis,
                                       const std::array<Eigen::Isometry3d, 2>& sole,
                                       const Eigen::VectorXd& joint_rad) const {
  Eigen::VectorXd result(size());
  put_pose(pelvis, kPelvis, result);
  for (std::size_t side = 0; side < 2; ++side) {
    put_pose(sole[side], kSole[side], result);
  }
  for (std::size_t i = 0; i < others_.size(); ++i) {
    result[kOthers + static_cast<Eigen::Index>(i)] = joint_rad[others_[i]];
  }
  return result;
}

SupportArea support_area(const urdf::RobotModel& robot, Contact contact,
                         const std::array<Eigen::Isometry3d, 2>& sole) {
  std::vector<Eigen::Vector2d> corners;
  for (const urdf::Side side : urdf::kSides) {
    if (!stands_on(contact, side)) continue;
    const auto i = static_cast<std::size_t>(side);
    for (const Eigen::Vector2d& corner : robot.feet[i].corners_m())
      corners.emplace_back((sole[i] * Eigen::Vector3d(corner.x(), corner.y(), 0.0)).head<2>());
  }
  return SupportArea(corners);
}

Eigen::Vector2d sole_centre(const urdf::Foot& foot, const Eigen::Isometry3d& sole) {
  return (sole * Eigen::Vector3d(foot.centre_m.x(), foot.centre_m.y(), 0.0)).head<2>();
}

}  // namespace gaitway::motion
