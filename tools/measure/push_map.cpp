// Draws the map.
#include "tools/measure/gait_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace gaitway::tools {
namespace {

constexpr double kRadius_px = 100.0, kHole_px = 20.0, kSize_px = 260.0;
constexpr double kMillisecond = 1e3;

struct Cell {
  int survived = 0, tried = 0;
};

// Red over yellow to green; grey where nothing was tried.
std::string colour_of(const Cell& cell) {
  if (cell.tried == 0) {
    return "#d8d8d8";
  }
  const double share = static_cast<double>(cell.survived) / cell.tried;
  return fmt::format("hsl({:.0f} 55% 47%)", 120.0 * share);
}

std::string sector(double inner_px, double outer_px, double from_rad, double to_rad, const Cell& cell,
                   const std::string& tooltip) {
  // Ahead is up, left is left.
  const auto at = [](double radius, double angle) {
    return std::pair(kSize_px / 2 - radius * std::sin(angle), kSize_px / 2 - radius * std::cos(angle));
  };
  const auto [x0, y0] = at(inner_px, from_rad);
  const auto [x1, y1] = at(outer_px, from_rad);
  const auto [x2, y2] = at(outer_px, to_rad);
  const auto [x3, y3] = at(inner_px, to_rad);
  return fmt::format(
      "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}A{:.1f} {:.1f} 0 0 0 {:.1f} {:.1f}L{:.1f} {:.1f}A{:.1f} {:.1f} "
      "0 0 1 {:.1f} "
      "{:.1f}Z\" fill=\"{}\" stroke=\"#fff\" stroke-width=\"0.5\"><title>{}</title></path>\n",
      x0, y0, x1, y1, outer_px, outer_px, x2, y2, x3, y3, inner_px, inner_px, x0, y0, colour_of(cell),
      tooltip);
}

// The directions and instants of the row's pushes, and what became of them at this level.
class Survey {
 public:
  Survey(const RowResult& row, const LevelResult& level) {
    std::set<std::int64_t> instants;
    std::set<double> directions;
    // A standing push comes at one instant, which differs from seed to seed: one ring.
    const bool rings = !row.row.trials(0, level.level).front().commands.empty();
    const auto instant = [rings](const Trial& trial) {
      return rings ? std::llround(trial.push->at_s * kMillisecond) : 0;
    };
    for (const Trial& trial : row.row.trials(0, level.level)) {
      instants.insert(instant(trial));
      directions.insert(trial.push->direction_rad);
    }
    instants_.assign(instants.begin(), instants.end());
    directions_.assign(directions.begin(), directions.end());
    cells_.resize(instants_.size() * directions_.size());
    for (const SeedResult& seed : level.seeds) {
      for (std::size_t i = 0; i < seed.trials.size(); ++i) {
        const auto ring = std::lower_bound(instants_.begin(), instants_.end(), instant(seed.trials[i]));
        const auto spoke =
            std::lower_bound(directions_.begin(), directions_.end(), seed.trials[i].push->direction_rad);
        Cell& cell = cells_.at(static_cast<std::size_t>(ring - instants_.begin()) * directions_.size() +
                               static_cast<std::size_t>(spoke - directions_.begin()));
        ++cell.tried;
        cell.survived += seed.outcomes[i].fell ? 0 : 1;
      }
    }
  }
  [[nodiscard]] const std::vector<std::int64_t>& instants_ms() const { return instants_; }
  [[nodiscard]] const std::vector<double>& directions_rad() const { return directions_; }
  [[nodiscard]] const Cell& cell(std::size_t ring, std::size_t spoke) const {
    return cells_[ring * directions_.size() + spoke];
  }

 private:
  std::vector<std::int64_t> instants_;
  std::vector<double> directions_;
  std::vector<Cell> cells_;
};

}  // namespace

std::string push_map(const RowResult& row, const LevelResult& level) {
  const Survey survey(row, level);
  const std::size_t rings = survey.instants_ms().size(), spokes = survey.directions_rad().size();
  std::string svg =
      fmt::format("<svg viewBox=\"0 0 {0} {1}\" width=\"{0}\" role=\"img\">\n", kSize_px, kSize_px);
  const double ring_px = (kRadius_px - kHole_px) / static_cast<double>(rings);
  const double half_rad = std::numbers::pi / static_cast<double>(spokes);
  for (std::size_t ring = 0; ring < rings; ++ring) {
    for (std::size_t spoke = 0; spoke < spokes; ++spoke) {
      const Cell& cell = survey.cell(ring, spoke);
      const double direction = survey.directions_rad()[spoke];
      const double inner_px = kHole_px + ring_px * static_cast<double>(ring);
      svg += sector(
          inner_px, inner_px + ring_px, direction - half_rad, direction + half_rad, cell,
          fmt::format("{:.0f} deg, {} ms into the cycle: {} of {} survived",
                      direction * 180.0 / std::numbers::pi,
                      survey.instants_ms()[ring] - survey.instants_ms().front(), cell.survived, cell.tried));
    }
  }
  const std::array<std::pair<const char*, std::pair<double, double>>, 4> names{
      {{"ahead", {kSize_px / 2, 20.0}},
       {"back", {kSize_px / 2, kSize_px - 10.0}},
       {"left", {14.0, kSize_px / 2}},
       {"right", {kSize_px - 14.0, kSize_px / 2}}}};
  for (const auto& [name, place] : names) {
    svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">{}</text>\n", place.first,
                       place.second, name);
  }
  svg += fmt::format("<text x=\"{0:.0f}\" y=\"{1:.0f}\" text-anchor=\"middle\">{2}</text></svg>\n",
                     kSize_px / 2, kSize_px / 2 + 4, level.level);
  return svg;
}

}  // namespace gaitway::tools
