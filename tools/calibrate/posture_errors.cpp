// Forward kinematics at the angles that the encoders would say at home.
#include "tools/calibrate/calibration_estimator.hpp"

#include "tools/calibrate/standing_model.hpp"

namespace gaitway::calibration {
namespace {

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

struct Posture {
  Eigen::Isometry3d between;        // right sole in the left sole's frame
  Eigen::Matrix3d trunk_over_sole;  // trunk's axes in the left sole's
  Eigen::Vector2d com_m;            // over the middle of the soles, in the left sole's axes
  Eigen::Vector2d tilt_said_rad;    // by the IMU, while the left sole is level
};

Posture posture(const urdf::RobotModel& robot, const RobotDeviations& deviations) {
  std::vector<double> joint_rad;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    joint_rad.push_back(robot.joints[j].home_rad - deviations.zero_rad[j]);
  }
  urdf::ForwardKinematics kinematics(robot);
  kinematics.compute(joint_rad);
  const Eigen::Isometry3d left = kinematics.sole_pose(urdf::Side::left);
  const Eigen::Isometry3d right = kinematics.sole_pose(urdf::Side::right);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double mass_kg = 0.0;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    const int index = static_cast<int>(link);
    const double own_kg = deviations.mass_factor[link] * robot.links[link].mass_kg;
    Eigen::Vector3d own = robot.links[link].com_m;
    if (index == robot.imu.link) own += deviations.trunk_com_offset_m;
    moment += own_kg * (kinematics.link_pose(index) * own);
    mass_kg += own_kg;
  }
  const Eigen::Vector3d middle = 0.5 * (left.translation() + right.translation());
  const Eigen::Matrix3d trunk_over_sole =
      left.linear().transpose() * kinematics.link_rotation(robot.imu.link);
  const ImuSensor sensor =
      robot.carries(urdf::SensorKind::inclination) ? ImuSensor::inclinometer : ImuSensor::accelerometer;
  return {left.inverse() * right, trunk_over_sole,
          (left.linear().transpose() * (moment / mass_kg - middle)).head<2>(),
          tilt_said(sensor, robot.imu, deviations.imu, trunk_over_sole.row(2))};
}

}  // namespace

const std::array<NamedQuantity, kPostureErrors>& posture_quantities() {
  static const std::array<NamedQuantity, kPostureErrors> names{
      {{"right sole ahead of the left", "m"},
       {"right sole left of the left", "m"},
       {"right sole above the left", "m"},
       {"right sole rolled against the left", "rad"},
       {"right sole pitched against the left", "rad"},
       {"right sole yawed against the left", "rad"},
       {"trunk rolled over the left sole", "rad"},
       {"trunk pitched over the left sole", "rad"},
       {"centre of mass ahead", "m"},
       {"centre of mass to the left", "m"},
       {"roll that the IMU says", "rad"},
       {"pitch that the IMU says", "rad"}}};
  return names;
}

std::vector<double> posture_errors(const urdf::RobotModel& robot, const RobotDeviations& deviations) {
  const Posture described = posture(robot, no_deviations(robot));
  const Posture real = posture(robot, deviations);
  const Eigen::Vector3d moved = real.between.translation() - described.between.translation();
  const Eigen::Vector3d turned =
      rotation_vector(real.between.linear() * described.between.linear().transpose());
  const Eigen::Vector3d lean = rotation_vector(real.trunk_over_sole * described.trunk_over_sole.transpose());
  const Eigen::Vector2d com = real.com_m - described.com_m;
  const Eigen::Vector2d said = real.tilt_said_rad - described.tilt_said_rad;
  return {moved.x(), moved.y(), moved.z(), turned.x(), turned.y(), turned.z(),
          lean.x(),  lean.y(),  com.x(),   com.y(),    said.x(),   said.y()};
}

}  // namespace gaitway::calibration
