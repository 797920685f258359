// Lays the tops and undersides of solids into a grid, each into the cells below it alone.
#include "gaitway/world/height_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace gaitway::world {
namespace {

void check(const Grid& grid) {
  if (!(grid.cell_m > 0.0) || !std::isfinite(grid.cell_m) || !grid.origin_m.allFinite() || grid.columns < 1 ||
      grid.rows < 1 || grid.columns > kMostCells || grid.rows > kMostCells) {
    throw std::invalid_argument("a grid of " + std::to_string(grid.columns) + " x " +
                                std::to_string(grid.rows) + " cells of " + std::to_string(grid.cell_m) +
                                " m: must have 1 to " + std::to_string(kMostCells) +
                                " cells along either axis, of a size above 0");
  }
}

void add(Height& height, const Interval& solid, double ceiling_m) {
  if (solid.bottom_m < ceiling_m) {
    height.surface_m = std::max(height.surface_m, solid.top_m);
  } else if (!height.underside_m || solid.bottom_m < *height.underside_m) {
    height.underside_m = solid.bottom_m;
  }
}

// The cells whose middles may lie between two coordinates.
struct Cells {
  int first = 0, last = -1;
};
Cells cells_between(double from_m, double to_m, double origin_m, double cell_m, int count) {
  const auto cell = [&](double at_m) {
    return static_cast<int>(std::clamp(std::floor((at_m - origin_m) / cell_m), -1.0, double(count)));
  };
  return {std::max(cell(from_m), 0), std::min(cell(to_m), count - 1)};
}

}  // namespace

Height height_at(std::span<const Solid> solids, double x_m, double y_m, double ceiling_m) noexcept {
  Height height;
  for (const Solid& solid : solids) {
    if (const auto met = solid.on_vertical(x_m, y_m)) add(height, *met, ceiling_m);
  }
  return height;
}

HeightGrid height_grid(std::span<const Solid> solids, const Grid& grid, double ceiling_m) {
  check(grid);
  const std::size_t count = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
  std::vector<Height> heights(count);
  for (const Solid& solid : solids) {
    const auto [least_m, greatest_m] = solid.bounds_m();
    const Cells columns =
        cells_between(least_m.x(), greatest_m.x(), grid.origin_m.x(), grid.cell_m, grid.columns);
    const Cells rows = cells_between(least_m.y(), greatest_m.y(), grid.origin_m.y(), grid.cell_m, grid.rows);
    for (int row = rows.first; row <= rows.last; ++row) {
      for (int column = columns.first; column <= columns.last; ++column) {
        const auto met = solid.on_vertical(grid.origin_m.x() + (column + 0.5) * grid.cell_m,
                                           grid.origin_m.y() + (row + 0.5) * grid.cell_m);
        if (!met) continue;
        add(heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                    static_cast<std::size_t>(column)],
            *met, ceiling_m);
      }
    }
  }
  HeightGrid result{.grid = grid, .surface_m = {}, .underside_m = {}};
  result.surface_m.reserve(count);
  result.underside_m.reserve(count);
  for (const Height& height : heights) {
    result.surface_m.push_back(static_cast<float>(height.surface_m));
    result.underside_m.push_back(height.underside_m ? static_cast<float>(*height.underside_m)
                                                    : std::numeric_limits<float>::quiet_NaN());
  }
  return result;
}

}  // namespace gaitway::world
