// The footsteps that the search chooses from: for each direction of a stance foot those landings, on a
// lattice of cells' corners and 64 directions, that the limits allow; and the cells that each of them takes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gaitway/planning/limits.hpp"
#include "outline.hpp"
#include "terrain.hpp"

namespace gaitway::planning {

inline constexpr int kDirections = 64;

// Cell's corner and direction, 0..kDirections - 1.
struct Place {
  Cell cell;
  int direction = 0;
  friend bool operator==(const Place& a, const Place& b) noexcept {
    return a.cell.column == b.cell.column && a.cell.row == b.cell.row && a.direction == b.direction;
  }
};

// A landing from a stance foot on the lattice: how many cells and directions further.
struct Landing {
  int columns = 0, rows = 0, turn = 0;
  double cost = 0.0;
};

// In steps; more for those that take all that the gait can do.
[[nodiscard]] double cost_of(double effort) noexcept;

class StepLattice {
 public:
  // Places lie `pitch` cells apart.
  StepLattice(const Limits& limits, double cell_m, int pitch);

  [[nodiscard]] double cell_m() const noexcept { return cell_m_; }
  [[nodiscard]] int pitch() const noexcept { return pitch_; }
  [[nodiscard]] double yaw_rad(int direction) const noexcept;
  [[nodiscard]] std::span<const Landing> landings(Side stance, int direction) const noexcept {
    return sets_[index(stance, direction)].landings;
  }
  // What a step takes of a band, around the stance foot's cell: the body over the stance foot, between the
  // feet and over the landed foot, with its clearance, and the feet in the lowest band.
  [[nodiscard]] std::span<const CellSpan> body(Side stance, int direction, std::size_t landing,
                                               std::size_t band) const noexcept;
  // Of a sole: all that it touches, with half a cell around it, since cells know their middles alone; and
  // with a cell more.
  [[nodiscard]] std::span<const CellSpan> sole(int direction) const noexcept {
    return soles_[static_cast<std::size_t>(direction)];
  }
  [[nodiscard]] std::span<const CellSpan> wide_sole(int direction) const noexcept {
    return wide_soles_[static_cast<std::size_t>(direction)];
  }
  // Of a square of cells around a sole in any direction, with the cell around it.
  [[nodiscard]] int sole_radius() const noexcept { return sole_radius_; }
  // Places near each landing of a foot that stands anywhere, as offsets from `stance` seen from the corner of
  // cell (0, 0) at `origin_m`; only those within the limits.
  [[nodiscard]] std::vector<Place> places_from(const Pose& stance, Side stance_side,
                                               const Eigen::Vector2d& origin_m) const;
  [[nodiscard]] int nearest_direction(double yaw_rad) const noexcept;

  // Each step that is a landing costs at least `cost_per_norm` times the norm of its shares of these two: the
  // way of the body's middle and the turn.
  struct Fastest {
    double way_m = 0.0, turn_rad = 0.0, cost_per_norm = 0.0;
    [[nodiscard]] double norm(double way, double turn) const noexcept;
  };
  [[nodiscard]] const Fastest& fastest() const noexcept { return fastest_; }
  // The furthest that anything of a step is from its stance foot.
  [[nodiscard]] double reach_m() const noexcept { return reach_m_; }

 private:
  struct Set {
    std::vector<Landing> landings;
    std::vector<std::uint32_t> first_span;  // [landing · bands + band], and one more
    std::vector<CellSpan> spans;
  };
  [[nodiscard]] static std::size_t index(Side side, int direction) noexcept {
    return static_cast<std::size_t>(side) * kDirections + static_cast<std::size_t>(direction);
  }
  [[nodiscard]] bool snap(const Pose& stance, Side swing, const Pose& wanted, const Eigen::Vector2d& origin_m,
                          Place& found) const;
  void choose_landings(Side stance, int direction);
  void lay_out(Side stance, int direction);
  void find_fastest();

  Limits limits_;
  double cell_m_;
  int pitch_;
  std::vector<Set> sets_;
  std::vector<std::vector<CellSpan>> soles_, wide_soles_;
  Fastest fastest_;
  double reach_m_ = 0.0;
  int sole_radius_ = 0;
};

// What a step from `stance` to `landing` takes of a band, in the world's frame: outlines whose hull it is.
[[nodiscard]] Points body_points(const Limits& limits, std::size_t band, const Pose& stance, Side stance_side,
                                 const Pose& landing);

}  // namespace gaitway::planning
