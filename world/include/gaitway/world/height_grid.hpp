// How high the ground is at a point or in each cell of a grid, and what hangs above it: what a map for
// planning is made of.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "gaitway/world/world.hpp"

namespace gaitway::world {

struct Height {
  double surface_m = 0.0;             // top of the highest solid that begins below the ceiling; 0: the floor
  std::optional<double> underside_m;  // of the lowest one that begins at the ceiling or above; none: the sky
};

// Exact on the vertical line through the point. `ceiling_m`: what begins below it is stood on or walked into,
// what begins above it is walked under.
[[nodiscard]] Height height_at(std::span<const Solid> solids, double x_m, double y_m,
                               double ceiling_m = std::numeric_limits<double>::infinity()) noexcept;

// Cells along the world's axes. Of each its middle is asked.
struct Grid {
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  // the corner of cell (0, 0) with the least x and y
  double cell_m = 0.01;
  int columns = 0, rows = 0;  // along x and y
};
inline constexpr int kMostCells = 4000;  // along either axis

struct HeightGrid {
  Grid grid;
  std::vector<float> surface_m;    // [row · columns + column]
  std::vector<float> underside_m;  // likewise; NaN: nothing hangs there
};

// Throws std::invalid_argument for a grid without cells, with more than kMostCells along an axis, or that is
// not finite.
[[nodiscard]] HeightGrid height_grid(std::span<const Solid> solids, const Grid& grid,
                                     double ceiling_m = std::numeric_limits<double>::infinity());

}  // namespace gaitway::world
