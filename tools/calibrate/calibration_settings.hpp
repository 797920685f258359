// What is known before anything is measured, and how far standing still and flat can be trusted.
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "gaitway/facts/facts.hpp"

namespace gaitway::calibration {

// Standard deviations of a robot from its description, as they are manufactured.
struct ManufacturingDeviations {
  double joint_zero_rad = 0.4 * facts::kRadPerDegree;
  Eigen::Vector3d trunk_com_m{0.006, 0.004, 0.006};
  double link_mass = 0.05;  // share
  double cell_gain = 0.03;  // share
};

// How far a standing pose may be from soles that are flat on one plane: standard deviations, where nothing
// else is said.
struct StandingDeviations {
  // Of an angle from what its encoder says, beyond its zero: in each pose anew, and the same in all of them,
  // as where the load holds a joint with play on one side.
  double joint_rad = 0.002 * facts::kRadPerDegree;
  double lasting_joint_rad = 0.0;
  // Soles and floor give way like springs below the corners of the soles. How much is found with the rest,
  // about this mean.
  double sole_compliance_m_per_N = 5e-6;  // of a whole sole
  double sole_compliance_deviation_m_per_N = 5e-6;
  double sole_unevenness = 0.05;                        // share by which one sole in one pose gives otherwise
  double sole_tilt_rad = 0.003 * facts::kRadPerDegree;  // of a sole against the floor, beyond that
  double sole_height_m = 0.00001;                       // of one sole against the other, beyond that
  double creep_ahead_m = 0.0001;                        // of a foot from pose to pose
  double creep_aside_m = 0.0002;                        // the same: legs press sideways against each other
  double creep_rad = 0.08 * facts::kRadPerDegree;       // about the vertical
  double floor_tilt_rad = 0.0;                          // of the floor against the horizontal; 0: it is level
  double plate_unevenness = 0.0003;  // of a foot's force: springs of its cells are not quite equal
  // A sole whose centre of pressure is this near to its edge may stand on the edge.
  double edge_m = 0.004;
  double edge_tilt_rad = 1.0 * facts::kRadPerDegree;
  double edge_height_m = 0.001;
};

// Loaded joints stand at one end of their play, most of them at the same end in all poses.
inline void allow_play(double width_rad, StandingDeviations& deviations) {
  deviations.joint_rad = width_rad / std::sqrt(12.0);  // anywhere within
  deviations.lasting_joint_rad = 0.4 * width_rad;
}

struct Weighing {
  double mass_kg = 0.0;
  double deviation_kg = 0.0;
};

struct CalibrationSettings {
  ManufacturingDeviations manufacturing;
  StandingDeviations standing;
  std::optional<Weighing>
      weighing;  // none: the description's mass, as uncertain as the links' masses make it
};

}  // namespace gaitway::calibration
