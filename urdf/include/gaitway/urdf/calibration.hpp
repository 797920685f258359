// One robot's calibration as its file has it: for who shows it. What comes of it is in the RobotModel
// already.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

// Values with their standard deviations, where the file tells these.
template <std::size_t count>
struct Calibrated {
  std::array<double, count> value{};
  std::optional<std::array<double, count>> deviation = {};
};

// Roll and pitch that each sensor of an IMU tells along the link's axes while the link stands upright.
struct ImuTilts {
  std::optional<Calibrated<2>> gyro_rad, accelerometer_rad, inclinometer_rad;
};

struct Calibration {
  static constexpr std::size_t kCells = 4;

  std::string made;  // "2026-11-25" or "2026-11-25T03:21:29Z" (UTC); empty: the file does not say when
  std::vector<std::optional<Calibrated<1>>> zero_rad;  // of each joint; nothing: as described
  std::optional<Calibrated<3>> trunk_com_offset_m;
  std::optional<std::array<Calibrated<kCells>, 2>>
      cell_gain;  // [Side], front left, front right, rear left, rear right
  ImuTilts imu_tilt;
};

// <directory>/calibration.yaml of the robot's folder; nothing: there is none. Throws RobotError, which names
// file, line, value and rule.
[[nodiscard]] std::optional<Calibration> read_calibration(const RobotModel& model);

}  // namespace gaitway::urdf
