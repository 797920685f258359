// From gravity in the link into the IMU's own axes, through the sensor's errors, and back by the description.
#include "tools/calibrate/imu_errors.hpp"

#include <Eigen/Geometry>

#include "gaitway/geometry/tilt.hpp"

namespace gaitway::calibration {

ImuErrors imu_errors(const ImuDeviations& deviations, const Eigen::Vector<double, kImuUnknowns>& unknowns) {
  ImuErrors errors;
  errors.mounting_rad = deviations.mounting_rad * unknowns.head<3>();
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      const double deviation =
          row == column ? deviations.accelerometer_scale : deviations.accelerometer_axis_rad;
      errors.accelerometer_sensitivity(row, column) += deviation * unknowns[3 + 3 * row + column];
    }
  }
  errors.accelerometer_zero_m_per_s2 = deviations.accelerometer_zero_m_per_s2 * unknowns.segment<3>(12);
  errors.inclinometer_zero_rad = deviations.inclinometer_zero_rad * unknowns.segment<2>(15);
  errors.inclinometer_cross_axis = deviations.inclinometer_cross_axis * unknowns.segment<2>(17);
  return errors;
}

Eigen::Vector2d tilt_said(ImuSensor sensor, const urdf::Imu& imu, const ImuErrors& errors,
                          const Eigen::Vector3d& up) {
  const double turned_rad = errors.mounting_rad.norm();
  Eigen::Matrix3d own_axes = imu.pose.linear();
  if (turned_rad > 0.0) {
    own_axes = own_axes * Eigen::AngleAxisd(turned_rad, errors.mounting_rad / turned_rad).toRotationMatrix();
  }
  Eigen::Vector3d felt = own_axes.transpose() * up;
  if (sensor == ImuSensor::accelerometer) {
    felt = errors.accelerometer_sensitivity * (facts::kGravity_m_per_s2 * felt) +
           errors.accelerometer_zero_m_per_s2;
  } else if (sensor == ImuSensor::inclinometer) {
    const Eigen::Vector2d hangs_rad = geometry::tilt_at_rest(felt);
    felt = geometry::up_at_tilt(hangs_rad + errors.inclinometer_cross_axis.cwiseProduct(hangs_rad.reverse()) +
                                errors.inclinometer_zero_rad);
  }
  return geometry::tilt_at_rest(imu.pose.linear() * felt);
}

}  // namespace gaitway::calibration
