// robot.yaml as read and checked on its own; names of joints and links are not yet resolved.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

struct NetworkJoint {
  Joint joint;  // name and what the network file says; the rest is still empty
  std::array<SensorChannel, 2> channels;
  int line = 0;
};

struct NetworkFile {
  std::filesystem::path file;
  std::vector<NetworkJoint> joints;
  std::array<std::vector<std::string>, 2> leg_joints;  // [Side]
  std::array<int, 2> leg_line{};
  std::array<Foot, 2> feet;  // [Side]; link not resolved
  std::array<std::string, 2> foot_link;
  std::array<int, 2> foot_line{};
  Imu imu;  // link not resolved
  std::string imu_link;
  int imu_line = 0;
  SensorNoise noise;
  Contact contact;
  TrimSettings trim;
  NetworkSettings network;
  double physics_step_s = 0.0;
  double hip_height_m = 0.0;
  int hip_height_line = 0;
};

// Throws RobotError.
[[nodiscard]] NetworkFile read_network_file(const std::filesystem::path& file);

}  // namespace gaitway::urdf
