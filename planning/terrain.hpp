// A ground map as the planner asks it: where one can stand, and what is in the way of which band of the body.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "gaitway/planning/ground_map.hpp"
#include "gaitway/planning/limits.hpp"
#include "outline.hpp"

namespace gaitway::planning {

// A cell, or the corner of one with the least x and y; (0, 0) is the map's.
struct Cell {
  int column = 0, row = 0;
};

// Each cell has the height of the ground around it: its own where one can walk up to it in steps that are low
// enough, and otherwise that of the nearest such cell. What is higher than that is in the way, and in whose
// way depends on by how much. Around the map lies a margin that is in everybody's way.
class Terrain {
 public:
  // `from_m`: where the robot is, from where the ground spreads. The map is read here and not kept.
  Terrain(const GroundMap& map, const Limits& limits, const Eigen::Vector2d& from_m, double reach_m);

  [[nodiscard]] double cell_m() const noexcept { return grid_.cell_m; }
  [[nodiscard]] int columns() const noexcept { return grid_.columns; }
  [[nodiscard]] int rows() const noexcept { return grid_.rows; }
  [[nodiscard]] Eigen::Vector2d corner_m(const Cell& cell) const noexcept {
    return grid_.origin_m + grid_.cell_m * Eigen::Vector2d(cell.column, cell.row);
  }
  [[nodiscard]] Cell cell_of(double x_m, double y_m) const noexcept;
  [[nodiscard]] bool contains(const Cell& cell) const noexcept {
    return cell.column >= 0 && cell.row >= 0 && cell.column < grid_.columns && cell.row < grid_.rows;
  }
  // Nothing that is asked about the surroundings of a cell within the map leaves the margin.
  [[nodiscard]] int margin_cells() const noexcept { return margin_; }

  [[nodiscard]] float surface_m(const Cell& cell) const noexcept { return surface_m_[at(cell)]; }
  [[nodiscard]] float ground_m(const Cell& cell) const noexcept { return ground_m_[at(cell)]; }
  // The cell is ground that one can step on from the ground around it.
  [[nodiscard]] bool is_footing(const Cell& cell) const noexcept { return footing_[at(cell)] != 0; }
  [[nodiscard]] bool is_in_way(std::size_t band, const Cell& cell) const noexcept {
    return in_way_[band][at(cell)] != 0;
  }
  [[nodiscard]] const std::uint8_t* in_way_row(std::size_t band, int row) const noexcept {
    return in_way_[band].data() + at({0, row});
  }
  // No cell of the spans, counted from `origin`, is in the band's way.
  [[nodiscard]] bool is_free(std::size_t band, const Cell& origin,
                             std::span<const CellSpan> spans) const noexcept;
  // Of a rectangle of cells, corners included; what is outside of the map with its margin is not looked at.
  [[nodiscard]] bool is_square_free(std::size_t band, Cell least, Cell greatest) const noexcept;
  // Lowest and highest surface of the spans' cells, and whether all of them are footing.
  struct Ground {
    float lowest_m = std::numeric_limits<float>::infinity(), highest_m = -lowest_m;
    bool is_footing = true;
  };
  [[nodiscard]] Ground ground_under(const Cell& origin, std::span<const CellSpan> spans) const noexcept;
  [[nodiscard]] float highest_m(const Cell& origin, std::span<const CellSpan> spans) const noexcept;
  // There is no edge and no obstacle within the rectangle of cells, corners included.
  [[nodiscard]] bool is_smooth(Cell least, Cell greatest) const noexcept;

 private:
  [[nodiscard]] std::size_t at(const Cell& cell) const noexcept {
    return static_cast<std::size_t>(cell.row + margin_) * width_ +
           static_cast<std::size_t>(cell.column + margin_);
  }
  void spread_ground(const GroundMap& map, const Limits& limits, const Cell& from);
  void find_what_is_in_the_way(const GroundMap& map, const Limits& limits);
  void count_edges(const Limits& limits);

  world::Grid grid_;
  int margin_ = 0;
  std::size_t width_ = 0, height_ = 0;  // with the margin
  std::vector<float> surface_m_, ground_m_;
  std::vector<std::uint8_t> footing_;
  std::vector<std::vector<std::uint8_t>> in_way_;    // [band]
  std::vector<std::vector<std::uint16_t>> counted_;  // [band]: of a row's cells before this one
  std::vector<std::uint32_t> edges_;                 // of the rectangle before and below this cell
};

}  // namespace gaitway::planning
