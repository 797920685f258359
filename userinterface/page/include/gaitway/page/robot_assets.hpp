// The robot's description as a page wants it.
#pragma once

#include <cstddef>
#include <optional>

#include "gaitway/page/asset_table.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::page {

// With what a simulated robot may be pushed.
struct PushBounds {
  double least_N = 0.0, most_N = 0.0;
  double usual_N = 0.0;  // of who only taps
  double shortest_s = 0.0, longest_s = 0.0;
};

// What a velocity command may ask for, for how long it holds, and how long the command is kept without a
// sign.
struct CommandBounds {
  double forward_m_per_s = 0.0, turn_rad_per_s = 0.0;
  double velocity_holds_s = 0.0, lease_s = 0.0;
  std::optional<PushBounds> push = {};  // nothing: the robot is no simulation
};

inline constexpr std::size_t kMostMeshBytes = std::size_t{32} * 1024 * 1024;  // of all; the others are boxes

// Adds /robot.json (links, joints, shapes, soles, motions, bounds) and the meshes that it names.
void add_robot(AssetTable& table, const urdf::RobotModel& robot, const CommandBounds& bounds);

}  // namespace gaitway::page
