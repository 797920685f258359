// report.html: one page that carries everything in itself, for people who would rather look than read.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "gaitway/urdf/robot_model.hpp"
#include "tools/run/run_recorder.hpp"
#include "tools/run/run_sample.hpp"

namespace gaitway::tools {

struct ReportInput {
  const urdf::RobotModel& robot;
  const RunRecorder& recorder;
  const core::MainControllerStatistics& main_controller;
  const nlohmann::ordered_json& summary;
  std::filesystem::path film_strip;  // embedded when it exists
};

// Throws std::runtime_error naming the file when it cannot be written.
void write_report(const std::filesystem::path& file, const ReportInput& input);

// states.csv: a header line with units, then one line a sample; opens in PlotJuggler.
void write_states_csv(const std::filesystem::path& file, const urdf::RobotModel& robot,
                      std::span<const RunSample> samples);

}  // namespace gaitway::tools
