// Worlds for the planner's tests, put together box by box or at random, and a robot to plan for.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "gaitway/planning/planner.hpp"

namespace gaitway::planning {

inline constexpr double kCell_m = 0.01;

// Limits like those of humanoid22's gait.
[[nodiscard]] Limits small_humanoid();
[[nodiscard]] const Planner& planner();  // of small_humanoid(), made once

// An upright box on the floor, of that kind.
[[nodiscard]] world::Solid upright(world::Kind kind, double x_m, double y_m, double length_m, double width_m,
                                   double height_m, double yaw_rad = 0.0, double bottom_m = 0.0);

struct Scene {
  world::World world;
  world::Grid grid;
  Pose start, goal;  // of the middle between the feet

  [[nodiscard]] GroundMap map() const { return ground_map(world, grid, small_humanoid().height_m); }
  [[nodiscard]] Request request() const;
  [[nodiscard]] Plan plan() const { return planner().plan(map(), request()); }
};

// A level floor of that size around the origin.
[[nodiscard]] Scene floor(double length_m, double width_m);
// 6 m x 6 m with `boxes` boxes of 20 to 250 mm height, as the shipped world `boxes` has them, and a start and
// a goal at random, which may well be bad.
[[nodiscard]] Scene random_scene(std::uint64_t seed, double side_m = 6.0, int boxes = 45);

}  // namespace gaitway::planning
