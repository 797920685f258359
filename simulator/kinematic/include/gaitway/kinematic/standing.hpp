// Where the base is and which soles stand, row by row: as a trajectory's source says, or, where it does not,
// as feet that stand flat and still make it.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "gaitway/kinematic/trajectory.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematic {

using SolePoses = std::array<std::vector<Eigen::Isometry3d>, 2>;  // [Side][row]

struct Standing {
  std::vector<Eigen::Isometry3d> base;         // above the floor at z = 0
  std::vector<motion::Contact> contact;        // what stands
  std::array<std::vector<int>, 2> since, yet;  // [Side][row]: rows for which it has stood, and still will

  [[nodiscard]] Eigen::Isometry3d sole(const SolePoses& in_base, urdf::Side side, std::size_t row) const {
    return base[row] * in_base[urdf::index_of(side)][row];
  }
};

// Without a base of the source's own, the first row stands with the middle between its soles above the
// origin. A sole stands whose lowest corner is less than `touch_m` above the floor, where the source does not
// say what does.
[[nodiscard]] Standing find_standing(const urdf::RobotModel& robot, const Trajectory& trajectory,
                                     const SolePoses& sole_in_base, double touch_m);

// Lowest corner of a sole above the floor.
[[nodiscard]] double lowest_m(const urdf::Foot& foot, const Eigen::Isometry3d& sole);

}  // namespace gaitway::kinematic
