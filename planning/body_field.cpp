// Dial's bucket queue (1969) over places and sixteen directions of the body, from the goal backwards.
#include "body_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gaitway::planning {
namespace {

constexpr std::int32_t kUnreached = std::numeric_limits<std::int32_t>::max();
constexpr std::uint8_t kUnknown = 255;
constexpr int kTight = 2;  // times as dear is a place where the body fits but has no clearance
constexpr double kNodePerSoleWidth = 0.6;               // of the nodes: 50 mm for a sole of 85 mm
constexpr double kFurther = 1.15, kFurtherSteps = 4.0;  // than the start
constexpr double kTurn_rad = 2.0 * std::numbers::pi / BodyMoves::kTurns;

}  // namespace

BodyMoves::BodyMoves(const Limits& limits, double cell_m, double cost_per_norm)
    : pitch_(std::max(1, static_cast<int>(std::floor(kNodePerSoleWidth * limits.sole.width_m / cell_m)))) {
  const double node_m = pitch_ * cell_m;
  // A side-step opens the feet with one foot and closes them with the other.
  const double side_m = std::max(0.5 * (limits.max_foot_spacing_m - limits.foot_spacing_m), 1e-3);
  moves_.resize(kTurns);
  for (int turn = 0; turn < kTurns; ++turn) {
    for (int by = -1; by <= 1; ++by) {
      const double yaw_rad = (turn - 0.5 * by) * kTurn_rad;  // half-way through the move
      for (int rows = -2; rows <= 2; ++rows) {
        for (int columns = -2; columns <= 2; ++columns) {
          if (std::abs(rows) % 2 == 0 && std::abs(columns) % 2 == 0 && (by == 0 || rows != 0 || columns != 0))
            continue;
          const double ahead_m = node_m * (std::cos(yaw_rad) * columns + std::sin(yaw_rad) * rows);
          const double left_m = node_m * (std::cos(yaw_rad) * rows - std::sin(yaw_rad) * columns);
          // What is far from straight ahead or back, or turns at the same time, is left to shorter moves.
          const bool knight = std::abs(rows) + std::abs(columns) == 3;
          if ((by != 0 || knight) && std::abs(left_m) > 0.7 * std::abs(ahead_m)) continue;
          if (by != 0 && ahead_m < 0.0) continue;
          const double norm =
              std::hypot(ahead_m / (ahead_m >= 0.0 ? limits.max_step_forward_m : limits.max_step_backward_m),
                         left_m / side_m, by * kTurn_rad / limits.max_step_turn_rad);
          const int units = std::max(1, static_cast<int>(std::lround(kUnits * cost_per_norm * norm)));
          moves_[static_cast<std::size_t>(turn)].push_back({columns, rows, by, units});
          longest_ = std::max(longest_, kTight * units);
        }
      }
    }
  }
  double radius_m = 0.0;
  for (const Band& band : limits.bands) {
    radius_m = std::max(radius_m, outer_radius_m(band.outline_m));
    for (int turn = 0; turn < kTurns; ++turn) {
      Points points;
      add_outline(points, band.outline_m, {0.0, 0.0, turn * kTurn_rad});
      for (const double margin_m : {0.0, limits.clearance_m}) {
        cells_.emplace_back();
        add_spans(cells_.back(), points, margin_m, Eigen::Vector2d::Zero(), cell_m);
      }
    }
  }
  radius_ = static_cast<int>(std::ceil((radius_m + 1.1 * limits.clearance_m) / cell_m)) + 1;
}

BodyField::BodyField(const Terrain& terrain, const Limits& limits, const BodyMoves& moves, const Pose& goal,
                     const Pose& start)
    : origin_m_(terrain.corner_m({0, 0})),
      node_m_(moves.pitch() * terrain.cell_m()),
      pitch_(moves.pitch()),
      columns_((terrain.columns() - 1) / moves.pitch() + 1),
      rows_((terrain.rows() - 1) / moves.pitch() + 1) {
  const std::size_t nodes =
      static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) * BodyMoves::kTurns;
  cost_.assign(nodes, kUnreached);
  hindrance_.assign(nodes, kUnknown);
  spread(terrain, limits, moves, goal, start);
}

int BodyField::hindrance(const Terrain& terrain, const Limits& limits, const BodyMoves& moves, int column,
                         int row, int turn) {
  std::uint8_t& known = hindrance_[index(column, row, turn)];
  if (known != kUnknown) return known;
  const Cell cell{column * pitch_, row * pitch_};
  const int radius = moves.radius_cells();
  bool open = true;
  for (std::size_t band = 0; band < limits.bands.size() && open; ++band) {
    open = terrain.is_square_free(band, {cell.column - radius, cell.row - radius},
                                  {cell.column + radius - 1, cell.row + radius - 1});
  }
  if (open) {  // whichever way it is turned
    std::fill_n(hindrance_.begin() + static_cast<std::ptrdiff_t>(index(column, row, 0)), BodyMoves::kTurns,
                1);
    return 1;
  }
  known = 1;
  for (std::size_t band = 0; band < limits.bands.size(); ++band) {
    if (terrain.is_free(band, cell, moves.cells(band, turn, true))) continue;
    known = kTight;
    if (terrain.is_free(band, cell, moves.cells(band, turn, false))) continue;
    known = 0;
    break;
  }
  return known;
}

void BodyField::spread(const Terrain& terrain, const Limits& limits, const BodyMoves& moves, const Pose& goal,
                       const Pose& start) {
  struct Node {
    std::int16_t column, row, turn;
  };
  const auto buckets_count = static_cast<std::size_t>(moves.longest() + 1);
  std::vector<std::vector<Node>> buckets(buckets_count);
  const auto around = [&](const Pose& pose, const auto& act) {
    const auto column = static_cast<int>(std::floor((pose.x_m - origin_m_.x()) / node_m_));
    const auto row = static_cast<int>(std::floor((pose.y_m - origin_m_.y()) / node_m_));
    const auto turn = static_cast<int>(std::floor(pose.yaw_rad / kTurn_rad));
    for (int i = 0; i < 8; ++i) {
      const int c = column + (i & 1), r = row + (i >> 1 & 1);
      const int t = (turn + (i >> 2 & 1) + 2 * BodyMoves::kTurns) % BodyMoves::kTurns;
      if (c < 0 || r < 0 || c >= columns_ || r >= rows_) continue;
      const Pose node{origin_m_.x() + c * node_m_, origin_m_.y() + r * node_m_, t * kTurn_rad};
      const double norm = std::hypot(way_m(node, pose) / limits.max_step_forward_m,
                                     turn_rad(node, pose) / limits.max_step_turn_rad);
      act(c, r, t, static_cast<std::int32_t>(std::lround(norm * BodyMoves::kUnits)));
    }
  };
  std::size_t waiting = 0;
  std::array<std::size_t, 8> ends{};
  std::size_t end_count = 0;
  around(start, [&](int c, int r, int t, std::int32_t) { ends[end_count++] = index(c, r, t); });
  around(goal, [&](int c, int r, int t, std::int32_t units) {
    cost_[index(c, r, t)] = units;
    buckets[static_cast<std::size_t>(units) % buckets_count].push_back(
        {static_cast<std::int16_t>(c), static_cast<std::int16_t>(r), static_cast<std::int16_t>(t)});
    ++waiting;
  });
  double last = std::numeric_limits<double>::infinity();
  std::int32_t now = 0;
  for (; waiting > 0 && now <= last; ++now) {
    std::vector<Node>& bucket = buckets[static_cast<std::size_t>(now) % buckets_count];
    for (const Node& node : bucket) {
      const std::size_t here = index(node.column, node.row, node.turn);
      if (cost_[here] != now) continue;
      for (const BodyMoves::Move& move : moves.moves_to(node.turn)) {
        const int column = node.column - move.columns, row = node.row - move.rows;
        if (column < 0 || row < 0 || column >= columns_ || row >= rows_) continue;
        const int turn = (node.turn - move.turn + BodyMoves::kTurns) % BodyMoves::kTurns;
        const std::size_t next = index(column, row, turn);
        if (cost_[next] <= now + move.units) continue;
        const int factor = hindrance(terrain, limits, moves, column, row, turn);
        const std::int32_t cost = now + factor * move.units;
        if (factor == 0 || cost_[next] <= cost) continue;
        cost_[next] = cost;
        buckets[static_cast<std::size_t>(cost) % buckets_count].push_back({static_cast<std::int16_t>(column),
                                                                           static_cast<std::int16_t>(row),
                                                                           static_cast<std::int16_t>(turn)});
        ++waiting;
      }
    }
    waiting -= bucket.size();
    bucket.clear();
    if (!std::isfinite(last) &&
        std::any_of(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(end_count),
                    [&](std::size_t end) { return cost_[end] <= now; })) {
      last = kFurther * now + kFurtherSteps * BodyMoves::kUnits;
    }
  }
  dearest_ = now / BodyMoves::kUnits;
  for (std::int32_t& cost : cost_) {
    if (cost > now) cost = kUnreached;
  }
}

double BodyField::to_goal(const Pose& middle) const noexcept {
  const double x = (middle.x_m - origin_m_.x()) / node_m_, y = (middle.y_m - origin_m_.y()) / node_m_;
  const double z = middle.yaw_rad / kTurn_rad;
  const double column = std::floor(x), row = std::floor(y), turn = std::floor(z);
  double sum = 0.0, weights = 0.0;
  for (int i = 0; i < 8; ++i) {
    const int right = i & 1, up = i >> 1 & 1, more = i >> 2 & 1;
    const int c = static_cast<int>(column) + right, r = static_cast<int>(row) + up;
    if (c < 0 || r < 0 || c >= columns_ || r >= rows_) continue;
    const int t = (static_cast<int>(turn) + more + 2 * BodyMoves::kTurns) % BodyMoves::kTurns;
    const std::int32_t cost = cost_[index(c, r, t)];
    if (cost == kUnreached) continue;
    const double weight = (right != 0 ? x - column : column + 1.0 - x) * (up != 0 ? y - row : row + 1.0 - y) *
                          (more != 0 ? z - turn : turn + 1.0 - z);
    sum += weight * cost;
    weights += weight;
  }
  return weights > 1e-6 ? sum / weights / BodyMoves::kUnits : dearest_;
}

}  // namespace gaitway::planning
