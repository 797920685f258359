// What an IMU tells otherwise than its description says, and what its sensors say because of that while the
// robot stands still.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::calibration {

struct ImuErrors {
  // How all of it is mounted: a rotation vector, from the described axes to its own.
  Eigen::Vector3d mounting_rad = Eigen::Vector3d::Zero();
  // In its own axes: what the accelerometer says is this times the specific force, and its zero.
  Eigen::Matrix3d accelerometer_sensitivity = Eigen::Matrix3d::Identity();
  Eigen::Vector3d accelerometer_zero_m_per_s2 = Eigen::Vector3d::Zero();
  Eigen::Vector2d inclinometer_zero_rad = Eigen::Vector2d::Zero();
  Eigen::Vector2d inclinometer_cross_axis = Eigen::Vector2d::Zero();  // share of the other angle
};

// Standard deviations of each axis, of small MEMS parts that somebody screwed into a trunk.
struct ImuDeviations {
  double mounting_rad = 0.6 * facts::kRadPerDegree;
  double accelerometer_scale = 0.01;
  double accelerometer_axis_rad = 0.005;  // from each other axis
  double accelerometer_zero_m_per_s2 = 0.05;
  double inclinometer_zero_rad = 0.2 * facts::kRadPerDegree;
  double inclinometer_cross_axis = 0.01;
};

inline constexpr Eigen::Index kImuUnknowns = 3 + 9 + 3 + 2 + 2;

// Each unknown in its standard deviation.
[[nodiscard]] ImuErrors imu_errors(const ImuDeviations& deviations,
                                   const Eigen::Vector<double, kImuUnknowns>& unknowns);

enum class ImuSensor : std::uint8_t { gyro = 0, accelerometer = 1, inclinometer = 2 };
inline constexpr std::array kImuSensors{ImuSensor::gyro, ImuSensor::accelerometer, ImuSensor::inclinometer};

// Roll and pitch that the sensor of a robot at rest says, as its description understands it; the gyro as if
// it felt gravity along its axes. `up`: against gravity, in the IMU's link.
[[nodiscard]] Eigen::Vector2d tilt_said(ImuSensor sensor, const urdf::Imu& imu, const ImuErrors& errors,
                                        const Eigen::Vector3d& up);

}  // namespace gaitway::calibration
