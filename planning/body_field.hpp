// What it costs to get to a pose from everywhere, for a body that walks as the gait's limits let it, without
// looking at single footsteps: what guides the search through passages and turns.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gaitway/planning/limits.hpp"
#include "outline.hpp"
#include "terrain.hpp"

namespace gaitway::planning {

// What of it a robot has, whatever the map: the body's cells in each direction, and its moves.
class BodyMoves {
 public:
  static constexpr int kTurns = 16;
  static constexpr double kUnits = 64.0;  // of a step's cost

  BodyMoves(const Limits& limits, double cell_m, double cost_per_norm);

  // From a node before to this one, which the body reaches in direction `index`.
  struct Move {
    int columns, rows, turn, units;
  };
  [[nodiscard]] const std::vector<Move>& moves_to(int turn) const noexcept {
    return moves_[static_cast<std::size_t>(turn)];
  }
  [[nodiscard]] int longest() const noexcept { return longest_; }
  [[nodiscard]] int pitch() const noexcept { return pitch_; }  // cells from node to node
  // The body's cells, bare or with its clearance, and a square around it in every direction.
  [[nodiscard]] const std::vector<CellSpan>& cells(std::size_t band, int turn, bool wide) const noexcept {
    return cells_[(band * kTurns + static_cast<std::size_t>(turn)) * 2 + (wide ? 1 : 0)];
  }
  [[nodiscard]] int radius_cells() const noexcept { return radius_; }

 private:
  int pitch_, radius_ = 0, longest_ = 0;
  std::vector<std::vector<Move>> moves_;
  std::vector<std::vector<CellSpan>> cells_;
};

class BodyField {
 public:
  // To `goal`; as far as `start` and somewhat further.
  BodyField(const Terrain& terrain, const Limits& limits, const BodyMoves& moves, const Pose& goal,
            const Pose& start);

  // In steps; what it has not come to costs at least as much as the dearest that it has.
  [[nodiscard]] double to_goal(const Pose& middle) const noexcept;

 private:
  [[nodiscard]] std::size_t index(int column, int row, int turn) const noexcept {
    return (static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(column)) *
               BodyMoves::kTurns +
           static_cast<std::size_t>(turn);
  }
  // By which factor a move to there costs more; 0: the body has no room.
  [[nodiscard]] int hindrance(const Terrain& terrain, const Limits& limits, const BodyMoves& moves,
                              int column, int row, int turn);
  void spread(const Terrain& terrain, const Limits& limits, const BodyMoves& moves, const Pose& goal,
              const Pose& start);

  Eigen::Vector2d origin_m_;
  double node_m_;
  int pitch_, columns_, rows_;
  std::vector<std::int32_t> cost_;       // in kUnits
  std::vector<std::uint8_t> hindrance_;  // kUnknown at first
  double dearest_ = 0.0;
};

}  // namespace gaitway::planning
