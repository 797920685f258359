// Dial's bucket queue (1969) over sixteen directions, whose lengths are rounded down.
#include "distance_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gaitway::planning {
namespace {

constexpr std::int32_t kFar = std::numeric_limits<std::int32_t>::max();
constexpr double kUnits = 32.0;
constexpr double kSixteen = 0.9732;  // the longest detour of sixteen directions, cos(13.3 deg)
constexpr int kGuard = 2;            // blocked nodes around the grid: no bounds to look at

struct Move {
  int columns, rows, length;
};
constexpr std::array kMoves{Move{1, 0, 32}, Move{-1, 0, 32}, Move{0, 1, 32},  Move{0, -1, 32},
                            Move{1, 1, 45}, Move{1, -1, 45}, Move{-1, 1, 45}, Move{-1, -1, 45},
                            Move{2, 1, 71}, Move{2, -1, 71}, Move{-2, 1, 71}, Move{-2, -1, 71},
                            Move{1, 2, 71}, Move{1, -2, 71}, Move{-1, 2, 71}, Move{-1, -2, 71}};
constexpr int kBuckets = 72;  // more than the longest move

// cells[i] |= those up to `radius` before and after it, `stride` apart, for whole rows at once.
void widen(std::vector<std::uint8_t>& cells, std::size_t stride, int radius) {
  for (int grown = 0; grown < radius;) {
    const int by = std::min(grown == 0 ? 1 : grown, radius - grown);
    const std::size_t shift = static_cast<std::size_t>(by) * stride;
    if (shift >= cells.size()) return;
    for (std::size_t i = 0; i + shift < cells.size(); ++i) cells[i] |= cells[i + shift];
    for (std::size_t i = cells.size(); i-- > shift;) cells[i] |= cells[i - shift];
    grown += by;
  }
}

}  // namespace

DistanceField::DistanceField(const Terrain& terrain, const Limits& limits, const Pose& to, int pitch)
    : origin_m_(terrain.corner_m({0, 0})),
      node_m_(pitch * terrain.cell_m()),
      pitch_(pitch),
      columns_(terrain.columns() / pitch + 1 + 2 * kGuard),
      rows_(terrain.rows() / pitch + 1 + 2 * kGuard) {
  const std::size_t nodes = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  blocked_.assign(nodes, 1);
  distance_.assign(nodes, kFar);
  block(terrain, limits);
  const Cell goal = node_of(to.x_m, to.y_m);
  goal_blocked_ = true;
  for (int row = goal.row - 1; row <= goal.row + 1; ++row) {  // one of them is as free as the goal
    for (int column = goal.column - 1; column <= goal.column + 1; ++column) {
      if (column < kGuard || row < kGuard || column >= columns_ - kGuard || row >= rows_ - kGuard) continue;
      const std::size_t node = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                               static_cast<std::size_t>(column);
      if (blocked_[node] != 0) continue;
      goal_blocked_ = false;
      distance_[node] = 0;
    }
  }
  if (!goal_blocked_) spread(goal.column, goal.row);
}

void DistanceField::block(const Terrain& terrain, const Limits& limits) {
  std::vector<std::uint8_t> any(blocked_.size(), 0);
  const std::size_t width = static_cast<std::size_t>(terrain.columns());
  std::vector<std::uint8_t> cells;
  for (std::size_t band = 0; band < limits.bands.size(); ++band) {
    cells.resize(width * static_cast<std::size_t>(terrain.rows()));
    for (int row = 0; row < terrain.rows(); ++row) {
      std::copy_n(terrain.in_way_row(band, row), width,
                  cells.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row) * width));
    }
    // The square in the circle; a node is up to 0.71 pitches from where it stands for, a cell has a width.
    const double free_m =
        inner_radius_m(limits.bands[band].outline_m) / std::sqrt(2.0) - 0.71 * node_m_ - terrain.cell_m();
    const int radius = static_cast<int>(std::floor(free_m / terrain.cell_m()));
    if (radius < 0) continue;
    widen(cells, width, radius);
    // Across the ends of rows, too, which blocks no more than the margin would.
    widen(cells, 1, radius);
    for (int row = kGuard; row < rows_ - kGuard; ++row) {
      for (int column = kGuard; column < columns_ - kGuard; ++column) {
        const int r = std::min((row - kGuard) * pitch_, terrain.rows() - 1);
        const int c = std::min((column - kGuard) * pitch_, terrain.columns() - 1);
        any[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(column)] |=
            cells[static_cast<std::size_t>(r) * width + static_cast<std::size_t>(c)];
      }
    }
  }
  for (int row = kGuard; row < rows_ - kGuard; ++row) {
    for (int column = kGuard; column < columns_ - kGuard; ++column) {
      const std::size_t node = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                               static_cast<std::size_t>(column);
      blocked_[node] = any[node];
    }
  }
}

void DistanceField::spread(int column, int row) {
  std::array<std::vector<std::int32_t>, kBuckets> buckets;
  std::array<std::int32_t, kMoves.size()> step{};
  for (std::size_t i = 0; i < kMoves.size(); ++i) step[i] = kMoves[i].rows * columns_ + kMoves[i].columns;
  std::size_t waiting = 0;
  for (int r = row - 1; r <= row + 1; ++r) {
    for (int c = column - 1; c <= column + 1; ++c) {
      const std::int32_t node = r * columns_ + c;
      if (r < 0 || c < 0 || r >= rows_ || c >= columns_ || distance_[static_cast<std::size_t>(node)] != 0)
        continue;
      buckets[0].push_back(node);
      ++waiting;
    }
  }
  for (std::int32_t now = 0; waiting > 0; ++now) {
    std::vector<std::int32_t>& bucket = buckets[static_cast<std::size_t>(now % kBuckets)];
    for (const std::int32_t node : bucket) {
      if (distance_[static_cast<std::size_t>(node)] != now) continue;
      for (std::size_t i = 0; i < kMoves.size(); ++i) {
        const auto next = static_cast<std::size_t>(node + step[i]);
        const std::int32_t length = now + kMoves[i].length;
        if (blocked_[next] != 0 || distance_[next] <= length) continue;
        distance_[next] = length;
        buckets[static_cast<std::size_t>(length % kBuckets)].push_back(static_cast<std::int32_t>(next));
        ++waiting;
      }
    }
    waiting -= bucket.size();
    bucket.clear();
  }
}

Cell DistanceField::node_of(double x_m, double y_m) const noexcept {
  const auto index = [this](double offset_m, int count) {
    return static_cast<int>(std::lround(std::clamp(offset_m / node_m_, -1.0, double(count)))) + kGuard;
  };
  return {std::min(index(x_m - origin_m_.x(), columns_), columns_ - 1),
          std::min(index(y_m - origin_m_.y(), rows_), rows_ - 1)};
}

double DistanceField::to_goal_m(double x_m, double y_m) const noexcept {
  const Cell node = node_of(x_m, y_m);
  const std::int32_t distance =
      distance_[static_cast<std::size_t>(node.row) * static_cast<std::size_t>(columns_) +
                static_cast<std::size_t>(node.column)];
  if (distance == kFar) return std::numeric_limits<double>::infinity();
  // The place and the goal are each up to 0.71 and 1.5 nodes off those that stand for them.
  return std::max(kSixteen * distance / kUnits - 1.5, 0.0) * node_m_;
}

double DistanceField::to_goal_from_around_m(double x_m, double y_m) const noexcept {
  double least_m = std::numeric_limits<double>::infinity();
  for (const double dx : {-node_m_, 0.0, node_m_}) {
    for (const double dy : {-node_m_, 0.0, node_m_})
      least_m = std::min(least_m, to_goal_m(x_m + dx, y_m + dy));
  }
  return least_m;
}

}  // namespace gaitway::planning
