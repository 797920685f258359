// Connected cells, and the smallest rectangle around each group, but for a few stray ones.
#include "gaitway/vision/obstacle_boxes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gaitway::vision {
namespace {

constexpr double kBorder = 0.25;    // of a cell's side: by which what a cell shows reaches beyond its middle
constexpr double kOutermost = 1.2;  // of a cell's side: depth of the cells that make a side
constexpr double kLeftOut = 0.03;   // share of the weight that may lie beyond a side
constexpr int kFullWeight = 30;     // points of a cell beyond which it counts no more
constexpr std::int64_t kRecent_ns = 300'000'000;
constexpr double kStaleShare = 0.1;
constexpr int kTurns = 30;  // headings that are tried, in a quarter turn
constexpr double kLeastExtent_m = 0.04;
constexpr double kThinnest = 0.5;  // of a cell's side
constexpr double kFilled = 0.45;   // share of a box's cells that must be obstacles, or it is parted
constexpr double kSame_m = 0.03;   // places and sizes that differ by less are the same
constexpr double kSameTurn_rad = 0.2;
constexpr std::size_t kSmallest = 4;  // cells of a group that is not parted

using Group = std::vector<int>;

Group grow(const HeightMap& map, int seed, std::array<bool, kMapSide * kMapSide>& taken) {
  Group group{seed};
  taken[static_cast<std::size_t>(seed)] = true;
  for (std::size_t next = 0; next < group.size(); ++next) {
    const int x = group[next] % kMapSide, y = group[next] / kMapSide;
    for (int to_y = std::max(y - 1, 0); to_y <= std::min(y + 1, kMapSide - 1); ++to_y) {
      for (int to_x = std::max(x - 1, 0); to_x <= std::min(x + 1, kMapSide - 1); ++to_x) {
        const int cell = to_y * kMapSide + to_x;
        if (taken[static_cast<std::size_t>(cell)] || map.state(cell) != CellState::obstacle) continue;
        taken[static_cast<std::size_t>(cell)] = true;
        group.push_back(cell);
      }
    }
  }
  return group;
}

struct Spot {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double weight = 0.0;
};

// What was seen from afar is less exact than what is seen now: cells that a nearer look does not show again
// count little.
std::vector<Spot> spots_of(const HeightMap& map, const Group& group) {
  std::int64_t newest_ns = 0;
  for (const int cell : group) newest_ns = std::max(newest_ns, map.seen_ns(cell));
  std::vector<Spot> spots;
  for (const int cell : group) {
    const bool is_recent = newest_ns - map.seen_ns(cell) <= kRecent_ns;
    spots.push_back({map.obstacle_m(cell),
                     (is_recent ? 1.0 : kStaleShare) * (1.0 + std::min(map.weight(cell), kFullWeight))});
  }
  return spots;
}

// How far the spots reach along a direction, but for the few that lie outermost.
double reach_m(std::vector<Spot>& spots, const Eigen::Vector2d& direction) {
  double all = 0.0, left_out = 0.0;
  for (const Spot& spot : spots) all += spot.weight;
  std::ranges::sort(spots, std::ranges::greater{},
                    [&](const Spot& spot) { return direction.dot(spot.at_m); });
  for (const Spot& spot : spots) {
    left_out += spot.weight;
    if (left_out > kLeftOut * all) return direction.dot(spot.at_m);
  }
  return direction.dot(spots.back().at_m);
}

// Of the side in a direction, with the cells' borders. Distances are noisy along the line of sight: a side
// that faces the camera is the mean of its outermost cells, weighted by what was seen in each.
double side_m(std::vector<Spot>& spots, const Eigen::Vector2d& direction, const Eigen::Vector2d& eye_m,
              double cell_m) {
  const double farthest_m = reach_m(spots, direction);
  if (direction.dot(eye_m) < farthest_m) return farthest_m + kBorder * cell_m;
  double sum = 0.0, weights = 0.0;
  for (const Spot& spot : spots) {
    const double at_m = direction.dot(spot.at_m);
    if (at_m < farthest_m - kOutermost * cell_m || at_m > farthest_m + cell_m) continue;
    sum += spot.weight * at_m;
    weights += spot.weight;
  }
  return sum / weights;
}

// Of the rectangle with the least area, but for the few outermost spots.
double yaw_around_rad(std::vector<Spot>& spots) {
  double best_rad = 0.0, least_m2 = 1e9;
  for (int i = 0; i < kTurns; ++i) {
    const double yaw_rad = i * 0.5 * std::numbers::pi / kTurns;
    const Eigen::Rotation2Dd turn(yaw_rad);
    const Eigen::Vector2d along = turn * Eigen::Vector2d::UnitX(), across = turn * Eigen::Vector2d::UnitY();
    const double area_m2 = (reach_m(spots, along) + reach_m(spots, -along) + kLeastExtent_m) *
                           (reach_m(spots, across) + reach_m(spots, -across) + kLeastExtent_m);
    if (area_m2 < least_m2 - 1e-9) {
      least_m2 = area_m2;
      best_rad = yaw_rad;
    }
  }
  return best_rad;
}

Box box_around(const HeightMap& map, const Group& group, const Eigen::Vector2d& eye_m) {
  std::vector<Spot> spots = spots_of(map, group);
  Box box{.yaw_rad = yaw_around_rad(spots)};
  for (const int cell : group) box.height_m = std::max(box.height_m, map.height_m(cell));
  const Eigen::Rotation2Dd turn(box.yaw_rad);
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d direction = turn * Eigen::Vector2d::Unit(axis);
    const double most_m = side_m(spots, direction, eye_m, map.cell_m());
    const double least_m = -side_m(spots, -direction, eye_m, map.cell_m());
    box.size_m[axis] = std::max(most_m - least_m, kThinnest * map.cell_m());
    box.middle_m += 0.5 * (most_m + least_m) * direction;
  }
  return box;
}

// Halves of the group across its box's longer side.
std::array<Group, 2> parted(const HeightMap& map, const Group& group, const Box& box) {
  const double yaw_rad =
      box.size_m.x() >= box.size_m.y() ? box.yaw_rad : box.yaw_rad + 0.5 * std::numbers::pi;
  const Eigen::Vector2d along(std::cos(yaw_rad), std::sin(yaw_rad));
  std::array<Group, 2> halves;
  for (const int cell : group) {
    halves[along.dot(map.obstacle_m(cell) - box.middle_m) < 0.0 ? 0 : 1].push_back(cell);
  }
  return halves;
}

void add_boxes(const HeightMap& map, const Group& group, const Eigen::Vector2d& eye_m,
               std::vector<Box>& boxes) {
  const Box box = box_around(map, group, eye_m);
  const double cells = box.size_m.prod() / (map.cell_m() * map.cell_m());
  if (group.size() <= kSmallest || static_cast<double>(group.size()) >= kFilled * cells) {
    boxes.push_back(box);
    return;
  }
  const std::array<Group, 2> halves = parted(map, group, box);
  if (halves[0].empty() || halves[1].empty()) {
    boxes.push_back(box);
    return;
  }
  for (const Group& half : halves) add_boxes(map, half, eye_m, boxes);
}

bool is_same(const Box& a, const Box& b) noexcept {
  const double turn_rad = std::abs(std::remainder(a.yaw_rad - b.yaw_rad, 0.5 * std::numbers::pi));
  return (a.middle_m - b.middle_m).norm() < kSame_m &&
         (a.size_m - b.size_m).cwiseAbs().maxCoeff() < kSame_m && turn_rad < kSameTurn_rad &&
         std::abs(a.height_m - b.height_m) < kSame_m;
}

}  // namespace

std::vector<Box> boxes_in(const HeightMap& map, const Eigen::Vector2d& eye_m) {
  std::array<bool, kMapSide * kMapSide> taken{};
  std::vector<Box> boxes;
  for (int cell = 0; cell < kMapSide * kMapSide; ++cell) {
    if (taken[static_cast<std::size_t>(cell)] || map.state(cell) != CellState::obstacle) continue;
    add_boxes(map, grow(map, cell, taken), eye_m, boxes);
  }
  // Of too many the largest are told.
  std::ranges::stable_sort(boxes, std::ranges::greater{}, [](const Box& box) { return box.size_m.prod(); });
  if (boxes.size() > kMaxObstacles) boxes.resize(kMaxObstacles);
  return boxes;
}

bool ObstacleList::renew(const std::vector<Box>& seen) {
  std::vector<Box> next = seen;
  bool changed = next.size() != told_.size();
  for (Box& box : next) {
    const auto known = std::ranges::find_if(told_, [&box](const Box& told) { return is_same(told, box); });
    if (known != told_.end())
      box = *known;
    else
      changed = true;
  }
  told_ = std::move(next);
  return changed;
}

void ObstacleList::write(Obstacles& obstacles, std::int64_t stamp_ns) const noexcept {
  obstacles = {};
  obstacles.stamp_ns = stamp_ns;
  obstacles.frame = obstacles::frame::odometry;
  for (const Box& box : told_) {
    if (obstacles.count == kMaxObstacles) break;
    const std::uint32_t i = obstacles.count++;
    obstacles.place[i][0] = box.middle_m.x();
    obstacles.place[i][1] = box.middle_m.y();
    obstacles.place[i][2] = box.yaw_rad;
    obstacles.size[i][0] = box.size_m.x();
    obstacles.size[i][1] = box.size_m.y();
    obstacles.size[i][2] = box.height_m;
  }
}

}  // namespace gaitway::vision
