// A calibration of the simulated robot, whose deviations are known: it takes one pose after the other, its
// sensors are read while it stands, and what is found stands against what is true.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/localcontroller/servo.hpp"
#include "gaitway/motion/motion_plan.hpp"
#include "gaitway/simulator/plant.hpp"
#include "tools/calibrate/calibration_estimator.hpp"
#include "tools/calibrate/standing_measurement.hpp"

namespace gaitway::calibration {

class StandingReading;

class PerformanceError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class PosePerformer {
 public:
  // Keeps references to both. The plan's poses are the keys that it holds for `measured_s` at least; the end
  // of that is measured.
  PosePerformer(const urdf::RobotModel& robot, simulator::Plant& plant, double measured_s);

  // Plays the plan with each joint's zero taken to be as given, from the posture in which the plan starts and
  // ends. `progress` is told each pose's name. Throws PerformanceError when the robot falls.
  [[nodiscard]] std::vector<StandingMeasurement> perform(
      const motion::MotionPlan& plan, std::span<const double> zero_rad,
      const std::function<void(const std::string&)>& progress = {});

 private:
  // The servos' references go straight from one row to the other in a point's time.
  void play_point(std::span<const double> from, std::span<const double> to, StandingReading* reading);
  void take(const simulator::PlantSensors& sensors, StandingReading& reading) const;
  // Turns the ankles against each other until both soles press alike: legs with wrong zeros else stand on the
  // edges of their soles. The body does not move by it.
  void relax_ankles();
  void take_zeros(std::span<const double> posture, std::span<const double> zero_rad);

  const urdf::RobotModel& robot_;
  simulator::Plant& plant_;
  double measured_s_;
  struct Ankle {
    int pitch = 0, roll = 0;                         // indices of the joints
    double pitch_about_y = 0.0, roll_about_x = 0.0;  // of their axes at the home posture
  };
  std::array<Ankle, 2> ankles_;  // [Side]
  std::vector<localcontroller::Servo> servos_;
  std::vector<double> zero_rad_;              // in use
  std::vector<double> relaxed_rad_;           // of the ankles, added to what the plan says
  std::array<Eigen::Vector2d, 2> moment_Nm_;  // [Side], about the sole's middle, summed over a point
  std::array<double, 2> force_N_{};           // the same
  int placement_ = 0;                         // of the feet, all performances through
};

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
