// One row of a run's record, every 10 ms: what the robot did, what it was asked for and what its sensors
// said.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace gaitway::tools {

struct RunSample {
  double time_s = 0.0;
  std::uint32_t mode = 0;  // of the message controller
  // truth, world frame
  Eigen::Vector3d base_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d base_rpy_rad = Eigen::Vector3d::Zero();
  Eigen::Vector3d com_m = Eigen::Vector3d::Zero();
  Eigen::Vector2d cop_m = Eigen::Vector2d::Zero();  // centre of pressure of the physics engine
  std::array<Eigen::Vector4d, 2> foot{};            // x, y, z, yaw of each sole
  // measured and reference, laid into the world at the true support foot; NaN where there is none
  Eigen::Vector2d measured_zmp_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d reference_zmp_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d reference_com_m = Eigen::Vector2d::Zero();
  // measured, as the topics carry it
  std::array<double, 3> angular_velocity_rad_per_s{};
  std::array<double, 3> acceleration_m_per_s2{};
  std::array<double, 2> inclination_rad{};
  std::array<std::array<double, 4>, 2> force_N{};
  std::array<double, 8> trim_rad{};
  std::vector<float> joint_position_rad, joint_velocity_rad_per_s, joint_reference_rad, joint_torque_Nm;
};

}  // namespace gaitway::tools
