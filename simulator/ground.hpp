// The ground that the simulated robot walks on: an endless plane, level or sloping, with a step or with
// tiles.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "gaitway/simulator/conditions.hpp"

namespace gaitway::simulator {

// Of the ground's frame in the world; the identity where the ground is level. The ground's z is its normal.
[[nodiscard]] Eigen::Quaterniond ground_rotation(const GroundConditions& ground);

// Adds the ground's shapes to the world body.
void add_ground(mjSpec* spec, const GroundConditions& ground, double friction);

// Tiles of random height. There are only as many as lie around the robot; they move on with it, and each
// place has its height by the seed alone.
class TileField {
 public:
  TileField(const mjModel& model, const GroundConditions& ground, std::uint64_t seed);

  // Lays the tiles around a point of the world that has moved on by a tile or more.
  void follow(mjModel& model, const Eigen::Vector3d& point_m);

 private:
  [[nodiscard]] double height_m(std::int64_t column, std::int64_t row) const noexcept;

  Eigen::Quaterniond rotation_;
  double largest_m_;
  std::uint64_t seed_;
  std::vector<int> geoms_;             // column by column; empty: no tiles
  std::int64_t column_ = 0, row_ = 0;  // of the tile below the robot
  bool laid_ = false;
};

}  // namespace gaitway::simulator
