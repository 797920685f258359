// Tests steps against the terrain: those of the lattice by cells that were laid out before, others by their
// own outlines.
#include "step_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaitway::planning {
namespace {

constexpr double kRounding_m = 1e-5;  // heights are kept as float
constexpr int kLooks = 16;            // along a swing

double least_jerk(double share) noexcept {
  return share * share * share * (10.0 + share * (-15.0 + 6.0 * share));
}

}  // namespace

bool StepCheck::is_step_height(double from_m, double to_m) const noexcept {
  return std::abs(to_m - from_m) <= limits_.max_step_height_m + kRounding_m;
}

std::optional<double> StepCheck::height_at(const Place& place) const noexcept {
  if (!terrain_.contains(place.cell)) return std::nullopt;
  const Terrain::Ground ground = terrain_.ground_under(place.cell, lattice_.sole(place.direction));
  if (!ground.is_footing || ground.highest_m - ground.lowest_m > limits_.sole_unevenness_m + kRounding_m) {
    return std::nullopt;
  }
  const double around_m = terrain_.highest_m(place.cell, lattice_.wide_sole(place.direction));
  if (around_m > ground.highest_m + limits_.sole_unevenness_m + kRounding_m) return std::nullopt;
  return ground.highest_m;
}

std::optional<double> StepCheck::height_at(const Pose& foot) const {
  const Cell cell = terrain_.cell_of(foot.x_m, foot.y_m);
  if (!terrain_.contains(cell)) return std::nullopt;
  Points sole;
  add_outline(sole, sole_corners(limits_.sole), foot);
  std::vector<CellSpan> spans;
  add_spans(spans, sole, 0.5 * terrain_.cell_m(), terrain_.corner_m(cell), terrain_.cell_m());
  const Terrain::Ground ground = terrain_.ground_under(cell, spans);
  if (!ground.is_footing || ground.highest_m - ground.lowest_m > limits_.sole_unevenness_m + kRounding_m) {
    return std::nullopt;
  }
  return ground.highest_m;
}

double StepCheck::surface_below_m(const Pose& foot) const noexcept {
  const Eigen::Vector2d middle = foot.point({limits_.sole.centre_forward_m, 0.0});
  const Cell cell = terrain_.cell_of(middle.x(), middle.y());
  return terrain_.contains(cell) ? terrain_.surface_m(cell) : 0.0F;
}

unsigned StepCheck::crowded_bands(const Cell& stance) const noexcept {
  const int reach = terrain_.margin_cells() - 2;
  unsigned crowded = 0;
  for (std::size_t band = 0; band < limits_.bands.size(); ++band) {
    const bool free = terrain_.is_square_free(band, {stance.column - reach, stance.row - reach},
                                              {stance.column + reach, stance.row + reach});
    crowded |= free ? 0U : 1U << band;
  }
  return crowded;
}

bool StepCheck::has_room(const Place& stance, Side side, std::size_t landing,
                         unsigned crowded) const noexcept {
  for (std::size_t band = 0; band < limits_.bands.size(); ++band) {
    if ((crowded >> band & 1U) == 0) continue;
    if (!terrain_.is_free(band, stance.cell, lattice_.body(side, stance.direction, landing, band)))
      return false;
  }
  return true;
}

bool StepCheck::is_on_map(const Points& points) const noexcept {
  return std::ranges::all_of(points, [this](const Eigen::Vector2d& point) {
    return terrain_.contains(terrain_.cell_of(point.x(), point.y()));
  });
}

bool StepCheck::is_free(std::size_t band, const Points& points, double margin_m) const {
  if (!is_on_map(points)) return false;
  const Cell cell = terrain_.cell_of(points.front().x(), points.front().y());
  std::vector<CellSpan> spans;
  add_spans(spans, points, margin_m, terrain_.corner_m(cell), terrain_.cell_m());
  return terrain_.is_free(band, cell, spans);
}

bool StepCheck::has_room(const Pose& stance, Side side, const Pose& landing, double clearance_m) const {
  for (std::size_t band = 0; band < limits_.bands.size(); ++band) {
    if (!is_free(band, body_points(limits_, band, stance, side, landing), clearance_m)) return false;
  }
  Points soles;
  add_outline(soles, sole_corners(limits_.sole), stance);
  add_outline(soles, sole_corners(limits_.sole), landing);
  return is_free(0, soles, 0.0);
}

bool StepCheck::has_room(const Pose& left, const Pose& right, double clearance_m) const {
  for (std::size_t band = 0; band < limits_.bands.size(); ++band) {
    Points points;
    add_outline(points, limits_.bands[band].outline_m, middle_of(left, right));
    if (!is_free(band, points, clearance_m)) return false;
  }
  return true;
}

bool StepCheck::can_swing(const Standing& from, const Standing& to, bool leaves_start) const noexcept {
  const double reach_m = limits_.sole.length_m;
  const Cell least = terrain_.cell_of(std::min(from.pose.x_m, to.pose.x_m) - reach_m,
                                      std::min(from.pose.y_m, to.pose.y_m) - reach_m);
  const Cell greatest = terrain_.cell_of(std::max(from.pose.x_m, to.pose.x_m) + reach_m,
                                         std::max(from.pose.y_m, to.pose.y_m) + reach_m);
  if (terrain_.contains(least) && terrain_.contains(greatest) && terrain_.is_smooth(least, greatest))
    return true;
  const double turn_rad = wrapped(to.pose.yaw_rad - from.pose.yaw_rad);
  for (int look = 1; look < kLooks; ++look) {
    const double time = static_cast<double>(look) / kLooks, way = least_jerk(time);
    const double up = time * (1.0 - time);
    const double sole_m = from.height_m + way * (to.height_m - from.height_m) +
                          limits_.lift_m * 64.0 * up * up * up + limits_.sole_unevenness_m + kRounding_m;
    const double x_m = from.pose.x_m + way * (to.pose.x_m - from.pose.x_m);
    const double y_m = from.pose.y_m + way * (to.pose.y_m - from.pose.y_m);
    const int direction = lattice_.nearest_direction(from.pose.yaw_rad + way * turn_rad);
    // The corner next to it, which is at most half a cell away: the wide sole has one more around it.
    const double half_m = 0.5 * terrain_.cell_m();
    const Cell cell = terrain_.cell_of(x_m + half_m, y_m + half_m);
    if (!terrain_.contains(cell)) return false;
    const int half = lattice_.sole_radius();
    const bool smooth =
        terrain_.is_smooth({cell.column - half, cell.row - half}, {cell.column + half, cell.row + half});
    if (smooth && terrain_.surface_m(cell) <= sole_m) continue;
    const bool narrow = leaves_start && time < 0.5;
    if (terrain_.highest_m(cell, narrow ? lattice_.sole(direction) : lattice_.wide_sole(direction)) >
        sole_m) {
      return false;
    }
  }
  return true;
}

}  // namespace gaitway::planning
