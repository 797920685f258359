// Level frames from forward kinematics and attitude; uncertainties by its differences.
#include "gaitway/zmp/support_kinematics.hpp"

#include <cmath>
#include <vector>

#include "gaitway/geometry/tilt.hpp"

namespace gaitway::zmp {
namespace {

struct Places {
  Eigen::Vector3d com_m, other_foot_m;
};

Places places(SupportKinematics& kinematics, const std::vector<double>& position_rad) {
  kinematics.update(position_rad, Attitude{});
  return {kinematics.com_m(urdf::Side::left),
          kinematics.sole_point_m(urdf::Side::left, urdf::Side::right, Eigen::Vector2d::Zero())};
}

// A link that is heavier than described draws the CoM towards its own.
Eigen::Vector3d variance_from_masses(const urdf::RobotModel& model, const std::vector<double>& home_rad,
                                     double deviation_share) {
  urdf::ForwardKinematics kinematics(model);
  kinematics.compute(home_rad);
  const double mass_kg = model.total_mass_kg();
  Eigen::Vector3d variance = Eigen::Vector3d::Zero();
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    const Eigen::Vector3d lever =
        kinematics.link_pose(static_cast<int>(link)) * model.links[link].com_m - kinematics.com_m();
    variance += (deviation_share * model.links[link].mass_kg / mass_kg * lever).cwiseAbs2();
  }
  return variance;
}

}  // namespace

void SupportKinematics::level(const Attitude& attitude) noexcept {
  yaw_rad_ = attitude.yaw_rad;
  const Eigen::Matrix3d upright_from_base = attitude.tilt() * kinematics_.link_rotation(trunk_).transpose();
  for (const urdf::Side side : urdf::kSides) {
    const std::size_t i = index_of(side);
    base_from_sole_[i] = kinematics_.sole_pose(side);
    const Eigen::Vector3d forward = upright_from_base * base_from_sole_[i].linear().col(0);
    heading_rad_[i] = std::atan2(forward.y(), forward.x());
    level_from_base_[i] = Eigen::AngleAxisd(-heading_rad_[i], Eigen::Vector3d::UnitZ()) * upright_from_base;
  }
}

Eigen::Vector3d SupportKinematics::com_m(urdf::Side foot) const noexcept {
  const std::size_t i = index_of(foot);
  return level_from_base_[i] * (kinematics_.com_m() - base_from_sole_[i].translation());
}

Eigen::Vector3d SupportKinematics::sole_point_m(urdf::Side foot, urdf::Side of,
                                                const Eigen::Vector2d& point_m) const noexcept {
  const std::size_t i = index_of(foot);
  const Eigen::Vector3d in_base =
      base_from_sole_[index_of(of)] * Eigen::Vector3d(point_m.x(), point_m.y(), 0.0);
  return level_from_base_[i] * (in_base - base_from_sole_[i].translation());
}

SupportKinematics::BasePlace SupportKinematics::base(urdf::Side foot) const noexcept {
  const std::size_t i = index_of(foot);
  const Eigen::Vector3d forward = level_from_base_[i].col(0);
  return {(level_from_base_[i] * -base_from_sole_[i].translation()).head<2>(),
          std::atan2(forward.y(), forward.x())};
}

Eigen::Vector2d SupportKinematics::tilt_on_level_soles() const noexcept {
  const Eigen::Vector3d up_in_base = base_from_sole_[0].linear().col(2) + base_from_sole_[1].linear().col(2);
  return geometry::tilt_at_rest(kinematics_.link_rotation(trunk_).transpose() * up_in_base);
}

Eigen::Matrix3d SupportKinematics::turn(urdf::Side to, urdf::Side from) const noexcept {
  return level_from_base_[index_of(to)] * level_from_base_[index_of(from)].transpose();
}

ModelUncertainty model_uncertainty(const urdf::RobotModel& model, const EstimatorParameters& parameters) {
  std::vector<double> home_rad;
  for (const urdf::Joint& joint : model.joints) home_rad.push_back(joint.home_rad);
  SupportKinematics kinematics(model);
  const Places nominal = places(kinematics, home_rad);

  Eigen::Vector3d com = variance_from_masses(model, home_rad, parameters.link_mass_deviation);
  const double trunk_share =
      model.links[static_cast<std::size_t>(model.imu.link)].mass_kg / model.total_mass_kg();
  com.array() +=
      parameters.trunk_com_deviation_m * trunk_share * parameters.trunk_com_deviation_m * trunk_share;
  com.head<2>().array() += Eigen::numext::abs2(parameters.tilt_zero_deviation_rad * nominal.com_m.z());
  Eigen::Vector3d foot = Eigen::Vector3d::Zero();
  for (double& angle_rad : home_rad) {
    const double home = angle_rad;
    angle_rad += parameters.joint_zero_deviation_rad;
    const Places moved = places(kinematics, home_rad);
    com += (moved.com_m - nominal.com_m).cwiseAbs2();
    foot += (moved.other_foot_m - nominal.other_foot_m).cwiseAbs2();
    angle_rad = home;
  }
  return {com.cwiseSqrt(), foot.cwiseSqrt()};
}

}  // namespace gaitway::zmp
