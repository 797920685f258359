// Judges start, goal and the ways between them with one rule less at a time.
#include "diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "distance_field.hpp"

namespace gaitway::planning {
namespace {

constexpr double kAnyHeight_m = 1e6;

std::string at(const Pose& pose) {
  return fmt::format("({:.2f}, {:.2f}) m", pose.x_m, pose.y_m);
}

std::string map_text(const Terrain& terrain) {
  const Eigen::Vector2d least = terrain.corner_m({0, 0});
  const Eigen::Vector2d most = terrain.corner_m({terrain.columns(), terrain.rows()});
  return fmt::format("x from {:.2f} to {:.2f} m and y from {:.2f} to {:.2f} m", least.x(), most.x(),
                     least.y(), most.y());
}

std::vector<CellSpan> sole_cells(const Question& question, const Terrain& terrain, const Pose& foot,
                                 Cell& cell) {
  Points sole;
  add_outline(sole, sole_corners(question.limits.sole), foot);
  cell = terrain.cell_of(foot.x_m, foot.y_m);
  std::vector<CellSpan> spans;
  add_spans(spans, sole, 0.0, terrain.corner_m(cell), terrain.cell_m());
  return spans;
}

bool is_on_map(const Question& question, const Terrain& terrain, const std::array<Pose, 2>& feet) {
  return std::ranges::all_of(feet, [&](const Pose& foot) {
    Cell cell;
    const std::vector<CellSpan> spans = sole_cells(question, terrain, foot, cell);
    return std::ranges::all_of(spans, [&](const CellSpan& span) {
      return terrain.contains({cell.column + span.from, cell.row + span.row}) &&
             terrain.contains({cell.column + span.to, cell.row + span.row});
    });
  });
}

// An obstacle under a sole; of the middle of each cell.
bool is_in_obstacle(const Question& question, const Terrain& terrain, const std::array<Pose, 2>& feet) {
  const world::Grid& grid = question.map.grid;
  for (const Pose& foot : feet) {
    Cell origin;
    for (const CellSpan& span : sole_cells(question, terrain, foot, origin)) {
      for (int column = origin.column + span.from; column <= origin.column + span.to; ++column) {
        const int row = origin.row + span.row;
        const Pose local = foot.relative_of({grid.origin_m.x() + (column + 0.5) * grid.cell_m,
                                             grid.origin_m.y() + (row + 0.5) * grid.cell_m, 0.0});
        const bool below = std::abs(local.x_m - question.limits.sole.centre_forward_m) <=
                               0.5 * question.limits.sole.length_m &&
                           std::abs(local.y_m) <= 0.5 * question.limits.sole.width_m;
        const std::size_t cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                                 static_cast<std::size_t>(column);
        if (below && question.map.is_ground[cell] == 0) return true;
      }
    }
  }
  return false;
}

// From cell to neighbouring cell past everything that is in the way: a body without any width.
bool is_open(const Terrain& terrain, const Limits& limits, const Pose& from, const Pose& to) {
  const auto columns = static_cast<std::size_t>(terrain.columns());
  std::vector<std::uint8_t> seen(columns * static_cast<std::size_t>(terrain.rows()), 0);
  std::vector<Cell> queue;
  const auto visit = [&](const Cell& cell) {
    if (!terrain.contains(cell)) return;
    std::uint8_t& one =
        seen[static_cast<std::size_t>(cell.row) * columns + static_cast<std::size_t>(cell.column)];
    if (one != 0) return;
    for (std::size_t band = 0; band < limits.bands.size(); ++band) {
      if (terrain.is_in_way(band, cell)) return;
    }
    one = 1;
    queue.push_back(cell);
  };
  visit(terrain.cell_of(from.x_m, from.y_m));
  for (std::size_t done = 0; done < queue.size(); ++done) {
    const Cell cell = queue[done];
    visit({cell.column - 1, cell.row});
    visit({cell.column + 1, cell.row});
    visit({cell.column, cell.row - 1});
    visit({cell.column, cell.row + 1});
  }
  const Cell goal = terrain.cell_of(to.x_m, to.y_m);
  return terrain.contains(goal) &&
         seen[static_cast<std::size_t>(goal.row) * columns + static_cast<std::size_t>(goal.column)] != 0;
}

// The body at rest, over places and directions of the lattice, each next to the one before.
bool has_way_for_body(const Question& question, const Terrain& terrain) {
  const StepLattice& lattice = question.lattice;
  const Limits& limits = question.limits;
  std::vector<std::vector<std::vector<CellSpan>>> cells(limits.bands.size());
  for (std::size_t band = 0; band < limits.bands.size(); ++band) {
    for (int direction = 0; direction < kDirections; ++direction) {
      Points points;
      add_outline(points, limits.bands[band].outline_m, {0.0, 0.0, lattice.yaw_rad(direction)});
      cells[band].emplace_back();
      add_spans(cells[band].back(), points, 0.0, Eigen::Vector2d::Zero(), terrain.cell_m());
    }
  }
  const int pitch = lattice.pitch(), columns = terrain.columns() / pitch, rows = terrain.rows() / pitch;
  std::vector<std::uint8_t> seen(
      static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) * kDirections, 0);
  std::vector<Place> queue;
  const auto index = [&](const Place& place) {
    return (static_cast<std::size_t>(place.cell.row) * static_cast<std::size_t>(columns) +
            static_cast<std::size_t>(place.cell.column)) *
               kDirections +
           static_cast<std::size_t>(place.direction);
  };
  const auto visit = [&](int column, int row, int direction) {
    const Place place{{column, row}, (direction + kDirections) % kDirections};
    if (column < 0 || row < 0 || column >= columns || row >= rows || seen[index(place)] != 0) return;
    for (std::size_t band = 0; band < limits.bands.size(); ++band) {
      const auto& spans = cells[band][static_cast<std::size_t>(place.direction)];
      if (!terrain.is_free(band, {column * pitch, row * pitch}, spans)) return;
    }
    seen[index(place)] = 1;
    queue.push_back(place);
  };
  const auto nearest = [&](const Pose& pose) {
    const Cell cell = terrain.cell_of(pose.x_m, pose.y_m);
    return Place{{cell.column / pitch, cell.row / pitch}, lattice.nearest_direction(pose.yaw_rad)};
  };
  const auto around = [&](const Pose& pose, const auto& act) {
    const Place place = nearest(pose);
    for (int i = 0; i < 27; ++i) {
      act(Place{{place.cell.column + i % 3 - 1, place.cell.row + i / 3 % 3 - 1},
                place.direction + i / 9 - 1});
    }
  };
  around(question.start_middle, [&](const Place& p) { visit(p.cell.column, p.cell.row, p.direction); });
  for (std::size_t done = 0; done < queue.size(); ++done) {
    const Place p = queue[done];
    for (const int by : {-1, 1}) {
      visit(p.cell.column + by, p.cell.row, p.direction);
      visit(p.cell.column, p.cell.row + by, p.direction);
      visit(p.cell.column, p.cell.row, p.direction + by);
    }
  }
  bool reached = queue.empty();  // the start is closer to something than the lattice can tell
  around(question.goal_middle, [&](const Place& p) {
    const Place goal{p.cell, (p.direction + kDirections) % kDirections};
    if (goal.cell.column < 0 || goal.cell.row < 0 || goal.cell.column >= columns || goal.cell.row >= rows)
      return;
    reached = reached || seen[index(goal)] != 0;
  });
  return reached;
}

// Over soles' places that are no further from each other than a step.
bool has_way_for_feet(const Question& question, const Terrain& terrain) {
  const StepCheck check(question.limits, question.lattice, terrain);
  const int pitch = question.lattice.pitch();
  const int columns = terrain.columns() / pitch + 1, rows = terrain.rows() / pitch + 1;
  const auto index = [columns](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  };
  std::vector<std::uint8_t> stands(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
  constexpr int kEvery = 4;  // of the directions
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      for (int d = 0; d < kDirections / 2 && stands[index(column, row)] == 0; d += kEvery) {
        const Cell cell{std::min(column * pitch, terrain.columns() - 1),
                        std::min(row * pitch, terrain.rows() - 1)};
        if (check.height_at(Place{cell, d})) stands[index(column, row)] = 1;
      }
    }
  }
  const double cell_m = terrain.cell_m();
  const double step_m = std::hypot(question.limits.max_step_forward_m, question.limits.max_foot_spacing_m);
  const int reach = static_cast<int>(std::ceil(step_m / (cell_m * pitch))) + 1;
  std::vector<Cell> queue;
  const auto visit_around = [&](int c, int r) {
    for (int row = std::max(r - reach, 0); row <= std::min(r + reach, rows - 1); ++row) {
      for (int column = std::max(c - reach, 0); column <= std::min(c + reach, columns - 1); ++column) {
        if (stands[index(column, row)] != 1) continue;
        stands[index(column, row)] = 2;
        queue.push_back({column, row});
      }
    }
  };
  const Cell start = terrain.cell_of(question.start_middle.x_m, question.start_middle.y_m);
  const Cell goal = terrain.cell_of(question.goal_middle.x_m, question.goal_middle.y_m);
  visit_around(start.column / pitch, start.row / pitch);
  for (std::size_t done = 0; done < queue.size(); ++done) {
    const Cell cell = queue[done];
    if (std::abs(cell.column - goal.column / pitch) <= reach &&
        std::abs(cell.row - goal.row / pitch) <= reach)
      return true;
    visit_around(cell.column, cell.row);
  }
  return false;
}

}  // namespace

Diagnosis judge_start(const Question& question, const Terrain& terrain, const StepCheck& check) {
  if (!is_on_map(question, terrain, question.feet)) {
    return {Reason::start_outside_map,
            fmt::format("the feet at {} are not on the map, which has {}: take a larger map, or begin on it",
                        at(question.start_middle), map_text(terrain))};
  }
  if (is_in_obstacle(question, terrain, question.feet) ||
      !check.has_room(question.feet[0], question.feet[1], 0.0)) {
    return {Reason::start_in_obstacle,
            fmt::format("the robot at {} is inside of an obstacle: begin elsewhere, or look at the map",
                        at(question.start_middle))};
  }
  return {};
}

Diagnosis judge_goal(const Question& question, const Terrain& terrain, const StepCheck& check) {
  const std::string where = at(question.goal_middle);
  if (!is_on_map(question, terrain, question.goal)) {
    return {Reason::goal_outside_map,
            fmt::format("the goal {} is not on the map, which has {}: take a larger map, or a goal on it",
                        where, map_text(terrain))};
  }
  if (is_in_obstacle(question, terrain, question.goal)) {
    return {Reason::goal_in_obstacle,
            fmt::format("the goal {} is inside of an obstacle: choose one beside it", where)};
  }
  std::array<std::optional<double>, 2> heights_m;
  for (std::size_t side = 0; side < 2; ++side) heights_m[side] = check.height_at(question.goal[side]);
  if (!heights_m[0] || !heights_m[1]) {
    for (const Pose& foot : question.goal) {
      Cell origin;
      const std::vector<CellSpan> spans = sole_cells(question, terrain, foot, origin);
      const Terrain::Ground ground = terrain.ground_under(origin, spans);
      if (ground.is_footing || ground.highest_m - ground.lowest_m > question.limits.sole_unevenness_m)
        continue;
      return {
          Reason::goal_too_high,
          fmt::format("the ground at the goal {} lies at {:.0f} mm, and no steps of at most {:.0f} mm up or "
                      "down lead there: choose a goal on the level of the start, or a robot that climbs",
                      where, 1000.0 * ground.highest_m, 1000.0 * question.limits.max_step_height_m)};
    }
    return {Reason::goal_without_footing,
            fmt::format(
                "at the goal {} the ground under the soles has an edge or differs by more than {:.0f} mm: "
                "choose one on level ground",
                where, 1000.0 * question.limits.sole_unevenness_m)};
  }
  if (!check.is_step_height(*heights_m[0], *heights_m[1])) {
    return {
        Reason::goal_without_footing,
        fmt::format(
            "at the goal {} the feet would stand {:.0f} mm apart in height, and {:.0f} mm is the most", where,
            1000.0 * std::abs(*heights_m[0] - *heights_m[1]), 1000.0 * question.limits.max_step_height_m)};
  }
  if (!check.has_room(question.goal[0], question.goal[1], question.limits.clearance_m)) {
    return {
        Reason::goal_without_room,
        fmt::format("at the goal {} the body has no room: it needs {:.0f} mm around it. Choose one further "
                    "from obstacles, or turned otherwise",
                    where, 1000.0 * question.limits.clearance_m)};
  }
  return {};
}

Diagnosis judge_way(const Question& question, const Terrain& terrain, int expansions) {
  const std::string way = fmt::format("from {} to {}", at(question.start_middle), at(question.goal_middle));
  const Eigen::Vector2d from_m(question.start_middle.x_m, question.start_middle.y_m);
  const double reach_m = question.lattice.reach_m();
  const auto body_reaches = [&](const Terrain& ground, const Limits& limits) {
    return std::isfinite(DistanceField(ground, limits, question.goal_middle, question.lattice.pitch())
                             .to_goal_from_around_m(from_m.x(), from_m.y()));
  };
  Limits climbing = question.limits;
  climbing.max_step_height_m = kAnyHeight_m;
  const auto climbs_to = [&] {
    const Terrain ground(question.map, climbing, from_m, reach_m);
    return body_reaches(ground, climbing) &&
           has_way_for_feet({question.map, climbing, question.lattice, question.feet, question.goal,
                             question.start_middle, question.goal_middle},
                            ground);
  };
  const Diagnosis too_high{Reason::too_high,
                           fmt::format("every way {} has a step of more than {:.0f} mm up or down", way,
                                       1000.0 * question.limits.max_step_height_m)};
  const Diagnosis too_narrow{Reason::too_narrow, fmt::format("every way {} is too narrow for the body", way)};
  if (!body_reaches(terrain, question.limits)) {
    GroundMap open = question.map;
    std::ranges::fill(open.underside_m, std::numeric_limits<float>::quiet_NaN());
    if (body_reaches(Terrain(open, question.limits, from_m, reach_m), question.limits)) {
      return {Reason::too_low,
              fmt::format("every way {} goes below something that hangs lower than the robot's "
                          "{:.0f} mm",
                          way, 1000.0 * question.limits.height_m)};
    }
    if (climbs_to()) return too_high;
    if (is_open(terrain, question.limits, question.start_middle, question.goal_middle)) return too_narrow;
    return {Reason::enclosed, fmt::format("there is no way {}: obstacles enclose one of them", way)};
  }
  if (!has_way_for_feet(question, terrain)) {
    if (climbs_to()) return too_high;
    return {Reason::no_footing,
            fmt::format("every way {} has a stretch without level ground that is too wide to "
                        "step over",
                        way)};
  }
  if (!has_way_for_body(question, terrain)) return too_narrow;
  if (expansions == 0) {
    return {Reason::no_footsteps,
            fmt::format("there is room {}, but no footsteps within the robot's limits: it may be "
                        "too narrow to turn or to step aside",
                        way)};
  }
  return {Reason::out_of_budget,
          fmt::format("no footsteps {} were found in {} expansions: allow more, or choose "
                      "a goal on the way",
                      way, expansions)};
}

}  // namespace gaitway::planning
