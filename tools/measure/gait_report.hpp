// The measured gait table as JSON, as Markdown and as a page with plots.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tools/measure/gait_measurement.hpp"

namespace gaitway::tools {

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

}  // namespace gaitway::tools
