// By what one robot differs from its kind's description, what is known of that before anything is measured,
// and how far standing still and flat can be trusted.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "tools/calibrate/imu_errors.hpp"

namespace gaitway::calibration {

inline constexpr std::size_t kCells = 4;  // of a foot, in the order of urdf::Foot::cell_m

// By what one robot differs from its kind's description: what a calibration looks for.
struct RobotDeviations {
  std::vector<double> zero_rad;  // of each joint: what its encoder says where the joint is at 0
  Eigen::Vector3d trunk_com_offset_m = Eigen::Vector3d::Zero();  // from the description's, in the trunk
  std::vector<double> mass_factor;                               // of each link
  std::array<std::array<double, kCells>, 2> cell_gain{};         // [Side]: reading over force
  ImuErrors imu;
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

// Standard deviations of a robot from its description, as they are manufactured.
struct ManufacturingDeviations {
  double joint_zero_rad = 0.4 * facts::kRadPerDegree;
  Eigen::Vector3d trunk_com_m{0.006, 0.004, 0.006};
  double link_mass = 0.05;  // share
  double cell_gain = 0.03;  // share
  ImuDeviations imu;
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
  double creep_ahead_m = 0.0004;                        // of a foot from pose to pose
  double creep_aside_m = 0.0008;                        // the same: legs press sideways against each other
  double creep_rad = 0.3 * facts::kRadPerDegree;        // about the vertical
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
