// What a planner is told of a world: in each cell of a grid how high it is there, whether soles are meant to
// stand on that, and what hangs above.
#pragma once

#include <cstdint>
#include <vector>

#include "gaitway/planning/limits.hpp"
#include "gaitway/world/height_grid.hpp"

namespace gaitway::planning {

struct GroundMap {
  world::Grid grid;
  std::vector<float> surface_m;         // [row · columns + column], of whatever is highest
  std::vector<float> underside_m;       // likewise, of what hangs above; NaN: nothing
  std::vector<std::uint8_t> is_ground;  // likewise; 0: an obstacle

  // Throws std::invalid_argument for arrays that do not fit the grid, and for heights that are not finite.
  void validate() const;
};

// Around all that stands in the world, start and goal, with a metre of floor; not further than 10 m from
// them.
[[nodiscard]] world::Grid grid_over(const world::World& world, const Pose& start, const Pose& goal,
                                    double cell_m);

// Floor, steps, slopes and tiles are ground, all else stands in the way. `ceiling_m`: what begins above it is
// walked under. Throws std::invalid_argument as world::height_grid does.
[[nodiscard]] GroundMap ground_map(const world::World& world, const world::Grid& grid, double ceiling_m);

}  // namespace gaitway::planning
