// Connected cells, and the smallest rectangle around each group, but for a few stray ones.
#include "gaitway/vision/obstacle_boxes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gaitway::vision {
namespace {

const double kToEdge = std::sqrt(3.0);  // deviations from the mean of what is spread evenly to its end
constexpr double kOutermost = 1.2;      // of a cell's side: depth of the cells that make a side
constexpr double kFaces = 0.5;          // cosine: what is seen more aslant than 60 degrees shows no face
constexpr double kLeftOut = 0.03;       // share of the weight that may lie beyond a side
constexpr int kFullWeight = 30;         // points of a cell beyond which it counts no more
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
  Eigen::Vector3d spread_m2 = Eigen::Vector3d::Zero();
  double weight = 0.0;
  // Of what the cell shows, from its mean to its end along a direction.
  [[nodiscard]] double to_edge_m(const Eigen::Vector2d& direction) const noexcept {
    const double variance_m2 = direction.x() * direction.x() * spread_m2.x() +
                               direction.y() * direction.y() * spread_m2.y() +
                               2.0 * direction.x() * direction.y() * spread_m2.z();
    return kToEdge * std::sqrt(std::max(variance_m2, 0.0));
  }
};

// What was seen from afar is less exact than what is seen now: cells that a nearer look does not show again
// count little.
std::vector<Spot> spots_of(const HeightMap& map, const Group& group) {
  std::int64_t newest_ns = 0;
  for (const int cell : group) newest_ns = std::max(newest_ns, map.seen_ns(cell));
  std::vector<Spot> spots;
  for (const int cell : group) {
    const bool is_recent = newest_ns - map.seen_ns(cell) <= kRecent_ns;
    spots.push_back({map.obstacle_m(cell), map.spread_m2(cell),
                     (is_recent ? 1.0 : kStaleShare) * (1.0 + std::min(map.weight(cell), kFullWeight))});
  }
  return spots;
}

// Where the spots lie along a direction, and how far they reach to either side, but for the few that lie
// outermost. Sought in a histogram: only the spots of one part of the way are sorted.
class Reach {
 public:
  enum class Of { means, edges };
  Reach(const std::vector<Spot>& spots, const Eigen::Vector2d& direction, Of what = Of::means)
      : spots_(spots) {
    at_m_.reserve(spots.size());
    for (const Spot& spot : spots) {
      at_m_.push_back(direction.dot(spot.at_m) + (what == Of::edges ? spot.to_edge_m(direction) : 0.0));
      all_ += spot.weight;
      least_m_ = std::min(least_m_, at_m_.back());
      most_m_ = std::max(most_m_, at_m_.back());
    }
    parts_per_m_ = (kParts - 1) / std::max(most_m_ - least_m_, 1e-9);
    for (std::size_t i = 0; i < spots.size(); ++i) weight_[part_of(at_m_[i])] += spots[i].weight;
    while (last_ > 0 && beyond_last_ + weight_[last_] <= kLeftOut * all_) beyond_last_ += weight_[last_--];
    while (first_ < last_ && before_first_ + weight_[first_] <= kLeftOut * all_)
      before_first_ += weight_[first_++];
  }

  [[nodiscard]] double most_m() const { return within_m(last_, beyond_last_, 1.0); }
  [[nodiscard]] double least_m() const { return within_m(first_, before_first_, -1.0); }
  [[nodiscard]] double extent_m() const { return most_m() - least_m(); }
  // The extent is no less than that; costs nothing.
  [[nodiscard]] double surely_m() const noexcept {
    return last_ > first_ ? static_cast<double>(last_ - first_ - 1) / parts_per_m_ : 0.0;
  }

 private:
  static constexpr std::size_t kParts = 48;
  struct Along {
    double outward_m = 0.0, weight = 0.0;
  };

  [[nodiscard]] std::size_t part_of(double at_m) const noexcept {
    return static_cast<std::size_t>((at_m - least_m_) * parts_per_m_);
  }
  // From the outside inwards, until more than what may be left out lies beyond.
  [[nodiscard]] double within_m(std::size_t part, double left_out, double outwards) const {
    std::vector<Along> within;
    for (std::size_t i = 0; i < at_m_.size(); ++i) {
      if (part_of(at_m_[i]) == part) within.push_back({outwards * at_m_[i], spots_[i].weight});
    }
    std::ranges::sort(within, std::ranges::greater{}, &Along::outward_m);
    for (const Along& along : within) {
      left_out += along.weight;
      if (left_out > kLeftOut * all_) return outwards * along.outward_m;
    }
    return outwards * within.back().outward_m;
  }

  const std::vector<Spot>& spots_;
  std::vector<double> at_m_;
  std::array<double, kParts> weight_{};
  std::size_t first_ = 0, last_ = kParts - 1;  // parts in which the outermost spots lie that count
  double before_first_ = 0.0, beyond_last_ = 0.0;
  double all_ = 0.0, least_m_ = 1e9, most_m_ = -1e9, parts_per_m_ = 0.0;
};

// Of the side in a direction, up to the end of what its cells show. Distances are noisy along the line of
// sight: a side that faces the camera is the mean of its outermost cells, weighted by what was seen in each.
double side_m(const std::vector<Spot>& spots, const Eigen::Vector2d& direction, const Eigen::Vector2d& eye_m,
              double cell_m) {
  const double farthest_m = Reach(spots, direction).most_m();
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
  for (const Spot& spot : spots) middle_m += spot.at_m / static_cast<double>(spots.size());
  middle_m += (farthest_m - direction.dot(middle_m)) * direction;
  const bool faces_eye = direction.dot((eye_m - middle_m).normalized()) > kFaces;
  if (!faces_eye) return Reach(spots, direction, Reach::Of::edges).most_m();
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
double yaw_around_rad(const std::vector<Spot>& spots) {
  double best_rad = 0.0, least_m2 = 1e9;
  for (int i = 0; i < kTurns; ++i) {
    const double yaw_rad = i * 0.5 * std::numbers::pi / kTurns;
    const Eigen::Rotation2Dd turn(yaw_rad);
    const Reach along(spots, turn * Eigen::Vector2d::UnitX()), across(spots, turn * Eigen::Vector2d::UnitY());
    if ((along.surely_m() + kLeastExtent_m) * (across.surely_m() + kLeastExtent_m) > least_m2) continue;
    const double area_m2 = (along.extent_m() + kLeastExtent_m) * (across.extent_m() + kLeastExtent_m);
    if (area_m2 < least_m2 - 1e-9) {
      least_m2 = area_m2;
      best_rad = yaw_rad;
    }
  }
  return best_rad;
}

Box box_around(const HeightMap& map, const Group& group, const Eigen::Vector2d& eye_m) {
  const std::vector<Spot> spots = spots_of(map, group);
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
