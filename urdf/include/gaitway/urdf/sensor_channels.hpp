// Names of the sensor channels in a network file, such as left_cell_front_right or angular_velocity_z.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

struct NamedChannel {
  std::string name;
  SensorChannel channel;  // scale 1
};

// Every channel that a robot has: 4 force cells and 3 accelerations a foot, gyro, trunk accelerometer,
// inclinometer.
[[nodiscard]] const std::vector<NamedChannel>& all_channels();

[[nodiscard]] std::string channel_name(const SensorChannel& channel);  // "none" for none

}  // namespace gaitway::urdf
