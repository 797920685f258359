// Evidence for and against an obstacle, cell by cell.
#include "gaitway/vision/height_map.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::vision {
namespace {

// Evidence: three sightings of an obstacle, or two of the ground, tell what an unknown cell is; an obstacle
// that was seen for long takes ten sightings of the ground to become free.
constexpr int kObstacleVote = 2, kGroundVote = -1;
constexpr int kMostEvidence = 8, kLeastEvidence = -6;
constexpr int kIsObstacle = 5, kIsFree = -2;
constexpr int kMostWeight = 60;       // points whose mean the offset is: later ones count as exponential mean
constexpr double kOffsets = 250.0;    // in a cell's side
constexpr double kHeightShare = 0.3;  // by which a new height moves the old one
constexpr int kStateUnit = 32;        // in a packed cell
constexpr std::uint8_t kRestoredWeight = 20;
constexpr float kRestoredSpread = 1.0F / 24.0F;  // in cells²: between a full cell's and nothing
constexpr std::int64_t kAge_ns = 100'000'000;

std::int16_t blended_mm(std::int16_t known_mm, double seen_m, bool first) noexcept {
  const double seen_mm = std::clamp(1e3 * seen_m, -32'000.0, 32'000.0);
  return static_cast<std::int16_t>(
      std::lround(first ? seen_mm : known_mm + kHeightShare * (seen_mm - known_mm)));
}

std::uint8_t tenths(std::int64_t age_ns) noexcept {
  return static_cast<std::uint8_t>(std::clamp<std::int64_t>(age_ns / kAge_ns, 0, 255));
}

}  // namespace

HeightMap::HeightMap(double cell_m) : cell_m_(cell_m) {}

void HeightMap::centre(const Eigen::Vector2d& middle_m) noexcept {
  const int x = static_cast<int>(std::floor(middle_m.x() / cell_m_)) - kMapSide / 2;
  const int y = static_cast<int>(std::floor(middle_m.y() / cell_m_)) - kMapSide / 2;
  if (std::max(std::abs(x - corner_x_), std::abs(y - corner_y_)) <= kMapSide / 10) return;
  HeightMap moved(cell_m_);
  for (int to_y = 0; to_y < kMapSide; ++to_y) {
    const int from_y = to_y + y - corner_y_;
    if (from_y < 0 || from_y >= kMapSide) continue;
    for (int to_x = 0; to_x < kMapSide; ++to_x) {
      const int from_x = to_x + x - corner_x_;
      if (from_x < 0 || from_x >= kMapSide) continue;
      const auto to = static_cast<std::size_t>(to_y * kMapSide + to_x);
      const auto from = static_cast<std::size_t>(from_y * kMapSide + from_x);
      moved.cells_[to] = cells_[from];
      moved.seen_ns_[to] = seen_ns_[from];
    }
  }
  moved.corner_x_ = x;
  moved.corner_y_ = y;
  *this = moved;
}

int HeightMap::cell_at(double x_m, double y_m) const noexcept {
  const double x = std::floor(x_m / cell_m_) - corner_x_;
  const double y = std::floor(y_m / cell_m_) - corner_y_;
  if (!(x >= 0.0 && x < kMapSide && y >= 0.0 && y < kMapSide)) return -1;
  return static_cast<int>(y) * kMapSide + static_cast<int>(x);
}

Eigen::Vector2d HeightMap::middle_of(int cell) const noexcept {
  return cell_m_ * Eigen::Vector2d(corner_x_ + cell % kMapSide + 0.5, corner_y_ + cell / kMapSide + 0.5);
}

Eigen::Vector2d HeightMap::obstacle_m(int cell) const noexcept {
  const Cell& known = at(cell);
  return middle_of(cell) + cell_m_ / kOffsets * Eigen::Vector2d(known.offset_x, known.offset_y);
}

Eigen::Vector3d HeightMap::spread_m2(int cell) const noexcept {
  const Cell& known = at(cell);
  const Eigen::Vector2d offset = Eigen::Vector2d(known.offset_x, known.offset_y) / kOffsets;
  const Eigen::Vector3d about_middle = Eigen::Map<const Eigen::Vector3f>(known.moment.data()).cast<double>();
  const Eigen::Vector3d spread(std::max(about_middle.x() - offset.x() * offset.x(), 0.0),
                               std::max(about_middle.y() - offset.y() * offset.y(), 0.0),
                               about_middle.z() - offset.x() * offset.y());
  return cell_m_ * cell_m_ * spread;
}

void HeightMap::place(Cell& cell, int index, const CellSighting& sighting) const noexcept {
  const double share = std::min(
      1.0, static_cast<double>(sighting.points) / static_cast<double>(cell.weight + sighting.points));
  const Eigen::Vector2d seen = kOffsets / cell_m_ * (sighting.middle_m - middle_of(index));
  const auto moved = [share](std::int8_t known, double to) {
    return static_cast<std::int8_t>(std::lround(std::clamp(known + share * (to - known), -127.0, 127.0)));
  };
  const Eigen::Vector2d middle = seen / kOffsets;
  const Eigen::Vector3f moment =
      (sighting.spread_m2 / (cell_m_ * cell_m_) +
       Eigen::Vector3d(middle.x() * middle.x(), middle.y() * middle.y(), middle.x() * middle.y()))
          .cast<float>();
  Eigen::Map<Eigen::Vector3f> known_moment(cell.moment.data());
  known_moment += static_cast<float>(share) * (moment - known_moment);
  cell.offset_x = moved(cell.offset_x, seen.x());
  cell.offset_y = moved(cell.offset_y, seen.y());
  cell.weight = static_cast<std::uint8_t>(std::min(cell.weight + sighting.points, kMostWeight));
}

void HeightMap::see(int index, const CellSighting& sighting, std::int64_t stamp_ns) noexcept {
  Cell& cell = cells_[static_cast<std::size_t>(index)];
  const bool is_obstacle = sighting.what == CellSighting::What::obstacle;
  const bool was_unknown = cell.state == CellState::unknown && cell.evidence == 0;
  cell.evidence = static_cast<std::int8_t>(
      std::clamp(cell.evidence + (is_obstacle ? kObstacleVote : kGroundVote), kLeastEvidence, kMostEvidence));
  if (is_obstacle) {
    place(cell, index, sighting);
    cell.height_mm = blended_mm(cell.height_mm, sighting.height_m,
                                was_unknown || cell.height_mm < 500.0 * sighting.height_m);
  } else if (sighting.what == CellSighting::What::ground && cell.state != CellState::obstacle) {
    cell.height_mm = blended_mm(cell.height_mm, sighting.height_m, was_unknown);
  }
  if (cell.evidence >= kIsObstacle) {
    cell.state = CellState::obstacle;
  } else if (cell.evidence <= kIsFree && sighting.what == CellSighting::What::ground) {
    if (cell.state == CellState::obstacle) cell.height_mm = blended_mm(0, sighting.height_m, true);
    cell.state = CellState::free;
    cell.weight = 0;
  } else if (cell.evidence <= kIsFree && cell.state == CellState::obstacle) {
    cell = Cell{};  // gone, but its ground was not seen
  }
  // What contradicts a cell's state does not make it newer.
  if (cell.state == CellState::unknown || is_obstacle == (cell.state == CellState::obstacle)) {
    seen_ns_[static_cast<std::size_t>(index)] = stamp_ns;
  }
}

void HeightMap::forget(std::int64_t seen_before_ns) noexcept {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i].state != CellState::obstacle && seen_ns_[i] < seen_before_ns) cells_[i] = Cell{};
  }
}

void HeightMap::write(GroundMap& map, std::int64_t stamp_ns) const noexcept {
  map.stamp_ns = stamp_ns;
  map.corner[0] = corner_m().x();
  map.corner[1] = corner_m().y();
  map.cell = cell_m_;
  for (int y = 0; y < kMapSide; ++y) {
    for (int x = 0; x < kMapSide; ++x) {
      const auto i = static_cast<std::size_t>(y * kMapSide + x);
      const bool is_known = cells_[i].state != CellState::unknown;
      map.state[y][x] = static_cast<std::uint8_t>(cells_[i].state);
      map.height[y][x] = is_known ? 1e-3F * static_cast<float>(cells_[i].height_mm) : 0.0F;
      map.seen[y][x] = is_known ? tenths(stamp_ns - seen_ns_[i]) : std::uint8_t{0};
    }
  }
}

HeightMap::Packed HeightMap::packed(std::int64_t now_ns) const noexcept {
  Packed packed{};
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Cell& cell = cells_[i];
    packed[i] = {.state_and_evidence = static_cast<std::uint8_t>(static_cast<int>(cell.state) * kStateUnit +
                                                                 cell.evidence - kLeastEvidence),
                 .offset_x = cell.offset_x,
                 .offset_y = cell.offset_y,
                 .age = tenths(now_ns - seen_ns_[i]),
                 .height_mm = cell.height_mm};
  }
  return packed;
}

void HeightMap::unpack(const Packed& packed, std::int64_t now_ns) noexcept {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const PackedCell& from = packed[i];
    Cell& cell = cells_[i];
    cell.state = static_cast<CellState>(std::min(from.state_and_evidence / kStateUnit, 2));
    cell.evidence = static_cast<std::int8_t>(
        std::min(from.state_and_evidence % kStateUnit + kLeastEvidence, kMostEvidence));
    cell.offset_x = from.offset_x;
    cell.offset_y = from.offset_y;
    cell.weight = cell.state == CellState::obstacle ? kRestoredWeight : std::uint8_t{0};
    cell.height_mm = from.height_mm;
    const auto x = static_cast<float>(from.offset_x / kOffsets),
               y = static_cast<float>(from.offset_y / kOffsets);
    cell.moment = {kRestoredSpread + x * x, kRestoredSpread + y * y, x * y};
    seen_ns_[i] = now_ns - from.age * kAge_ns;
  }
}

}  // namespace gaitway::vision
