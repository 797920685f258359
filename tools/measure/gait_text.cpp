// The gait table in words, Markdown and JSON.
#include "tools/measure/gait_measurement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace gaitway::tools {

std::string shown(const GaitRow& row, double value) {
  if (!std::isfinite(value)) {
    return "fell";
  }
  // Levels are round numbers; measured figures have two digits behind the point, times in us none.
  const double scaled = value * row.shown_scale;
  const std::string number = row.has_levels()  ? fmt::format("{:.4g}", scaled)
                             : scaled >= 100.0 ? fmt::format("{:.0f}", scaled)
                                               : fmt::format("{:.3g}", scaled);
  return fmt::format("{} {}", number, row.unit);
}

std::string shown_limit(const RowResult& result) {
  const GaitRow& row = result.row;
  if (!row.has_levels()) {
    return shown(row, *result.limit);
  }
  if (!result.limit) {
    return "below " + shown(row, result.levels.front().level);
  }
  return shown(row, *result.limit) + (result.open_ended ? " or more" : "");
}

std::string shown_floor(const RowResult& result) {
  return fmt::format("{} of {}{}", result.floor_passed, result.seeds, result.floor_holds() ? "" : " (fails)");
}

std::string shown_head(const GaitReportHead& head) {
  return fmt::format("{} with {}, seeds {} to {}{}.", head.robot, head.configuration, head.first_seed,
                     head.first_seed + static_cast<std::uint64_t>(head.seeds) - 1,
                     head.quick ? ", quick: shorter walks and coarser levels than the full measurement" : "");
}

std::string gait_markdown(const GaitReportHead& head, const GaitMeasurement& measurement) {
  std::string text =
      "# Gait\n\n" + shown_head(head) +
      "\n\n| measure | floor | seeds at the floor | aim | limit (19 of 20 seeds) |\n|---|---|---|---|---|\n";
  for (const RowResult& result : measurement.rows) {
    text +=
        fmt::format("| {} | {} | {} | {} | {} |\n", result.row.measure, shown(result.row, result.row.floor),
                    shown_floor(result), shown(result.row, result.row.aim), shown_limit(result));
  }
  return text;
}

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json level_of(const RowResult& result, const LevelResult& level) {
  Json json = {
      {"level", level.level}, {"holds", level.holds}, {"passed", level.passed}, {"seeds", Json::array()}};
  for (const SeedResult& seed : level.seeds) {
    Json one = {{"seed", seed.seed}, {"passed", seed.passed}};
    if (result.row.has_figure()) {
      one["figure"] = number(seed.figure);
    }
    one["trials"] = seed.trials.size();
    if (!result.row.has_figure() && !seed.passed) {
      one["failed"] = describe(seed.trials.back());
      one["outcome"] = to_json(seed.outcomes.back());
      one["outcome"].erase("heading_deg");
    }
    json["seeds"].push_back(std::move(one));
  }
  return json;
}

}  // namespace

Json gait_json(const GaitReportHead& head, const GaitMeasurement& measurement) {
  Json rows = Json::array();
  bool floors_hold = true;
  for (const RowResult& result : measurement.rows) {
    floors_hold = floors_hold && result.floor_holds();
    Json levels = Json::array();
    for (const LevelResult& level : result.levels) {
      levels.push_back(level_of(result, level));
    }
    rows.push_back({{"name", result.row.name},
                    {"measure", result.row.measure},
                    {"unit", result.row.unit},
                    {"unit_per_si", result.row.shown_scale},
                    {"floor", result.row.floor},
                    {"aim", result.row.aim},
                    {"floor_passed", result.floor_passed},
                    {"seeds", result.seeds},
                    {"floor_holds", result.floor_holds()},
                    {"limit", result.limit ? number(*result.limit) : Json(nullptr)},
                    {"limit_open_ended", result.open_ended},
                    {"levels", std::move(levels)}});
  }
  return {{"robot", head.robot},    {"configuration", head.configuration},
          {"seeds", head.seeds},    {"first_seed", head.first_seed},
          {"quick", head.quick},    {"floors_hold", floors_hold},
          {"rows", std::move(rows)}};
}

}  // namespace gaitway::tools
