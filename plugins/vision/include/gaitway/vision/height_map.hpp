// What is known of the ground around the robot: cells that were seen free, those with an obstacle and how
// high it is, and those that nothing is known of.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::vision {

inline constexpr int kMapSide = static_cast<int>(kMapCells);

enum class CellState : std::uint8_t { unknown, free, obstacle };  // numbers as in GroundMap

// What one pair of pictures says of one cell.
struct CellSighting {
  enum class What : std::uint8_t { ground, obstacle, seen_through };
  What what = What::ground;
  double height_m = 0.0;                               // of the ground, or of the obstacle's highest
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();  // of an obstacle's points, in odometry
  // Of an obstacle's points: variances along x and y, covariance.
  Eigen::Vector3d spread_m2 = Eigen::Vector3d::Zero();
  int points = 0;  // of an obstacle
};

// A square of kMapSide × kMapSide cells that goes with the robot, in whole cells. A state changes only after
// several pairs said so: an obstacle stays one until it was seen free.
class HeightMap {
 public:
  explicit HeightMap(double cell_m);

  [[nodiscard]] double cell_m() const noexcept { return cell_m_; }
  [[nodiscard]] Eigen::Vector2d corner_m() const noexcept {
    return cell_m_ * Eigen::Vector2d(corner_x_, corner_y_);
  }

  // Moves the square so that `middle_m` is near its middle, if that is off by more than a tenth of a side.
  void centre(const Eigen::Vector2d& middle_m) noexcept;

  // Index of the cell at a place; -1: beyond the map.
  [[nodiscard]] int cell_at(double x_m, double y_m) const noexcept;
  [[nodiscard]] Eigen::Vector2d middle_of(int cell) const noexcept;

  void see(int cell, const CellSighting& sighting, std::int64_t stamp_ns) noexcept;
  // Free cells that were seen last before then are unknown again; obstacles stay.
  void forget(std::int64_t seen_before_ns) noexcept;

  [[nodiscard]] CellState state(int cell) const noexcept { return at(cell).state; }
  [[nodiscard]] double height_m(int cell) const noexcept { return 1e-3 * at(cell).height_mm; }
  // Of the points that were seen of the obstacle in the cell.
  [[nodiscard]] Eigen::Vector2d obstacle_m(int cell) const noexcept;
  // Of these points: variances along x and y, covariance.
  [[nodiscard]] Eigen::Vector3d spread_m2(int cell) const noexcept;
  [[nodiscard]] int weight(int cell) const noexcept { return at(cell).weight; }
  [[nodiscard]] std::int64_t seen_ns(int cell) const noexcept {
    return seen_ns_[static_cast<std::size_t>(cell)];
  }

  void write(GroundMap& map, std::int64_t stamp_ns) const noexcept;

  // What a successor goes on from: six bytes a cell, ages to a tenth of a second.
  template <class Archive>
  void save(Archive& archive, std::int64_t now_ns) const {
    archive(cell_m_, corner_x_, corner_y_, now_ns, packed(now_ns));
  }
  template <class Archive>
  void restore(Archive& archive) {
    HeightMap saved(0.0);
    std::int64_t now_ns = 0;
    Packed cells{};
    archive(saved.cell_m_, saved.corner_x_, saved.corner_y_, now_ns, cells);
    saved.unpack(cells, now_ns);
    if (saved.cell_m_ == cell_m_) *this = saved;  // of another grid nothing is taken
  }

 private:
  struct Cell {
    CellState state = CellState::unknown;
    std::int8_t evidence = 0;                // positive for an obstacle
    std::int8_t offset_x = 0, offset_y = 0;  // of the obstacle's points from the cell's middle, in cell / 250
    std::uint8_t weight = 0;                 // points behind the offset, up to a limit
    std::int16_t height_mm = 0;
    std::array<float, 3>
        moment{};  // of these points, as spread_m2 has them, about the cell's middle, in cells²
  };
  struct PackedCell {
    std::uint8_t state_and_evidence = 0;  // state times 32, evidence from the least
    std::int8_t offset_x = 0, offset_y = 0;
    std::uint8_t age = 0;  // 0.1 s
    std::int16_t height_mm = 0;
  };
  using Packed = std::array<PackedCell, kMapSide * kMapSide>;

  [[nodiscard]] const Cell& at(int cell) const noexcept { return cells_[static_cast<std::size_t>(cell)]; }
  void place(Cell& cell, int index, const CellSighting& sighting) const noexcept;
  [[nodiscard]] Packed packed(std::int64_t now_ns) const noexcept;
  void unpack(const Packed& cells, std::int64_t now_ns) noexcept;

  double cell_m_;
  int corner_x_ = -kMapSide / 2, corner_y_ = -kMapSide / 2;  // in cells from odometry's origin
  std::array<Cell, kMapSide * kMapSide> cells_{};            // row by row: y, then x
  std::array<std::int64_t, kMapSide * kMapSide> seen_ns_{};
};

}  // namespace gaitway::vision
