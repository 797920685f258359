// One transform, corrected whenever the robot says where it is.
#include "tools/twin/measured_pose.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::tools {
namespace {

bool known(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double one) { return std::isfinite(one); });
}

double yaw_of(const Eigen::Isometry3d& pose) {
  return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0));
}

Eigen::Isometry3d level_pose(double x_m, double y_m, double yaw_rad) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(x_m, y_m, 0.0);
  pose.linear() = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

}  // namespace

void MeasuredPose::take(const MeasuredPoint& point) {
  const std::vector<double>& v = point.values;
  if (!known(v)) {
    if (point.what == Measurement::joints) joints_rad_.clear();
    if (point.what == Measurement::odometry) base_in_odometry_.reset();
    return;
  }
  if (point.what == Measurement::joints) {
    joints_rad_ = v;
  } else if (point.what == Measurement::odometry) {
    Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
    base.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
    base.linear() = Eigen::Quaterniond(v[6], v[3], v[4], v[5]).normalized().toRotationMatrix();
    base_in_odometry_ = base;
  } else if (point.what == Measurement::place && base_in_odometry_ && !joints_rad_.empty()) {
    map_from_odometry_ = level_pose(v[0], v[1], v[2]) * middle_of_feet().inverse();
  }
}

void MeasuredPose::forget() {
  joints_rad_.clear();
  base_in_odometry_.reset();
  map_from_odometry_.reset();
}

Eigen::Isometry3d MeasuredPose::middle_of_feet() {
  kinematics_.compute(joints_rad_);
  const Eigen::Isometry3d left = *base_in_odometry_ * kinematics_.sole_pose(urdf::Side::left);
  const Eigen::Isometry3d right = *base_in_odometry_ * kinematics_.sole_pose(urdf::Side::right);
  const Eigen::Vector3d middle = (left.translation() + right.translation()) / 2.0;
  const double yaw_rad = yaw_of(right) + std::remainder(yaw_of(left) - yaw_of(right), 2.0 * M_PI) / 2.0;
  return level_pose(middle.x(), middle.y(), yaw_rad);
}

std::optional<Eigen::Isometry3d> MeasuredPose::base() const {
  if (!base_in_odometry_) return std::nullopt;
  return map_from_odometry_.value_or(Eigen::Isometry3d::Identity()) * *base_in_odometry_;
}

}  // namespace gaitway::tools
