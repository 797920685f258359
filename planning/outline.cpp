// Hulls and their cells: a hull touches a cell where, widened by half a cell to all four sides, it contains
// the cell's middle.
#include "outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gaitway::planning {
namespace {

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) noexcept {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// What the hull has of the line y = at_y.
struct Reach {
  double from = std::numeric_limits<double>::infinity(), to = -from;
};
Reach across(const Points& hull, double at_y) noexcept {
  Reach reach;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d& a = hull[i];
    const Eigen::Vector2d& b = hull[(i + 1) % hull.size()];
    if (std::min(a.y(), b.y()) > at_y || std::max(a.y(), b.y()) < at_y) continue;
    const double share = a.y() == b.y() ? 0.0 : (at_y - a.y()) / (b.y() - a.y());
    for (const double x :
         {a.x() + share * (b.x() - a.x()), a.y() == b.y() ? b.x() : a.x() + share * (b.x() - a.x())}) {
      reach.from = std::min(reach.from, x);
      reach.to = std::max(reach.to, x);
    }
  }
  return reach;
}

}  // namespace

Points convex_hull(Points points) {
  std::ranges::sort(points, [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Points hull;
  const auto add = [&hull](const Eigen::Vector2d& point, std::size_t least) {
    while (hull.size() >= least && turn(hull[hull.size() - 2], hull.back(), point) <= 0.0) hull.pop_back();
    hull.push_back(point);
  };
  for (const Eigen::Vector2d& point : points) add(point, 2);
  const std::size_t lower = hull.size() + 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  hull.pop_back();
  return hull;
}

void add_outline(Points& points, std::span<const Eigen::Vector2d> outline_m, const Pose& at) {
  const double c = std::cos(at.yaw_rad), s = std::sin(at.yaw_rad);
  for (const Eigen::Vector2d& corner : outline_m) {
    points.emplace_back(at.x_m + c * corner.x() - s * corner.y(), at.y_m + s * corner.x() + c * corner.y());
  }
}

Points sole_corners(const Sole& sole) {
  const double toe_m = sole.centre_forward_m + 0.5 * sole.length_m;
  const double heel_m = sole.centre_forward_m - 0.5 * sole.length_m;
  const double side_m = 0.5 * sole.width_m;
  return {{heel_m, -side_m}, {toe_m, -side_m}, {toe_m, side_m}, {heel_m, side_m}};
}

void add_spans(std::vector<CellSpan>& spans, const Points& points, double margin_m,
               const Eigen::Vector2d& corner_m, double cell_m) {
  const double half_m = 0.5 * cell_m;
  Points wide;
  wide.reserve(points.size() * 8);
  // The octagon around the circle, and the cell's square: both are symmetric, so their corners add up.
  const double near_m = margin_m * 0.41421356237309503 + half_m, far_m = margin_m + half_m;
  for (const Eigen::Vector2d& point : points) {
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        wide.emplace_back(point.x() + x * near_m, point.y() + y * far_m);
        if (margin_m > 0.0) wide.emplace_back(point.x() + x * far_m, point.y() + y * near_m);
      }
    }
  }
  const Points hull = convex_hull(std::move(wide));
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Eigen::Vector2d& point : hull) {
    least = std::min(least, point.y());
    most = std::max(most, point.y());
  }
  const auto first = static_cast<int>(std::ceil((least - corner_m.y()) / cell_m - 0.5));
  const auto last = static_cast<int>(std::floor((most - corner_m.y()) / cell_m - 0.5));
  for (int row = first; row <= last; ++row) {
    const Reach reach = across(hull, corner_m.y() + (row + 0.5) * cell_m);
    const auto from = static_cast<int>(std::ceil((reach.from - corner_m.x()) / cell_m - 0.5));
    const auto to = static_cast<int>(std::floor((reach.to - corner_m.x()) / cell_m - 0.5));
    if (from > to) continue;
    spans.push_back(
        {static_cast<std::int16_t>(row), static_cast<std::int16_t>(from), static_cast<std::int16_t>(to)});
  }
}

double inner_radius_m(std::span<const Eigen::Vector2d> outline_m) noexcept {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline_m.size(); ++i) {
    const Eigen::Vector2d& from = outline_m[i];
    const Eigen::Vector2d edge = outline_m[(i + 1) % outline_m.size()] - from;
    least_m = std::min(least_m, (edge.y() * from.x() - edge.x() * from.y()) / edge.norm());
  }
  return std::max(least_m, 0.0);
}

double outer_radius_m(std::span<const Eigen::Vector2d> outline_m) noexcept {
  double most_m = 0.0;
  for (const Eigen::Vector2d& corner : outline_m) most_m = std::max(most_m, corner.norm());
  return most_m;
}

}  // namespace gaitway::planning
