// The robot of the tests and what its sensors would say, made from a wanted state.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::zmp::test {

using facts::kGravity_m_per_s2;
inline constexpr std::int64_t kTick_ns = facts::kSlot_ns;

inline const urdf::RobotModel& humanoid() {
  static const urdf::RobotModel model = urdf::load_robot(GAITWAY_URDF_DIR "/humanoid22");
  return model;
}

inline std::vector<double> home_posture(const urdf::RobotModel& model) {
  std::vector<double> home;
  for (const urdf::Joint& joint : model.joints) home.push_back(joint.home_rad);
  return home;
}

// Cell forces whose sum is force_N and whose ZMP is zmp_m in the sole frame, as a rigid plate loads four
// equal springs.
inline std::array<double, 4> cell_forces(const urdf::Foot& foot, double force_N,
                                         const Eigen::Vector2d& zmp_m) {
  const Eigen::Vector2d half = 0.5 * (foot.cell_m[0] - foot.cell_m[3]);
  const Eigen::Vector2d middle = 0.5 * (foot.cell_m[0] + foot.cell_m[3]);
  const Eigen::Vector2d share = (zmp_m - middle).cwiseQuotient(half) / 4.0;
  return {force_N * (0.25 + share.x() + share.y()), force_N * (0.25 + share.x() - share.y()),
          force_N * (0.25 - share.x() + share.y()), force_N * (0.25 - share.x() - share.y())};
}

// Everything that the sensors say in one slot.
struct Sensors {
  JointStates joints{};
  FootForces forces{};
  gaitway::Imu imu{};

  explicit Sensors(const urdf::RobotModel& model = humanoid()) {
    joints.joint_count = static_cast<std::uint32_t>(model.joints.size());
    set_posture(home_posture(model));
    imu.acceleration[2] = kGravity_m_per_s2;
  }
  void set_posture(const std::vector<double>& position_rad) {
    for (std::size_t i = 0; i < position_rad.size(); ++i) joints.position[i] = position_rad[i];
  }
  void press(urdf::Side side, double force_N, const Eigen::Vector2d& zmp_m) {
    const auto i = static_cast<std::size_t>(side);
    const auto cells = cell_forces(humanoid().feet[i], force_N, zmp_m);
    for (std::size_t cell = 0; cell < cells.size(); ++cell) forces.force[i][cell] = cells[cell];
  }
  void stamp(std::int64_t stamp_ns) {
    joints.stamp_ns = forces.stamp_ns = imu.stamp_ns = stamp_ns;
    joints.slot = static_cast<std::uint32_t>(stamp_ns / kTick_ns);
  }
};

inline double weight_N() {
  return humanoid().total_mass_kg() * kGravity_m_per_s2;
}

}  // namespace gaitway::zmp::test
