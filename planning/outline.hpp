// Convex outlines as the cells that they touch.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "gaitway/planning/limits.hpp"

namespace gaitway::planning {

// Cells `from`..`to` of a row, both included, counted from a reference cell.
struct CellSpan {
  std::int16_t row = 0, from = 0, to = 0;
};

using Points = std::vector<Eigen::Vector2d>;

// Counter-clockwise. Andrew's monotone chain, 1979.
[[nodiscard]] Points convex_hull(Points points);

// Adds the outline at a pose.
void add_outline(Points& points, std::span<const Eigen::Vector2d> outline_m, const Pose& at);
[[nodiscard]] Points sole_corners(const Sole& sole);

// The hull of the points, widened by `margin_m` (by an octagon around that circle), as all cells of size
// cell_m that it touches. Cell (0, 0) has its corner of least x and y at `corner_m`. Appends to `spans`.
void add_spans(std::vector<CellSpan>& spans, const Points& points, double margin_m,
               const Eigen::Vector2d& corner_m, double cell_m);

// Radius of the largest circle about the origin inside of a convex outline, and of the smallest around it.
[[nodiscard]] double inner_radius_m(std::span<const Eigen::Vector2d> outline_m) noexcept;
[[nodiscard]] double outer_radius_m(std::span<const Eigen::Vector2d> outline_m) noexcept;

}  // namespace gaitway::planning
