// level = Rz(-heading of the sole) * tilt of the trunk * (trunk to base)^T.
#include "gaitway/zmp/support_kinematics.hpp"

#include <cmath>

namespace gaitway::zmp {
void SupportKinematics::update_levels(const Attitude& attitude) noexcept {
  yaw_rad_ = attitude.yaw_rad;
  const Eigen::Matrix3d upright_from_base = attitude.tilt() * kinematics_.link_rotation(trunk_).transpose();
  for (const urdf::Side side : urdf::kSides) {
    const std::size_t i = index_of(side);
    base_from_sole_[i] = kinematics_.sole_pose(side);
    const Eigen::Vector3d forward = upright_from_base * base_from_sole_[i].linear().col(0);
    heading_rad_[i] = std::atan2(forward.y(), forward.x());
    level_from_base_[i] = Eigen::AngleAxisd(-heading_rad_[i], Eigen::Vector3d::UnitZ()) * upright_from_base;
  }
}

Eigen::Vector3d SupportKinematics::com_m(urdf::Side foot) const noexcept {
  const std::size_t i = index_of(foot);
  return level_from_base_[i] * (kinematics_.com_m() - base_from_sole_[i].translation());
}

Eigen::Vector3d SupportKinematics::sole_point_m(urdf::Side foot, urdf::Side of,
                                                const Eigen::Vector2d& point_m) const noexcept {
  const std::size_t i = index_of(foot);
  const Eigen::Vector3d in_base =
      base_from_sole_[index_of(of)] * Eigen::Vector3d(point_m.x(), point_m.y(), 0.0);
  return level_from_base_[i] * (in_base - base_from_sole_[i].translation());
}

Eigen::Matrix3d SupportKinematics::turn(urdf::Side to, urdf::Side from) const noexcept {
  return level_from_base_[index_of(to)] * level_from_base_[index_of(from)].transpose();
}

}  // namespace gaitway::zmp
