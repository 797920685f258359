// The rows of the gait table: what is tried in each, from which floor up, and what passes.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tools/measure/gait_trial.hpp"

namespace gaitway::tools {

struct GaitRow {
  std::string name;     // for --rows
  std::string measure;  // for people
  std::string unit;
  double floor = 0.0;
  double aim = 0.0;
  double shown_scale = 1.0;  // of the figures in tables: 1000 for metres in mm

  // A row is of one of three kinds. With levels: ascending, each harder, the floor among them; the limit is
  // searched. A seed passes a level when each of its trials does. With a figure: each seed yields one, the
  // smaller the better, the worst of its trials; it passes when that is at most the floor. With neither: a
  // seed passes or does not; floor and aim are shares of the seeds.
  std::vector<double> levels;
  std::function<std::vector<Trial>(std::uint64_t seed, double level)> trials;
  std::function<bool(const TrialOutcome&, const Trial&, double level)> passes;  // without a figure
  std::function<double(const TrialOutcome&, const Trial&)> figure;              // infinite: it fell

  int most_seeds = 0;       // 0: as many as asked for
  bool runs_alone = false;  // no other trial runs meanwhile: processor time is measured
  enum class Picture : std::uint8_t { none, speeds, headings, pushes } picture = Picture::none;

  [[nodiscard]] bool has_levels() const noexcept { return !levels.empty(); }
  [[nodiscard]] bool has_figure() const noexcept { return figure != nullptr; }
  // Of the seeds, that must pass the floor.
  [[nodiscard]] double floor_share() const noexcept { return has_levels() || has_figure() ? 1.0 : floor; }
};

struct GaitTableOptions {
  double step_time_s = 0.4;
  bool quick = false;  // shorter walks, fewer levels, directions and phases
};

// All rows in the table's order.
std::vector<GaitRow> gait_table(const GaitTableOptions& options);

// Mean speed over the ground along what was commanded first, by the robot's heading; of a turn in rad/s.
[[nodiscard]] double true_speed(const TrialOutcome& outcome, const Trial& trial);

// Those of the given names, all if there are none, without those of `except`; in the table's order. Throws
// std::invalid_argument that names an unknown one and the nearest known, or when none is left.
std::vector<GaitRow> chosen_rows(std::vector<GaitRow> table, std::span<const std::string> names,
                                 std::span<const std::string> except = {});

// The step period that the configuration's `step_time` asks for; the trajectory plug-in's own default if it
// does not.
double step_time_of(const core::Configuration& plugins);

}  // namespace gaitway::tools
