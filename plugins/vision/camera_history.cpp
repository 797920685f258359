// The camera's pose by the joints' angles, the trunk's attitude, and the foot that stands.
#include "gaitway/vision/camera_history.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "gaitway/facts/facts.hpp"

namespace gaitway::vision {
namespace {

bool is_finite(const JointStates& joints, const Estimate& estimate) noexcept {
  double sum = 0.0;
  for (std::size_t j = 0; j < joints.joint_count; ++j) sum += joints.position[j];
  for (std::size_t i = 0; i < 3; ++i) {
    sum += estimate.odometry_base[i] + estimate.attitude[i] + estimate.odometry_foot[0][i] +
           estimate.odometry_foot[1][i];
  }
  return std::isfinite(sum);
}

Eigen::Quaterniond turned(double yaw_rad, const Eigen::Quaterniond& upright) {
  return Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) * upright;
}

}  // namespace

CameraHistory::CameraHistory(const urdf::RobotModel& robot, int link, const Eigen::Isometry3d& camera)
    : kinematics_(robot),
      joint_count_(robot.joints.size()),
      link_(link),
      trunk_(robot.imu.link),
      camera_(camera) {}

void CameraHistory::add(const JointStates& joints, const Estimate& estimate) noexcept {
  const std::int64_t stamp_ns = joints.stamp_ns - joints.stamp_ns % facts::kSlot_ns;
  if (joints.joint_count != joint_count_ || !is_finite(joints, estimate)) return;
  if (count_ > 0 && stamp_ns <= back(0).stamp_ns) return;
  kinematics_.compute(std::span(joints.position).first(joint_count_));

  // The trunk's roll and pitch are known against gravity, the base's heading in odometry.
  const Eigen::Quaterniond tilt = Eigen::AngleAxisd(estimate.attitude[1], Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(estimate.attitude[0], Eigen::Vector3d::UnitX());
  const Eigen::Quaterniond level_from_base =
      tilt * Eigen::Quaterniond(kinematics_.link_rotation(trunk_)).conjugate();
  const Eigen::Vector3d ahead = level_from_base * Eigen::Vector3d::UnitX();
  const Eigen::Quaterniond odometry_from_base =
      turned(estimate.odometry_base[2] - std::atan2(ahead.y(), ahead.x()), level_from_base);

  const auto support = estimate.support == estimate::support::right ? urdf::Side::right : urdf::Side::left;
  const double* const foot = estimate.odometry_foot[urdf::index_of(support)];
  const Eigen::Isometry3d camera_in_base = kinematics_.link_pose(link_) * camera_;
  const Eigen::Vector3d from_sole_m =
      camera_in_base.translation() - kinematics_.sole_pose(support).translation();

  Moment& moment = moments_[count_ % kRemembered];
  moment.stamp_ns = stamp_ns;
  moment.rotation = odometry_from_base * Eigen::Quaterniond(camera_in_base.linear());
  moment.position_m = Eigen::Vector3d(foot[0], foot[1], 0.0) + odometry_from_base * from_sole_m;
  moment.base_m = {estimate.odometry_base[0], estimate.odometry_base[1]};
  moment.upright = estimate.fall == estimate::fall::upright;
  ++count_;
}

std::optional<CameraPose> CameraHistory::at(std::int64_t stamp_ns) const noexcept {
  if (count_ < 2 || stamp_ns > back(0).stamp_ns + facts::kSlot_ns) return std::nullopt;
  const std::size_t known = std::min(count_, kRemembered);
  std::size_t before = 1;
  while (before < known && back(before).stamp_ns > stamp_ns) ++before;
  if (before == known) return std::nullopt;
  const Moment& a = back(before);
  const Moment& b = back(before - 1);
  const double share =
      static_cast<double>(stamp_ns - a.stamp_ns) / static_cast<double>(b.stamp_ns - a.stamp_ns);
  CameraPose found;
  found.pose.linear() = a.rotation.slerp(share, b.rotation).toRotationMatrix();
  found.pose.translation() = a.position_m + share * (b.position_m - a.position_m);
  found.base_m = a.base_m + share * (b.base_m - a.base_m);
  found.upright = a.upright && b.upright;
  return found;
}

}  // namespace gaitway::vision
