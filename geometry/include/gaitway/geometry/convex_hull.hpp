// The convex hull of points on the ground, above all the support polygon under the soles, and how far inside
// it a point lies.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>

namespace gaitway::geometry {

// Of at most kMost points as seen from above; of points in space, a corner keeps its height. No allocation.
template <class Point = Eigen::Vector2d, std::size_t kMost = 8>
class ConvexHull {
 public:
  ConvexHull() = default;
  // Points beyond the first kMost are left out. A. M. Andrew's monotone chain, 1979.
  explicit ConvexHull(std::span<const Point> points) noexcept {
    std::array<Point, kMost> sorted{};
    auto end = std::copy_n(points.begin(), std::min(points.size(), kMost), sorted.begin());
    const auto before = [](const Point& a, const Point& b) {
      return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    };
    for (auto point = sorted.begin(); point != end; ++point) {  // few points: insertion
      std::rotate(std::upper_bound(sorted.begin(), point, *point, before), point, point + 1);
    }
    end = std::unique(sorted.begin(), end);
    for (auto point = sorted.begin(); point != end; ++point) add(*point, 2);
    const std::size_t lower = count_ + 1;
    for (std::size_t i = static_cast<std::size_t>(end - sorted.begin()); i-- > 1;) add(sorted[i - 1], lower);
    if (count_ > 1) --count_;  // the first corner again
  }

  // Counter-clockwise, none on the line between its neighbours.
  [[nodiscard]] std::span<const Point> corners() const noexcept { return {corner_.data(), count_}; }

  // Distance to the nearest edge, negative outside; infinite where there is no point.
  [[nodiscard]] double margin_m(const Eigen::Vector2d& point) const noexcept {
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count_; ++i) {
      const Eigen::Vector2d from = corner_[i].template head<2>();
      const Eigen::Vector2d edge = corner_[(i + 1) % count_].template head<2>() - from;
      least_m = std::min(least_m, turn(edge, point - from) / edge.norm());
    }
    return least_m;
  }

 private:
  // Positive where b points to the left of a.
  static double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b) noexcept {
    return a.x() * b.y() - a.y() * b.x();
  }
  // Takes back corners that the new one shows to be inside, but keeps one less than `least`.
  void add(const Point& point, std::size_t least) noexcept {
    while (count_ >= least) {
      const Eigen::Vector2d before = corner_[count_ - 2].template head<2>();
      const Eigen::Vector2d along = corner_[count_ - 1].template head<2>() - before;
      if (turn(along, point.template head<2>() - before) > 0.0) break;
      --count_;
    }
    corner_[count_++] = point;
  }

  std::array<Point, kMost + 1> corner_{};  // and, while it is made, the first one again
  std::size_t count_ = 0;
};

}  // namespace gaitway::geometry
