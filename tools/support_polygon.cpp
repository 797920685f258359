// Geometry of feet on the ground.
#include "gaitway/tools/support_polygon.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace gaitway::tools {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

std::vector<Eigen::Vector2d> sole_corners(const urdf::Foot& foot, const Eigen::Vector3d& pose) {
  const Eigen::Rotation2Dd rotation(pose.z());
  std::vector<Eigen::Vector2d> corners;
  for (const auto& [sx, sy] : {std::pair{0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}}) {
    const Eigen::Vector2d corner =
        foot.centre_m + Eigen::Vector2d(sx * foot.size_m.x(), sy * foot.size_m.y());
    corners.emplace_back(pose.head<2>() + rotation * corner);
  }
  return corners;
}

std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  std::vector<Eigen::Vector2d> hull;
  const auto add_chain = [&](auto first, auto last) {
    const std::size_t base = hull.size();
    for (auto point = first; point != last; ++point) {
      while (hull.size() >= base + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *point - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(*point);
    }
    hull.pop_back();  // the next chain begins with it
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

double margin_m(std::span<const Eigen::Vector2d> polygon, const Eigen::Vector2d& point) {
  double margin = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& from = polygon[i];
    const Eigen::Vector2d edge = polygon[(i + 1) % polygon.size()] - from;
    margin = std::min(margin, cross(edge, point - from) / edge.norm());
  }
  return margin;
}

}  // namespace gaitway::tools
