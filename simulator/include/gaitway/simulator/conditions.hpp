// What a trial does to the ground and to the body, unknown to the robot's plug-ins: slopes, tiles, steps,
// slip, load, weak motors, play in the joints, bad sensors. By default nothing of it.
//
// In a scenario:
//
//   conditions:
//     friction: 0.4               # of the ground; the robot's own value if left out
//     slope_deg: [5, 0]           # by how much the ground rises ahead, and to the left
//     tiles_m: 0.005              # tiles of 100 mm of random height, from 0 to this
//     step: {at_m: 1.0, height_m: -0.008}   # the ground beyond lies so much higher
//     trunk_mass_factor: 1.1
//     torque_factor: 0.75         # of what each motor can give
//     backlash_deg: 0.2           # play of each joint behind its encoder
//     gyro_bias_deg_per_s: 0.2    # standard deviation, each axis
//     cell_gain_deviation: 0.03   # standard deviation of the force cells' gains
//     dead_cell: {foot: left, cell: 0}      # front left, front right, rear left, rear right
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::input {
class YamlValue;
}

namespace gaitway::simulator {

inline constexpr double kTileSide_m = 0.1;

// The ground changes its height by `height_m` at the line x = at_m of the world.
struct GroundStep {
  double at_m = 1.0;
  double height_m = 0.0;
};

struct GroundConditions {
  std::optional<double> friction;                       // none: the robot's `simulation: contact`
  Eigen::Vector2d slope_rad = Eigen::Vector2d::Zero();  // rise ahead, rise to the left
  // Tiles of kTileSide_m, heights uniform in [0, this]; where the robot stands at the start it is flat.
  double tile_height_m = 0.0;
  std::optional<GroundStep> step;
};

struct DeadCell {
  urdf::Side foot = urdf::Side::left;
  std::size_t cell = 0;  // order of Foot::cell_m; it reads nothing but noise
};

struct BodyConditions {
  double trunk_mass_factor = 1.0;
  double torque_factor = 1.0;
  double backlash_rad = 0.0;                   // whole width of the play
  double gyro_bias_deviation_rad_per_s = 0.0;  // σ of a constant for each axis
  double cell_gain_deviation = 0.0;            // σ of a constant factor's distance from 1, for each cell
  std::optional<DeadCell> dead_cell;
};

struct Conditions {
  GroundConditions ground;
  BodyConditions body;
};

// As a scenario writes them. Throws input::InputError with file, line, field, value and rule.
[[nodiscard]] Conditions read_conditions(const input::YamlValue& value);

}  // namespace gaitway::simulator
