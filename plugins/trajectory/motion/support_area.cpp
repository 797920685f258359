// Convex hull of the soles that stand.
#include "gaitway/motion/support_area.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaitway::motion {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// A. M. Andrew's monotone chain, 1979: the lower chain, then the upper one.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  std::vector<Eigen::Vector2d> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const Eigen::Vector2d& point : points) {
      while (hull.size() >= base + 2 &&
             cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace

SupportArea::SupportArea(const urdf::RobotModel& robot, Contact contact,
                         const std::array<Eigen::Isometry3d, 2>& sole) {
  for (const urdf::Side side : urdf::kSides) {
    if (!stands_on(contact, side)) continue;
    const urdf::Foot& foot = robot.feet[static_cast<std::size_t>(side)];
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        const Eigen::Vector3d corner(foot.centre_m.x() + x * foot.size_m.x(),
                                     foot.centre_m.y() + y * foot.size_m.y(), 0.0);
        corners_.emplace_back((sole[static_cast<std::size_t>(side)] * corner).head<2>());
      }
    }
  }
  if (!corners_.empty()) corners_ = convex_hull(std::move(corners_));
}

double SupportArea::margin_m(const Eigen::Vector2d& point) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Eigen::Vector2d edge = corners_[(i + 1) % corners_.size()] - corners_[i];
    least = std::min(least, cross(edge, point - corners_[i]) / edge.norm());
  }
  return least;
}

Eigen::Vector2d sole_centre(const urdf::Foot& foot, const Eigen::Isometry3d& sole) {
  return (sole * Eigen::Vector3d(foot.centre_m.x(), foot.centre_m.y(), 0.0)).head<2>();
}

}  // namespace gaitway::motion
