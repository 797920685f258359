// By what one robot differs from its kind's description: what a calibration looks for.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::calibration {

inline constexpr std::size_t kCells = 4;  // of a foot, in the order of urdf::Foot::cell_m

struct RobotDeviations {
  std::vector<double> zero_rad;  // of each joint: what its encoder says where the joint is at 0
  Eigen::Vector3d trunk_com_offset_m = Eigen::Vector3d::Zero();  // from the description's, in the trunk
  std::vector<double> mass_factor;                               // of each link
  std::array<std::array<double, kCells>, 2> cell_gain{};         // [Side]: reading over force
};

[[nodiscard]] inline RobotDeviations no_deviations(const urdf::RobotModel& robot) {
  RobotDeviations none;
  none.zero_rad.assign(robot.joints.size(), 0.0);
  none.mass_factor.assign(robot.links.size(), 1.0);
  for (auto& foot : none.cell_gain) foot.fill(1.0);
  return none;
}

[[nodiscard]] inline double total_mass_kg(const urdf::RobotModel& robot, const RobotDeviations& deviations) {
  double mass_kg = 0.0;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    mass_kg += deviations.mass_factor[link] * robot.links[link].mass_kg;
  }
  return mass_kg;
}

}  // namespace gaitway::calibration
