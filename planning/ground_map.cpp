// Tells ground from obstacles: where whatever is highest is higher than the ground's own solids.
#include "gaitway/planning/ground_map.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace gaitway::planning {
namespace {

constexpr double kAround_m = 1.0;    // of floor around everything
constexpr double kFurther_m = 10.0;  // from start and goal nothing is looked at

}  // namespace

void GroundMap::validate() const {
  const std::size_t cells =
      static_cast<std::size_t>(std::max(grid.columns, 0)) * static_cast<std::size_t>(std::max(grid.rows, 0));
  if (cells == 0 || !(grid.cell_m > 0.0) || !grid.origin_m.allFinite() || surface_m.size() != cells ||
      underside_m.size() != cells || is_ground.size() != cells) {
    throw std::invalid_argument("ground map: must have a grid with cells, and each array one value a cell");
  }
  if (!std::ranges::all_of(surface_m, [](float height_m) { return std::isfinite(height_m); })) {
    throw std::invalid_argument("ground map: surface_m must be finite: mark what is unknown as no ground");
  }
}

world::Grid grid_over(const world::World& world, const Pose& start, const Pose& goal, double cell_m) {
  const Eigen::Vector2d from(start.x_m, start.y_m), to(goal.x_m, goal.y_m);
  const Eigen::Vector2d far = Eigen::Vector2d::Constant(kFurther_m),
                        around = Eigen::Vector2d::Constant(kAround_m);
  Eigen::Vector2d least = from, greatest = from;
  if ((to - from).norm() < 2.0 * kFurther_m) {  // further off it is not on the map, and told so
    least = least.cwiseMin(to);
    greatest = greatest.cwiseMax(to);
  }
  const Eigen::Vector2d lowest = least - far, highest = greatest + far;
  for (const world::Solid& solid : world.all_solids(true)) {
    const auto [low, high] = solid.bounds_m();
    least = least.cwiseMin(low.head<2>());
    greatest = greatest.cwiseMax(high.head<2>());
  }
  least = (least - around).cwiseMax(lowest);
  greatest = (greatest + around).cwiseMin(highest);
  const auto count = [cell_m](double length_m) {
    return std::min(static_cast<int>(std::ceil(length_m / cell_m)), world::kMostCells);
  };
  return {.origin_m = least,
          .cell_m = cell_m,
          .columns = count(greatest.x() - least.x()),
          .rows = count(greatest.y() - least.y())};
}

GroundMap ground_map(const world::World& world, const world::Grid& grid, double ceiling_m) {
  std::vector<world::Solid> ground;
  std::ranges::copy_if(world.solids, std::back_inserter(ground),
                       [](const world::Solid& solid) { return world::is_ground(solid.kind); });
  world::HeightGrid all = world::height_grid(world.all_solids(true), grid, ceiling_m);
  const world::HeightGrid stood_on = world::height_grid(ground, grid, ceiling_m);
  GroundMap map{.grid = grid,
                .surface_m = std::move(all.surface_m),
                .underside_m = std::move(all.underside_m),
                .is_ground = {}};
  map.is_ground.reserve(map.surface_m.size());
  for (std::size_t cell = 0; cell < map.surface_m.size(); ++cell) {
    map.is_ground.push_back(map.surface_m[cell] <= stood_on.surface_m[cell] ? 1 : 0);
  }
  return map;
}

}  // namespace gaitway::planning
