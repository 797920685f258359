// A calibration for people, and as the file that the robot is loaded with.
#pragma once

#include <ctime>
#include <string>
#include <vector>

#include "tools/calibrate/calibration_estimator.hpp"
#include "tools/calibrate/simulated_calibration.hpp"

namespace gaitway::calibration {

// One value in the unit that people read.
struct ReportRow {
  std::string name;
  std::string unit;
  Estimate estimate;
  double truth = 0.0;  // NaN where nobody knows
};

struct ReportSection {
  std::string title;
  std::vector<ReportRow> rows;
};

// truth: nullptr where nobody knows.
[[nodiscard]] std::vector<ReportSection> report_sections(const urdf::RobotModel& robot,
                                                         const Calibration& calibration,
                                                         const RobotDeviations* truth);

[[nodiscard]] std::string report_text(const urdf::RobotModel& robot, const Calibration& calibration,
                                      const RobotDeviations* truth);

// calibration.yaml, to be put beside robot.yaml. What the poses cannot tell is left out. `made_s`: when it
// was made, in seconds since 1970.
[[nodiscard]] std::string calibration_text(const urdf::RobotModel& robot, const Calibration& calibration,
                                           std::time_t made_s);

// Many calibrations of robots whose deviations are known: RMS of what is wrong before and after, and whether
// the claimed deviations are honest.
class CalibrationStatistics {
 public:
  struct Row {
    std::string name, unit;
    double before = 0.0, after = 0.0, claimed = 0.0;  // RMS
    double error_in_deviations = 0.0;                 // RMS; 1 is honest
  };
  struct Section {
    std::string title;
    std::vector<Row> rows;
    Row all;  // of the section, in the rows' unit if they have the same
  };

  void add(const urdf::RobotModel& robot, const SimulatedCalibration& simulated);
  [[nodiscard]] std::vector<Section> sections() const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] int robots() const noexcept { return robots_; }

 private:
  std::vector<Section> sums_;  // of squares
  int robots_ = 0;
};

}  // namespace gaitway::calibration
