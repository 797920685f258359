// From standing measurements to what one robot's joint zeros, trunk and force cells are, and how sure that
// is.
#pragma once

#include <array>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tools/calibrate/calibration_settings.hpp"
#include "tools/calibrate/standing_measurement.hpp"

namespace gaitway::calibration {

// Why nothing can be told from the measurements: names pose, value, rule and remedy.
class CalibrationError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Estimate {
  double value = 0.0;
  double deviation = 0.0;        // standard deviation, after the measurements
  double prior_deviation = 0.0;  // before

  // Share of the prior's variance that the measurements took away: 0 if they say nothing of this value.
  [[nodiscard]] double learned() const noexcept {
    const double left = deviation / prior_deviation;
    return 1.0 - left * left;
  }
};

// Below this the poses cannot tell a value: what is reported is mostly the guess that there is no deviation.
inline constexpr double kToldShare = 0.5;
// Below this they say nothing of it. In between, what several values add up to may well be told: they hold
// together, all of them or none.
inline constexpr double kHeardShare = 0.05;

// What single deviations add up to in the standing posture: what a walk depends on.
struct PostureError {
  std::string name;
  std::string unit;
  Estimate estimate;  // in SI units
};

struct Calibration {
  RobotDeviations deviations;
  std::vector<Estimate> zero_rad;                         // of each joint
  std::array<Estimate, 3> trunk_com_m;                    // x, y, z
  std::array<std::array<Estimate, kCells>, 2> cell_gain;  // [Side]
  // Roll and pitch that each sensor of the IMU says while its link stands upright: [ImuSensor].
  std::array<std::array<Estimate, 2>, kImuSensors.size()> imu_tilt_rad;
  Estimate mass_kg;  // of the whole robot
  std::vector<PostureError> posture;
  // RMS of what the measurements leave unexplained, in the deviations that they should have: about 1.
  double misfit = 0.0;
  // Feet, in all poses, that stood near their edges: of these the tilt was not known.
  int feet_on_edge = 0;
};

// Largest misfit of measurements that fit the robot and the settings.
inline constexpr double kLargestMisfit = 2.0;

// Maximum a posteriori by Ceres (Levenberg-Marquardt), with deviations from its covariance there. The robot
// is the described one, without calibration. Throws CalibrationError.
[[nodiscard]] Calibration calibrate(const urdf::RobotModel& robot,
                                    std::span<const StandingMeasurement> measurements,
                                    const CalibrationSettings& settings);

// The posture errors of a robot with these deviations.
[[nodiscard]] std::vector<double> posture_errors(const urdf::RobotModel& robot,
                                                 const RobotDeviations& deviations);

inline constexpr std::size_t kPostureErrors = 12;

struct NamedQuantity {
  std::string_view name, unit;
};

[[nodiscard]] const std::array<NamedQuantity, kPostureErrors>& posture_quantities();

}  // namespace gaitway::calibration
