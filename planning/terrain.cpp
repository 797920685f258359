// Spreads the ground over the map, and counts ahead so that outlines are tested row by row.
#include "terrain.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaitway::planning {
namespace {

constexpr int kWidest = 4000 + 2000;  // a row's count fits 16 bits
constexpr float kEdgeShare = 0.5F;    // of sole_unevenness_m, between neighbouring cells: no slope, an edge

}  // namespace

Terrain::Terrain(const GroundMap& map, const Limits& limits, const Eigen::Vector2d& from_m, double reach_m)
    : grid_(map.grid), margin_(std::min(static_cast<int>(std::ceil(reach_m / map.grid.cell_m)) + 2, 1000)) {
  static_assert(kWidest <= std::numeric_limits<std::uint16_t>::max());
  width_ = static_cast<std::size_t>(grid_.columns + 2 * margin_);
  height_ = static_cast<std::size_t>(grid_.rows + 2 * margin_);
  surface_m_.assign(width_ * height_, std::numeric_limits<float>::infinity());
  for (int row = 0; row < grid_.rows; ++row) {
    const auto first = map.surface_m.begin() + static_cast<std::ptrdiff_t>(row) * grid_.columns;
    std::copy(first, first + grid_.columns, surface_m_.begin() + static_cast<std::ptrdiff_t>(at({0, row})));
  }
  spread_ground(map, limits, cell_of(from_m.x(), from_m.y()));
  find_what_is_in_the_way(map, limits);
  count_edges(limits);
}

Cell Terrain::cell_of(double x_m, double y_m) const noexcept {
  const auto index = [this](double from_m, double to_m) {
    return static_cast<int>(std::floor(std::clamp((to_m - from_m) / grid_.cell_m, -1e6, 1e6)));
  };
  return {index(grid_.origin_m.x(), x_m), index(grid_.origin_m.y(), y_m)};
}

// Breadth first over ground that can be walked on; where that ends, over everything else, which takes over
// the ground that it is reached from, until it comes to more ground that lies no higher or lower.
void Terrain::spread_ground(const GroundMap& map, const Limits& limits, const Cell& from) {
  const std::size_t cells = static_cast<std::size_t>(grid_.columns) * static_cast<std::size_t>(grid_.rows);
  footing_.assign(width_ * height_, 0);
  ground_m_.assign(width_ * height_, std::numeric_limits<float>::quiet_NaN());
  std::vector<std::uint32_t> walked, carried, next;  // queues: indices of the map
  walked.reserve(cells);
  const auto step_m = static_cast<float>(limits.max_step_height_m) + 1e-5F;
  const auto columns = static_cast<std::uint32_t>(grid_.columns);
  const auto visit = [&](std::uint32_t cell, float ground_m) {
    const std::size_t here = at({static_cast<int>(cell % columns), static_cast<int>(cell / columns)});
    if (footing_[here] != 0) return;
    const float surface_m = map.surface_m[cell];
    if (map.is_ground[cell] != 0 && std::abs(surface_m - ground_m) <= step_m) {
      footing_[here] = 1;
      ground_m_[here] = surface_m;
      walked.push_back(cell);
    } else if (std::isnan(ground_m_[here])) {
      ground_m_[here] = ground_m;
      carried.push_back(cell);
    }
  };
  const Cell start{std::clamp(from.column, 0, grid_.columns - 1), std::clamp(from.row, 0, grid_.rows - 1)};
  const auto first =
      static_cast<std::uint32_t>(start.row) * columns + static_cast<std::uint32_t>(start.column);
  visit(first, map.surface_m[first]);
  std::size_t done_walked = 0, done_carried = 0;
  while (done_walked < walked.size() || done_carried < carried.size()) {
    const std::uint32_t cell = done_walked < walked.size() ? walked[done_walked++] : carried[done_carried++];
    const auto column = static_cast<int>(cell % columns), row = static_cast<int>(cell / columns);
    const float ground_m = ground_m_[at({column, row})];
    if (column > 0) visit(cell - 1, ground_m);
    if (column + 1 < grid_.columns) visit(cell + 1, ground_m);
    if (row > 0) visit(cell - columns, ground_m);
    if (row + 1 < grid_.rows) visit(cell + columns, ground_m);
  }
}

void Terrain::find_what_is_in_the_way(const GroundMap& map, const Limits& limits) {
  in_way_.assign(limits.bands.size(), std::vector<std::uint8_t>(width_ * height_, 1));
  counted_.assign(limits.bands.size(), std::vector<std::uint16_t>((width_ + 1) * height_, 0));
  const auto top_m = static_cast<float>(limits.height_m);
  float lowest_m = std::numeric_limits<float>::infinity(), highest_m = -lowest_m;
  for (std::size_t cell = 0; cell < footing_.size(); ++cell) {
    if (footing_[cell] == 0) continue;
    lowest_m = std::min(lowest_m, ground_m_[cell]);
    highest_m = std::max(highest_m, ground_m_[cell]);
  }
  const double lower_m = std::clamp(static_cast<double>(highest_m - lowest_m), 0.0, limits.max_step_height_m);
  for (std::size_t band = 0; band < limits.bands.size(); ++band) {
    // Who stands a step lower than what is in the way is nearer to its top.
    const auto from_m = static_cast<float>(std::max(limits.bands[band].from_m - lower_m, 0.0));
    std::vector<std::uint8_t>& in_way = in_way_[band];
    for (int row = 0; row < grid_.rows; ++row) {
      std::size_t here = at({0, row});
      std::size_t cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns);
      for (int column = 0; column < grid_.columns; ++column, ++here, ++cell) {
        const bool above = surface_m_[here] > ground_m_[here] + from_m;
        const bool below = map.underside_m[cell] < ground_m_[here] + top_m;  // false for NaN
        in_way[here] = above || below ? 1 : 0;
      }
    }
    for (std::size_t row = 0; row < height_; ++row) {
      std::uint16_t count = 0;
      std::uint16_t* const counted = counted_[band].data() + row * (width_ + 1);
      for (std::size_t column = 0; column < width_; ++column) {
        counted[column] = count;
        count = static_cast<std::uint16_t>(count + in_way[row * width_ + column]);
      }
      counted[width_] = count;
    }
  }
}

// Integral image of cells that are no footing, or differ much from the next one.
void Terrain::count_edges(const Limits& limits) {
  const float edge_m = kEdgeShare * static_cast<float>(limits.sole_unevenness_m);
  edges_.assign((width_ + 1) * (height_ + 1), 0);
  for (std::size_t row = 0; row < height_; ++row) {
    std::uint32_t count = 0;
    for (std::size_t column = 0; column < width_; ++column) {
      const std::size_t here = row * width_ + column;
      bool edge = footing_[here] == 0;
      if (!edge) {  // the margin is no footing: there are neighbours
        edge = std::abs(surface_m_[here] - surface_m_[here + 1]) > edge_m ||
               std::abs(surface_m_[here] - surface_m_[here + width_]) > edge_m;
      }
      count += edge ? 1 : 0;
      edges_[(row + 1) * (width_ + 1) + column + 1] = edges_[row * (width_ + 1) + column + 1] + count;
    }
  }
}

bool Terrain::is_free(std::size_t band, const Cell& origin, std::span<const CellSpan> spans) const noexcept {
  const std::uint16_t* const counted = counted_[band].data();
  for (const CellSpan& span : spans) {
    const std::size_t row = static_cast<std::size_t>(origin.row + span.row + margin_) * (width_ + 1);
    const auto from = static_cast<std::size_t>(origin.column + span.from + margin_);
    const auto to = static_cast<std::size_t>(origin.column + span.to + margin_);
    if (counted[row + to + 1] != counted[row + from]) return false;
  }
  return true;
}

bool Terrain::is_square_free(std::size_t band, Cell least, Cell greatest) const noexcept {
  const std::uint16_t* const counted = counted_[band].data();
  const auto from = static_cast<std::size_t>(std::max(least.column + margin_, 0));
  const auto to = std::min(static_cast<std::size_t>(greatest.column + margin_), width_ - 1);
  const int first = std::max(least.row + margin_, 0);
  const int last = std::min(greatest.row + margin_, static_cast<int>(height_) - 1);
  for (int row = first; row <= last; ++row) {
    const std::size_t begin = static_cast<std::size_t>(row) * (width_ + 1);
    if (counted[begin + to + 1] != counted[begin + from]) return false;
  }
  return true;
}

Terrain::Ground Terrain::ground_under(const Cell& origin, std::span<const CellSpan> spans) const noexcept {
  Ground ground;
  for (const CellSpan& span : spans) {
    const std::size_t first = at({origin.column + span.from, origin.row + span.row});
    const std::size_t last = first + static_cast<std::size_t>(span.to - span.from);
    std::uint8_t footing = 1;
    for (std::size_t cell = first; cell <= last; ++cell) {
      footing &= footing_[cell];
      ground.lowest_m = std::min(ground.lowest_m, surface_m_[cell]);
      ground.highest_m = std::max(ground.highest_m, surface_m_[cell]);
    }
    if (footing == 0) ground.is_footing = false;
  }
  return ground;
}

float Terrain::highest_m(const Cell& origin, std::span<const CellSpan> spans) const noexcept {
  float highest_m = -std::numeric_limits<float>::infinity();
  for (const CellSpan& span : spans) {
    const std::size_t first = at({origin.column + span.from, origin.row + span.row});
    const std::size_t last = first + static_cast<std::size_t>(span.to - span.from);
    for (std::size_t cell = first; cell <= last; ++cell) highest_m = std::max(highest_m, surface_m_[cell]);
  }
  return highest_m;
}

bool Terrain::is_smooth(Cell least, Cell greatest) const noexcept {
  const auto count = [this](int column, int row) {
    return edges_[static_cast<std::size_t>(row + margin_) * (width_ + 1) +
                  static_cast<std::size_t>(column + margin_)];
  };
  return count(greatest.column + 1, greatest.row + 1) - count(least.column, greatest.row + 1) -
             count(greatest.column + 1, least.row) + count(least.column, least.row) ==
         0;
}

}  // namespace gaitway::planning
