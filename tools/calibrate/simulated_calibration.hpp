// A calibration of the simulated robot, whose deviations are known: what it finds against what is true.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/motion/motion_plan.hpp"
#include "tools/calibrate/calibration_estimator.hpp"

namespace gaitway::calibration {

struct SimulatedCalibrationOptions {
  std::uint64_t seed = 1;
  double mismatch = 1.0;  // scales deviations of body and force cells
  double play_rad = 0.0;  // whole width, in each joint
  // How often the poses are taken at most, each time with the joint zeros found before: legs that do not work
  // against each other stand flat. From the second time on it is enough when no foot stands near its edge.
  int rounds = 4;
  double measured_s = 1.0;                             // in each pose
  std::optional<double> weighing_deviation_kg = 0.01;  // none: the robot is not weighed
  std::function<void(int round, const std::string& pose)> progress = {};
};

struct SimulatedCalibration {
  std::vector<StandingMeasurement> measurements;  // of the last round
  CalibrationSettings settings;                   // that they were understood with
  Calibration calibration;
  RobotDeviations truth;
};

// Deterministic for one seed. The robot is the described one. Throws CalibrationError, PerformanceError.
[[nodiscard]] SimulatedCalibration calibrate_simulated(const urdf::RobotModel& robot,
                                                       const motion::MotionPlan& poses,
                                                       const SimulatedCalibrationOptions& options);

}  // namespace gaitway::calibration
