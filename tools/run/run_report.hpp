// What a run leaves behind when it has ended, from one set of figures: summary.json and the table for people,
// report.html (one page that carries everything in itself).
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "tools/run/run_metrics.hpp"
#include "tools/run/run_recorder.hpp"

namespace gaitway::tools {

struct RunTiming {
  double wall_s = 0.0;               // of the whole chain with its logs, without pictures and report
  double physics_only_wall_s = 0.0;  // of the bare replay of the same torques
};

[[nodiscard]] RunOutcome outcome_of(const simulator::Cosimulation& run, const RunRecorder& recorder);

nlohmann::ordered_json summary(const simulator::Cosimulation& run, const RunRecorder& recorder,
                               const RunTiming& timing, std::uint64_t seed, double mismatch);

// Lines for a terminal.
std::string summary_table(const nlohmann::ordered_json& summary);

struct ReportInput {
  const urdf::RobotModel& robot;
  std::vector<world::Solid> solids;  // of the world, where they lie at the end
  const RunRecorder& recorder;
  const core::MainControllerStatistics& main_controller;
  const nlohmann::ordered_json& summary;
  std::filesystem::path film_strip;  // embedded when it exists
};

// Throws std::runtime_error naming the file when it cannot be written.
void write_report(const std::filesystem::path& file, const ReportInput& input);

}  // namespace gaitway::tools
