// Order: joint zeros, trunk CoM, cell gains, link masses, IMU, the floor's lean, each sole's compliance,
// placements, lasting errors of the angles if there are any.
#include "tools/calibrate/parameter_layout.hpp"

#include <utility>

namespace gaitway::calibration {
namespace {

// Of a placement from the first look: wide, since nobody knows where the feet are.
constexpr double kPlacementDeviation_m = 0.05;
constexpr double kPlacementDeviation_rad = 0.2;

}  // namespace

ParameterLayout::ParameterLayout(const urdf::RobotModel& robot, const ManufacturingDeviations& deviations,
                                 const StandingDeviations& standing, std::vector<Eigen::Vector3d> placements)
    : joints_(static_cast<Eigen::Index>(robot.joints.size())),
      links_(static_cast<Eigen::Index>(robot.links.size())),
      lasting_(standing.lasting_joint_rad > 0.0 ? joints_ : 0),
      deviations_(deviations),
      standing_(standing),
      placements_(std::move(placements)) {}

RobotDeviations ParameterLayout::robot(const Eigen::VectorXd& parameters) const {
  RobotDeviations robot;
  for (Eigen::Index joint = 0; joint < joints_; ++joint) {
    robot.zero_rad.push_back(deviations_.joint_zero_rad * parameters[joint]);
  }
  robot.trunk_com_offset_m = deviations_.trunk_com_m.cwiseProduct(parameters.segment<3>(joints_));
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < kCells; ++i) {
      robot.cell_gain[side][i] = 1.0 + deviations_.cell_gain * parameters[cell(side, i)];
    }
  }
  for (Eigen::Index link = 0; link < links_; ++link) {
    robot.mass_factor.push_back(1.0 + deviations_.link_mass * parameters[first_link() + link]);
  }
  robot.imu = imu_errors(deviations_.imu, parameters.segment<kImuUnknowns>(first_imu()));
  return robot;
}

RobotDeviations ParameterLayout::standing_robot(const Eigen::VectorXd& parameters) const {
  RobotDeviations standing = robot(parameters);
  for (Eigen::Index joint = 0; joint < lasting_; ++joint) {
    standing.zero_rad[static_cast<std::size_t>(joint)] +=
        standing_.lasting_joint_rad * parameters[first_lasting() + joint];
  }
  return standing;
}

Ground ParameterLayout::ground(const Eigen::VectorXd& parameters, int index) const {
  Ground ground;
  ground.floor_tilt_rad = standing_.floor_tilt_rad * parameters.segment<2>(floor());
  for (std::size_t side = 0; side < 2; ++side) {
    ground.sole_compliance_m_per_N[side] =
        standing_.sole_compliance_m_per_N +
        standing_.sole_compliance_deviation_m_per_N *
            parameters[first_compliance() + static_cast<Eigen::Index>(side)];
  }
  if (index >= 0) {
    const Eigen::Vector3d wide(kPlacementDeviation_m, kPlacementDeviation_m, kPlacementDeviation_rad);
    ground.placement = placements_[static_cast<std::size_t>(index)] +
                       wide.cwiseProduct(parameters.segment<3>(first_placement() + 3 * index));
  }
  return ground;
}

}  // namespace gaitway::calibration
