// Chooses landings all over what the limits allow, and lays their cells out once and for all.
#include "step_lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "gaitway/planning/swept_body.hpp"

namespace gaitway::planning {
namespace {

constexpr double kDearest = 0.2;  // of a step at the limits, above one on the spot

// Shares of the longest step (ahead or back), of the widest and of the largest turn (positive: toes outward).
struct Wanted {
  double ahead, side, turn;
};
constexpr std::array kWanted{
    Wanted{1.0, 0.0, 0.0},   Wanted{0.75, 0.0, 0.0}, Wanted{0.5, 0.0, 0.0},   Wanted{0.25, 0.0, 0.0},
    Wanted{0.0, 0.0, 0.0},   Wanted{-0.5, 0.0, 0.0}, Wanted{-1.0, 0.0, 0.0},  Wanted{0.9, 0.0, 0.4},
    Wanted{0.9, 0.0, -0.4},  Wanted{0.96, 0.0, 0.2}, Wanted{0.96, 0.0, -0.2}, Wanted{0.6, 0.0, 0.8},
    Wanted{0.6, 0.0, -0.8},  Wanted{0.3, 0.0, 0.4},  Wanted{0.3, 0.0, -0.4},  Wanted{0.0, 0.0, 1.0},
    Wanted{0.0, 0.0, -1.0},  Wanted{0.0, 0.0, 0.5},  Wanted{0.0, 0.0, -0.5},  Wanted{-0.6, 0.0, 0.6},
    Wanted{-0.6, 0.0, -0.6}, Wanted{0.0, 1.0, 0.0},  Wanted{0.0, 0.5, 0.0},   Wanted{0.7, 0.7, 0.0},
    Wanted{0.9, 0.35, 0.0},  Wanted{-0.6, 0.6, 0.0}, Wanted{0.0, 0.6, 0.6},   Wanted{0.0, 0.6, -0.6}};

Pose landing_of(const Limits& limits, const Wanted& wanted, Side swing) {
  const double outward_rad = wanted.turn * limits.max_step_turn_rad;
  const double lateral_m = std::max(limits.foot_spacing_m, limits.least_spacing_m(outward_rad)) +
                           wanted.side * (limits.max_foot_spacing_m - limits.foot_spacing_m);
  return {wanted.ahead * (wanted.ahead >= 0.0 ? limits.max_step_forward_m : limits.max_step_backward_m),
          sign_of(swing) * std::min(lateral_m, limits.max_foot_spacing_m), sign_of(swing) * outward_rad};
}

int turned(int direction, int by) noexcept {
  return ((direction + by) % kDirections + kDirections) % kDirections;
}

}  // namespace

double cost_of(double effort) noexcept {
  return 1.0 + kDearest * effort * effort;
}

double StepLattice::Fastest::norm(double way, double turn) const noexcept {
  return std::hypot(way / way_m, turn / turn_rad);
}

StepLattice::StepLattice(const Limits& limits, double cell_m, int pitch)
    : limits_(limits), cell_m_(cell_m), pitch_(pitch), sets_(2 * kDirections) {
  const Points corners = sole_corners(limits_.sole);
  for (int direction = 0; direction < kDirections; ++direction) {
    Points sole;
    add_outline(sole, corners, {0.0, 0.0, yaw_rad(direction)});
    soles_.emplace_back();
    add_spans(soles_.back(), sole, 0.5 * cell_m_, Eigen::Vector2d::Zero(), cell_m_);
    wide_soles_.emplace_back();
    add_spans(wide_soles_.back(), sole, 1.5 * cell_m_, Eigen::Vector2d::Zero(), cell_m_);
    for (const CellSpan& span : wide_soles_.back()) {
      sole_radius_ = std::max({sole_radius_, std::abs(span.row), std::abs(span.from), std::abs(span.to)});
    }
    for (const Side stance : {Side::left, Side::right}) choose_landings(stance, direction);
  }
  find_fastest();
  for (int direction = 0; direction < kDirections; ++direction) {
    for (const Side stance : {Side::left, Side::right}) lay_out(stance, direction);
  }
}

double StepLattice::yaw_rad(int direction) const noexcept {
  return wrapped(2.0 * std::numbers::pi / kDirections * direction);
}

int StepLattice::nearest_direction(double yaw_rad) const noexcept {
  return turned(static_cast<int>(std::lround(wrapped(yaw_rad) / (2.0 * std::numbers::pi) * kDirections)), 0);
}

// The place next to `wanted` (in the stance foot's frame) that the limits allow.
bool StepLattice::snap(const Pose& stance, Side swing, const Pose& wanted, const Eigen::Vector2d& origin_m,
                       Place& found) const {
  constexpr double kArm_m = 0.1;  // by which a turn counts as a way
  const Pose at = stance.compose(wanted);
  const double node_m = pitch_ * cell_m_;
  const double column = (at.x_m - origin_m.x()) / node_m, row = (at.y_m - origin_m.y()) / node_m;
  const double direction = at.yaw_rad / (2.0 * std::numbers::pi) * kDirections;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 8; ++i) {
    const int c = static_cast<int>(std::floor(column)) + (i & 1);
    const int r = static_cast<int>(std::floor(row)) + (i >> 1 & 1);
    const int d = turned(static_cast<int>(std::floor(direction)) + (i >> 2 & 1), 0);
    const Pose place{origin_m.x() + c * node_m, origin_m.y() + r * node_m, yaw_rad(d)};
    const Pose landing = stance.relative_of(place);
    if (!(limits_.effort(landing, swing) <= kMostEffort)) continue;
    const double off =
        std::hypot(place.x_m - at.x_m, place.y_m - at.y_m, kArm_m * wrapped(place.yaw_rad - at.yaw_rad));
    if (off >= least) continue;
    least = off;
    found = {{c * pitch_, r * pitch_}, d};
  }
  return std::isfinite(least);
}

std::vector<Place> StepLattice::places_from(const Pose& stance, Side stance_side,
                                            const Eigen::Vector2d& origin_m) const {
  std::vector<Place> places;
  for (const Wanted& wanted : kWanted) {
    Place place;
    if (!snap(stance, other(stance_side), landing_of(limits_, wanted, other(stance_side)), origin_m, place)) {
      continue;
    }
    if (std::ranges::find(places, place) == places.end()) places.push_back(place);
  }
  return places;
}

void StepLattice::choose_landings(Side stance, int direction) {
  Set& set = sets_[index(stance, direction)];
  const Pose foot{0.0, 0.0, yaw_rad(direction)};
  for (const Place& place : places_from(foot, stance, Eigen::Vector2d::Zero())) {
    int turn = place.direction - direction;
    if (turn > kDirections / 2) turn -= kDirections;
    if (turn < -kDirections / 2) turn += kDirections;
    const Pose at{place.cell.column * cell_m_, place.cell.row * cell_m_, yaw_rad(place.direction)};
    set.landings.push_back({place.cell.column, place.cell.row, turn,
                            cost_of(limits_.effort(foot.relative_of(at), other(stance)))});
  }
}

void StepLattice::find_fastest() {
  constexpr double kMoreTurn = 1.1;  // than any step: what is left bounds the way
  fastest_.turn_rad = kMoreTurn * limits_.max_step_turn_rad;
  fastest_.cost_per_norm = std::numeric_limits<double>::infinity();
  std::vector<std::array<double, 3>> steps;  // way, turn, cost
  for (const Side stance : {Side::left, Side::right}) {
    for (int direction = 0; direction < kDirections; ++direction) {
      const Pose foot{0.0, 0.0, yaw_rad(direction)};
      const Pose before = limits_.middle_beside(foot, stance);
      for (const Landing& landing : landings(stance, direction)) {
        const Pose at{landing.columns * cell_m_, landing.rows * cell_m_,
                      yaw_rad(turned(direction, landing.turn))};
        const Pose after = limits_.middle_beside(at, other(stance));
        const double way_m = std::hypot(after.x_m - before.x_m, after.y_m - before.y_m);
        const double turn_rad = std::abs(wrapped(after.yaw_rad - before.yaw_rad));
        steps.push_back({way_m, turn_rad, landing.cost});
        const double share = turn_rad / fastest_.turn_rad;
        fastest_.way_m = std::max(fastest_.way_m, way_m / std::sqrt(1.0 - share * share));
        reach_m_ = std::max(reach_m_, std::hypot(at.x_m, at.y_m));
      }
    }
  }
  for (const auto& [way_m, turn_rad, cost] : steps) {
    const double norm = fastest_.norm(way_m, turn_rad);
    if (norm > 0.0) fastest_.cost_per_norm = std::min(fastest_.cost_per_norm, cost / norm);
  }
  double outline_m = 0.0;
  for (const Band& band : limits_.bands) outline_m = std::max(outline_m, outer_radius_m(band.outline_m));
  reach_m_ += limits_.foot_spacing_m +
              std::max(outline_m + 1.1 * limits_.clearance_m, limits_.sole.length_m) + 4.0 * cell_m_;
}

Points body_points(const Limits& limits, std::size_t band, const Pose& stance, Side stance_side,
                   const Pose& landing) {
  const Pose over_stance = limits.middle_beside(stance, stance_side);
  const Pose between = middle_of(stance, landing);
  const Pose over_landing = limits.middle_beside(landing, other(stance_side));
  Points points;
  const std::vector<Eigen::Vector2d>& outline = limits.bands[band].outline_m;
  for (const Pose& pose : {over_stance, middle_of(over_stance, between), between,
                           middle_of(between, over_landing), over_landing}) {
    add_outline(points, outline, pose);
  }
  return points;
}

std::vector<Eigen::Vector2d> swept_body(const Limits& limits, std::size_t band, const Pose& stance,
                                        Side stance_side, const Pose& landing) {
  return convex_hull(body_points(limits, band, stance, stance_side, landing));
}

void StepLattice::lay_out(Side stance, int direction) {
  Set& set = sets_[index(stance, direction)];
  const Pose foot{0.0, 0.0, yaw_rad(direction)};
  const Points corners = sole_corners(limits_.sole);
  for (const Landing& landing : set.landings) {
    const Pose at{landing.columns * cell_m_, landing.rows * cell_m_,
                  yaw_rad(turned(direction, landing.turn))};
    for (std::size_t band = 0; band < limits_.bands.size(); ++band) {
      set.first_span.push_back(static_cast<std::uint32_t>(set.spans.size()));
      add_spans(set.spans, body_points(limits_, band, foot, stance, at), limits_.clearance_m,
                Eigen::Vector2d::Zero(), cell_m_);
      if (band != 0) continue;
      Points soles;
      add_outline(soles, corners, foot);
      add_outline(soles, corners, at);
      add_spans(set.spans, soles, 0.0, Eigen::Vector2d::Zero(), cell_m_);
    }
  }
  set.first_span.push_back(static_cast<std::uint32_t>(set.spans.size()));
}

std::span<const CellSpan> StepLattice::body(Side stance, int direction, std::size_t landing,
                                            std::size_t band) const noexcept {
  const Set& set = sets_[index(stance, direction)];
  const std::size_t part = landing * limits_.bands.size() + band;
  return std::span(set.spans).subspan(set.first_span[part], set.first_span[part + 1] - set.first_span[part]);
}

}  // namespace gaitway::planning
