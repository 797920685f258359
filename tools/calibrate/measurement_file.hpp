// Standing measurements as a YAML file: for robots that are not simulated, and to look at.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/calibrate/calibration_settings.hpp"
#include "tools/calibrate/standing_measurement.hpp"

namespace gaitway::calibration {

struct MeasurementFile {
  std::optional<Weighing> weighing;
  std::vector<StandingMeasurement> poses;
};

// Throws input::InputError with file, line, field, value, rule and remedy.
[[nodiscard]] MeasurementFile read_measurements(const std::filesystem::path& file,
                                                const urdf::RobotModel& robot);

[[nodiscard]] std::string measurement_text(const MeasurementFile& measurements,
                                           const urdf::RobotModel& robot);

}  // namespace gaitway::calibration
