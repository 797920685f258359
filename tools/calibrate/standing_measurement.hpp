// What the sensors said while the robot stood still in one pose, and the ways to such a measurement:
// averaging readings, a log of the bus, a YAML file.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/can/candump_log.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "tools/calibrate/calibration_settings.hpp"

namespace gaitway::calibration {

// Means over the time of standing, and standard deviations of these means.
struct StandingMeasurement {
  std::string pose;
  std::array<bool, 2> stands{true, true};  // [Side]
  // Poses with the same number have both feet in the same places, which nobody knows.
  int placement = 0;
  std::vector<double> joint_rad;                              // encoders, without any calibration
  Eigen::Vector3d specific_force_m_per_s2 = {0.0, 0.0, 0.0};  // trunk accelerometer, along its link's axes
  Eigen::Vector3d specific_force_deviation_m_per_s2 = {0.0, 0.0, 0.0};
  std::optional<Eigen::Vector2d> inclination_rad;  // trunk inclinometer: roll, pitch
  Eigen::Vector2d inclination_deviation_rad = {0.0, 0.0};
  std::array<std::array<double, kCells>, 2> force_N{};  // [Side]
  std::array<std::array<double, kCells>, 2> force_deviation_N{};
};

// Mean of many samples, and its deviation from the means of some blocks of them: neighbouring samples may be
// alike.
class BlockMean {
 public:
  explicit BlockMean(int samples);

  void add(double sample);
  [[nodiscard]] double mean() const;
  [[nodiscard]] double deviation() const;

 private:
  static constexpr int kBlocks = 10;
  int block_size_, count_ = 0;
  std::array<double, kBlocks> sums_{};
  std::array<int, kBlocks> sizes_{};
};

// Averages what all sensors say while the robot stands in one pose.
class StandingReading {
 public:
  // `samples`: how many will be taken; at least 10.
  StandingReading(std::size_t joints, int samples);

  // Encoders without calibration; specific force and inclination (roll, pitch) of the trunk; [Side][cell].
  void take(std::span<const double> joint_rad, const Eigen::Vector3d& specific_force_m_per_s2,
            const Eigen::Vector2d& inclination_rad, const std::array<std::array<double, kCells>, 2>& force_N);
  // Name, feet and placement are left as they are in a new one.
  [[nodiscard]] StandingMeasurement result() const;

 private:
  std::size_t joints_;
  std::vector<BlockMean> channels_;
};

// Poses in which a robot stood still, found in a log of its bus: whatever it was that had it take them.
class StandingLogError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A log in order of time, of a network of the robot's profile. Each time in which all joints were still for
// `measured_s` at least, with a foot on the ground, is a pose; the end of it is measured. Both feet are in
// the same places as long as neither was off the ground.
//
// `robot`: without calibration. `zero_in_use_rad`: of each joint, what its local controller took off the
// encoder's angle when the log was taken. Throws StandingLogError when there are too few poses.
[[nodiscard]] std::vector<StandingMeasurement> standing_poses(const urdf::RobotModel& robot,
                                                              std::span<const double> zero_in_use_rad,
                                                              std::span<const can::LoggedFrame> log,
                                                              double measured_s);

// Standing measurements as a YAML file: for robots that are not simulated, and to look at.
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
