// Points, ground plane and cells. The ground is fitted by iteratively re-weighted least squares with Tukey's
// weights (P. J. Huber, "Robust Statistics", 1981), held by what the joints and the attitude say of it.
#include "gaitway/vision/ground_observer.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::vision {
namespace {

constexpr int kStride = 2;  // of the pixels that become points: neighbours say the same
// How well the robot knows where the ground is, without looking.
constexpr double kOffsetDeviation_m = 0.01, kSlopeDeviation = 0.02;
constexpr double kIndependent = 0.05;  // share of the points that are: a match is of a block
constexpr int kIterations = 4;
constexpr double kCut = 3.0;            // deviations beyond which a point is no ground
constexpr double kUncalibrated = 0.01;  // of the distance: height that lenses a little off give to the ground
constexpr int kLeastPoints = 3;
constexpr double kLeastShare = 0.2;  // of an obstacle's points in its cell
constexpr int kEdge = 4;             // pixels to either side that must be of the same surface
constexpr double kEdgeStep_px = 0.8;
constexpr int kKnownAround = 5;           // of nine pixels
constexpr double kNearestGround_m = 0.3;  // along the ground, of what is looked at for a shift

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

RectifiedGeometry scaled(RectifiedGeometry geometry, int scale) {
  geometry.focal_px /= scale;
  geometry.cx_px = (geometry.cx_px + 0.5) / scale - 0.5;
  geometry.cy_px = (geometry.cy_px + 0.5) / scale - 0.5;
  geometry.width /= scale;
  geometry.height /= scale;
  return geometry;
}

// Between something near and what is behind it the matching lays a slope that is not there.
bool is_at_edge(const cv::Mat& disparity, int x, int y) {
  const int left = std::max(x - kEdge, 0), right = std::min(x + kEdge, disparity.cols - 1);
  const int up = std::max(y - kEdge, 0), down = std::min(y + kEdge, disparity.rows - 1);
  const auto at = [&disparity](int row, int column) { return disparity.at<std::int16_t>(row, column); };
  const int here = at(y, x);
  const auto differs = [here](int other) {
    return other <= 0 || std::abs(other - here) > kEdgeStep_px * DisparityMatcher::kUnits;
  };
  // The slope may be long and shallow: at the foot of something near both sides are hardly apart.
  const bool slopes = std::abs(at(y, right) - at(y, left)) > kEdgeStep_px * DisparityMatcher::kUnits;
  return slopes || differs(at(y, left)) || differs(at(y, right)) || differs(at(up, x)) ||
         differs(at(down, x));
}

}  // namespace

GroundObserver::GroundObserver(const RectifiedGeometry& geometry, const GroundParameters& parameters)
    : geometry_(scaled(geometry, geometry.width > 320 ? 2 : 1)), parameters_(parameters) {
  tallies_.resize(static_cast<std::size_t>(kMapSide) * kMapSide);
}

void GroundObserver::look(const DisparityMatcher& matcher, const ShutterPoses& poses) {
  disparity_ = matcher.disparity();
  base_m_ = poses.base_m;
  camera_.linear() = Eigen::Quaterniond(poses.first.linear())
                         .slerp(0.5, Eigen::Quaterniond(poses.last.linear()))
                         .toRotationMatrix();
  camera_.translation() = 0.5 * (poses.first.translation() + poses.last.translation());
  collect(matcher, poses);
  find_shift();
  fit_ground();
}

void GroundObserver::collect(const DisparityMatcher& matcher, const ShutterPoses& poses) {
  points_.clear();
  const Eigen::Quaterniond first(poses.first.linear()), last(poses.last.linear());
  for (int y = 0; y < disparity_.rows; y += kStride) {
    const double share = static_cast<double>(y) / (geometry_.height - 1);
    const Eigen::Matrix3d turn = first.slerp(share, last).toRotationMatrix();
    const Eigen::Vector3d eye =
        poses.first.translation() + share * (poses.last.translation() - poses.first.translation());
    const std::int16_t* const row = matcher.disparity().ptr<std::int16_t>(y);
    for (int x = 0; x < disparity_.cols; x += kStride) {
      if (row[x] <= 0 || is_at_edge(disparity_, x, y)) continue;
      const double disparity_px = row[x] / DisparityMatcher::kUnits;
      const double z_m = geometry_.distance_m(disparity_px);
      const Eigen::Vector3d ray = turn * geometry_.ray(x, y);
      const Eigen::Vector3d along = z_m * ray;
      const double distance_m = along.head<2>().norm();
      if (distance_m > parameters_.farthest_m) continue;
      const double z_deviation_m = z_m / disparity_px * parameters_.disparity_deviation_px;
      const double level_px =
          ray.z() < 0.0 ? -ray.z() * geometry_.focal_px * geometry_.base_m / eye.z() : 0.0;
      points_.push_back({.place_m = eye + along,
                         .distance_m = distance_m,
                         .deviation_m = std::hypot(z_deviation_m * ray.z(), 0.003),
                         .shift_px = level_px > 0.0 ? disparity_px - level_px : 1e3});
    }
  }
}

// The disparity of level ground at a pixel is its ray's slope times focal length times base over the camera's
// height; a camera that is turned against the other shifts all of them by the same.
void GroundObserver::find_shift() {
  shifts_.clear();
  for (const Point& point : points_) {
    if (point.distance_m > kNearestGround_m && std::abs(point.shift_px) < 15.0)
      shifts_.push_back(point.shift_px);
  }
  shift_ = {.points = static_cast<int>(shifts_.size())};
  if (shifts_.empty()) return;
  shift_.median_px = median_of(shifts_);
  for (double& shift_px : shifts_) shift_px = std::abs(shift_px - shift_.median_px);
  shift_.spread_px = median_of(shifts_);
}

void GroundObserver::fit_ground() {
  ground_ = {};
  const Eigen::Vector3d known(1.0 / (kOffsetDeviation_m * kOffsetDeviation_m),
                              1.0 / (kSlopeDeviation * kSlopeDeviation),
                              1.0 / (kSlopeDeviation * kSlopeDeviation));
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    // Before the first fit a point may be off by what the plane may be.
    const double doubt = iteration == 0 ? 2.0 : iteration == 1 ? 1.0 : 0.3;
    Eigen::Matrix3d normal = known.asDiagonal();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int agree = 0;
    for (const Point& point : points_) {
      const Eigen::Vector3d place(1.0, point.place_m.x() - camera_.translation().x(),
                                  point.place_m.y() - camera_.translation().y());
      const double prior_m = doubt * std::hypot(kOffsetDeviation_m, kSlopeDeviation * point.distance_m);
      const double deviation_m = std::hypot(point.deviation_m, prior_m);
      const double off = (point.place_m.z() - place.dot(plane)) / (kCut * deviation_m);
      if (std::abs(off) >= 1.0) continue;
      const double keep = 1.0 - off * off;
      const double weight = kIndependent * keep * keep / (point.deviation_m * point.deviation_m);
      normal += weight * place * place.transpose();
      sum += weight * point.place_m.z() * place;
      ++agree;
    }
    plane = normal.ldlt().solve(sum);
    ground_.points = agree;
  }
  ground_.offset_m = plane[0];
  ground_.slope = plane.tail<2>();
}

double GroundObserver::above_ground_m(const Point& point) const noexcept {
  const Eigen::Vector2d from_camera = (point.place_m - camera_.translation()).head<2>();
  return point.place_m.z() - ground_.offset_m - ground_.slope.dot(from_camera);
}

void GroundObserver::count(const HeightMap& map) {
  for (const int cell : touched_) tallies_[static_cast<std::size_t>(cell)] = {};
  touched_.clear();
  for (const Point& point : points_) {
    const double height_m = above_ground_m(point);
    if (height_m > parameters_.highest_m) continue;
    if ((point.place_m.head<2>() - base_m_).norm() < parameters_.own_radius_m) continue;
    const int cell = map.cell_at(point.place_m.x(), point.place_m.y());
    if (cell < 0) continue;
    const double doubt_m = kCut * point.deviation_m + kUncalibrated * point.distance_m;
    Tally& tally = tallies_[static_cast<std::size_t>(cell)];
    if (tally.ground == 0 && tally.obstacle == 0) touched_.push_back(cell);
    if (height_m > std::max(parameters_.least_height_m, doubt_m)) {
      ++tally.obstacle;
      const Eigen::Vector2d off_m = point.place_m.head<2>() - map.middle_of(cell);
      tally.sum_m += off_m;
      tally.squares_m2 +=
          Eigen::Vector3d(off_m.x() * off_m.x(), off_m.y() * off_m.y(), off_m.x() * off_m.y());
      if (height_m > tally.top_m)
        tally.second_m = std::exchange(tally.top_m, height_m);
      else
        tally.second_m = std::max(tally.second_m, height_m);
    } else if (height_m > -std::max(parameters_.least_height_m, doubt_m)) {
      ++tally.ground;
      tally.ground_m += height_m;
    } else if (tally.ground == 0 && tally.obstacle == 0) {
      touched_.pop_back();  // what lies below the ground is neither free nor in the way
    }
  }
}

GroundObserver::Sight GroundObserver::sight_of(const Eigen::Vector3d& place_m, double cell_m) const {
  const Eigen::Vector3d seen = camera_.inverse() * place_m;
  if (seen.z() < 0.15) return Sight::nothing;
  const Eigen::Vector2d pixel = geometry_.project(seen);
  const int x = static_cast<int>(std::lround(pixel.x())), y = static_cast<int>(std::lround(pixel.y()));
  if (x < 1 || y < 1 || x >= disparity_.cols - 1 || y >= disparity_.rows - 1) return Sight::nothing;
  int known = 0, most = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int measured = disparity_.at<std::int16_t>(y + dy, x + dx);
      known += measured > 0 ? 1 : 0;
      most = std::max(most, measured);
    }
  }
  if (known < kKnownAround) return Sight::nothing;
  const double nearest_px = most / DisparityMatcher::kUnits;
  const double margin_px = std::max(1.0, kCut * parameters_.disparity_deviation_px);
  if (nearest_px < geometry_.disparity_px(seen.z() + cell_m) - margin_px) return Sight::farther;
  return nearest_px > geometry_.disparity_px(seen.z()) + margin_px ? Sight::nearer : Sight::about_there;
}

// An obstacle is gone where the picture shows what is farther in its place; a low one, behind which the
// ground is hardly farther, where its cell shows ground and nothing hides it.
bool GroundObserver::is_gone(const HeightMap& map, int cell, bool shows_ground) const {
  const Eigen::Vector2d at_m = map.obstacle_m(cell);
  bool is_through = true, is_hidden = false;
  for (const double share : {0.4, 0.8}) {
    const Sight sight = sight_of({at_m.x(), at_m.y(), share * map.height_m(cell)}, map.cell_m());
    is_through = is_through && sight == Sight::farther;
    is_hidden = is_hidden || sight == Sight::nothing || sight == Sight::nearer;
  }
  return is_through || (shows_ground && !is_hidden);
}

void GroundObserver::tell(HeightMap& map, std::int64_t stamp_ns) {
  count(map);
  for (int cell = 0; cell < kMapSide * kMapSide; ++cell) {
    const Tally& tally = tallies_[static_cast<std::size_t>(cell)];
    const int all = tally.ground + tally.obstacle;
    if (tally.obstacle >= kLeastPoints && tally.obstacle >= kLeastShare * all) {
      const Eigen::Vector2d mean_m = tally.sum_m / tally.obstacle;
      map.see(cell,
              {.what = CellSighting::What::obstacle,
               .height_m = tally.second_m,
               .middle_m = map.middle_of(cell) + mean_m,
               .spread_m2 =
                   tally.squares_m2 / tally.obstacle -
                   Eigen::Vector3d(mean_m.x() * mean_m.x(), mean_m.y() * mean_m.y(), mean_m.x() * mean_m.y()),
               .points = tally.obstacle},
              stamp_ns);
      continue;
    }
    const bool shows_ground = tally.ground >= kLeastPoints && tally.obstacle == 0;
    const double ground_m = shows_ground ? tally.ground_m / tally.ground : 0.0;
    const CellSighting ground{.what = CellSighting::What::ground, .height_m = ground_m};
    if (map.state(cell) != CellState::obstacle) {
      if (shows_ground) map.see(cell, ground, stamp_ns);
    } else if (tally.obstacle == 0 && is_gone(map, cell, shows_ground)) {
      map.see(cell, shows_ground ? ground : CellSighting{.what = CellSighting::What::seen_through}, stamp_ns);
    }
  }
}

}  // namespace gaitway::vision
