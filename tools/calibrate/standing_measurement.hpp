// What the sensors said while the robot stood still in one pose.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "tools/calibrate/robot_deviations.hpp"

namespace gaitway::calibration {

// Means over the time of standing, and standard deviations of these means.
struct StandingMeasurement {
  std::string pose;
  std::array<bool, 2> stands{true, true};  // [Side]
  // Poses with the same number have both feet in the same places, which nobody knows.
  int placement = 0;
  std::vector<double> joint_rad;                              // encoders, without any calibration
  Eigen::Vector3d specific_force_m_per_s2 = {0.0, 0.0, 0.0};  // trunk accelerometer, sensor frame
  Eigen::Vector3d specific_force_deviation_m_per_s2 = {0.0, 0.0, 0.0};
  std::optional<Eigen::Vector2d> inclination_rad;  // trunk inclinometer: roll, pitch
  Eigen::Vector2d inclination_deviation_rad = {0.0, 0.0};
  std::array<std::array<double, kCells>, 2> force_N{};  // [Side]
  std::array<std::array<double, kCells>, 2> force_deviation_N{};
};

}  // namespace gaitway::calibration
