// Convex hull of the soles that stand.
#include "gaitway/motion/support_area.hpp"

#include <vector>

namespace gaitway::motion {

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
