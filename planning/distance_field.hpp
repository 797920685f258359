// How far it is to a place around all obstacles, from everywhere: what guides the search.
#pragma once

#include <cstdint>
#include <vector>

#include "terrain.hpp"

namespace gaitway::planning {

// Of the body's middle, which keeps off what is in a band's way by the radius of the largest circle in that
// band's outline, less what the grid rounds: no way that the body can take is shorter.
class DistanceField {
 public:
  // From everywhere to `to`. Nodes lie `pitch` cells apart, on the corners of cells.
  DistanceField(const Terrain& terrain, const Limits& limits, const Pose& to, int pitch);

  // Never more than the truth; infinite where there is no way.
  [[nodiscard]] double to_goal_m(double x_m, double y_m) const noexcept;
  // The least of a place and the nodes around it.
  [[nodiscard]] double to_goal_from_around_m(double x_m, double y_m) const noexcept;
  [[nodiscard]] bool is_goal_blocked() const noexcept { return goal_blocked_; }

 private:
  void block(const Terrain& terrain, const Limits& limits);
  void spread(int column, int row);
  [[nodiscard]] Cell node_of(double x_m, double y_m) const noexcept;

  Eigen::Vector2d origin_m_;
  double node_m_ = 0.0;
  int pitch_ = 1, columns_ = 0, rows_ = 0;
  bool goal_blocked_ = false;
  std::vector<std::uint8_t> blocked_;
  std::vector<std::int32_t> distance_;  // in kUnits of node_m_
};

}  // namespace gaitway::planning
