// Measures the rows of the gait table, on all cores of this computer or elsewhere.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/measure/gait_table.hpp"
#include "tools/measure/gait_trial.hpp"
#include "tools/measure/trial_store.hpp"

namespace gaitway::tools {

class TrialsElsewhere;

// What one seed did at one level.
struct SeedResult {
  std::uint64_t seed = 0;
  bool passed = true;
  double figure = 0.0;  // of rows with one: the worst of the trials
  // In a row without a figure they end with the first that failed.
  std::vector<Trial> trials;
  std::vector<TrialOutcome> outcomes;
};

struct LevelResult {
  double level = 0.0;
  bool holds = false;  // with 19 of 20 seeds
  int passed = 0;
  std::vector<SeedResult>
      seeds;  // that count, in the seeds' order: a level that cannot hold any more ends early
};

struct RowResult {
  GaitRow row;
  int seeds = 0;
  int floor_passed = 0;  // seeds that pass the floor; it holds if they are as many as must
  std::vector<LevelResult>
      levels;  // that were tried, ascending; the floor is one. One alone in a row without levels
  // Rows with levels: the highest that holds; none: not even the lowest. With a figure: the one that 19 of 20
  // seeds keep, infinite if they do not. Else: the share of the seeds that pass.
  std::optional<double> limit;
  bool open_ended = false;  // the highest level holds: the limit may lie beyond

  [[nodiscard]] bool floor_holds() const noexcept {
    constexpr double kRounding = 1e-9;
    return floor_passed >= row.floor_share() * seeds - kRounding;
  }
};

struct GaitMeasurement {
  std::vector<RowResult> rows;
  std::uint64_t trials_run = 0;
  std::uint64_t trials_known = 0;  // to this store, or elsewhere
};

struct GaitProgress {
  std::string row;
  std::uint64_t trials_done = 0;
  std::uint64_t trials_planned = 0;   // grows as levels hold
  std::optional<double> remaining_s;  // of those that are planned; none: not known yet
  int workers = 0;                    // that play trials now
};

struct GaitMeasurementOptions {
  int seeds = 20;
  std::uint64_t first_seed = 1;
  int jobs = 1;                                       // processes side by side
  std::function<void(const GaitProgress&)> progress;  // empty: none
  // All rows but those that run alone are played there; none: here.
  TrialsElsewhere* elsewhere = nullptr;
};

// The result depends on the rows, the robot and the seeds alone, not on the number of jobs or the place (but
// for processor times). Trials here run in copies of the process: call it where there is a single thread.
// Throws std::runtime_error with what a trial threw, or with how its process came to its end; the others end,
// too. Throws what TrialsElsewhere throws.
GaitMeasurement measure_gait(const TrialRobot& robot, const std::vector<GaitRow>& rows, TrialStore& store,
                             const GaitMeasurementOptions& options);

// The measured gait table as JSON, as Markdown and as a page with plots.
//
// What was measured, for the results' heads.
struct GaitReportHead {
  std::string robot;
  std::string configuration;
  int seeds = 0;
  std::uint64_t first_seed = 1;
  bool quick = false;
};

nlohmann::ordered_json gait_json(const GaitReportHead& head, const GaitMeasurement& measurement);
std::string gait_markdown(const GaitReportHead& head, const GaitMeasurement& measurement);
std::string gait_page(const GaitReportHead& head, const GaitMeasurement& measurement);

// A figure of the row in its unit: "0.35 m/s".
std::string shown(const GaitRow& row, double value);
std::string shown_limit(const RowResult& result);
// "20 of 20", with a word where it does not hold.
std::string shown_floor(const RowResult& result);
std::string shown_head(const GaitReportHead& head);

// A map of pushes: sectors are directions, rings are phases of the gait cycle, the colour says which share
// survived.
// Of one level of a row of pushes, as inline SVG.
std::string push_map(const RowResult& row, const LevelResult& level);

}  // namespace gaitway::tools
