// Forward kinematics from the pelvis down to the soles and up to the trunk; the forces' balance.
#include "tools/calibrate/standing_model.hpp"

#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/tilt.hpp"

namespace gaitway::calibration {
namespace {

using facts::kGravity_m_per_s2;
constexpr double kNoiseStep = 1e-3;  // in standard deviations
constexpr std::array<double, kCells> kWarp{1.0, -1.0, -1.0, 1.0};

}  // namespace

Eigen::Vector3d planar(const Eigen::Isometry3d& pose) {
  return {pose.translation().x(), pose.translation().y(),
          std::atan2(pose.linear()(1, 0), pose.linear()(0, 0))};
}

// Hands out one entry after another, times its deviation.
class StandingModel::Noise {
 public:
  explicit Noise(const Eigen::VectorXd& values) : values_(values) {}

  double next(double deviation) { return deviation * values_[taken_++]; }

 private:
  const Eigen::VectorXd& values_;
  Eigen::Index taken_ = 0;
};

StandingModel::StandingModel(const urdf::RobotModel& robot, const StandingMeasurement& measurement,
                             const StandingDeviations& deviations)
    : robot_(robot),
      measurement_(measurement),
      deviations_(deviations),
      kinematics_(robot),
      joint_rad_(robot.joints.size()) {
  const Eigen::Index feet = both_stand() ? 2 : 1;
  const Eigen::Index inclinometer = measurement.inclination_rad ? 2 : 0;
  residual_count_ = 2 + inclinometer + (both_stand() ? 6 : 0) + 3 + feet;
  noise_count_ = static_cast<Eigen::Index>(robot.joints.size()) + 3 * feet + 3 + inclinometer +
                 (both_stand() ? 4 : 0) + 5 * feet;
  residuals_.resize(residual_count_);
  for (std::size_t side = 0; side < 2; ++side) on_edge_[side] = on_edge(side);
}

int StandingModel::feet_on_edge() const noexcept {
  int feet = 0;
  for (std::size_t side = 0; side < 2; ++side) feet += measurement_.stands[side] && on_edge_[side] ? 1 : 0;
  return feet;
}

bool StandingModel::on_edge(std::size_t side) const {
  const urdf::Foot& foot = robot_.feet[side];
  double force_N = 0.0;
  Eigen::Vector2d pressure = Eigen::Vector2d::Zero();
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    force_N += measurement_.force_N[side][cell];
    pressure += measurement_.force_N[side][cell] * (foot.cell_m[cell] - foot.centre_m);
  }
  const Eigen::Array2d inside = foot.size_m.array() / 2.0 - (pressure / force_N).array().abs();
  return !(inside.minCoeff() > deviations_.edge_m);  // also for a foot that bears nothing
}

Eigen::VectorXd StandingModel::residuals(const RobotDeviations& robot, const Ground& ground,
                                         const Eigen::VectorXd& noise_values) {
  Noise noise(noise_values);
  filled_ = 0;
  const Stance at = stance(robot, ground, noise);
  add_trunk(robot, at, noise);
  if (both_stand()) add_feet(at, ground, noise);
  add_forces(robot, at, noise);
  return residuals_;
}

StandingModel::Stance StandingModel::stance(const RobotDeviations& robot, const Ground& ground,
                                            Noise& noise) {
  for (std::size_t j = 0; j < joint_rad_.size(); ++j) {
    joint_rad_[j] = measurement_.joint_rad[j] - robot.zero_rad[j] + noise.next(deviations_.joint_rad);
  }
  kinematics_.compute(joint_rad_);
  Stance at;
  at.floor_up.setZero();
  for (const urdf::Side side : urdf::kSides) {
    const auto i = static_cast<std::size_t>(side);
    at.sole[i] = kinematics_.sole_pose(side);
    if (!measurement_.stands[i]) continue;
    press_sole(robot, ground, i, noise, at);
    at.floor_up += at.normal[i];
  }
  at.floor_up.normalize();
  const Eigen::Matrix3d& reference = at.sole[measurement_.stands[0] ? 0 : 1].linear();
  at.up = (at.floor_up - reference.leftCols<2>() * ground.floor_tilt_rad).normalized();
  return at;
}

// Four equal springs below the corners: the sole sinks, and leans towards its centre of pressure.
void StandingModel::press_sole(const RobotDeviations& robot, const Ground& ground, std::size_t side,
                               Noise& noise, Stance& at) const {
  const urdf::Foot& foot = robot_.feet[side];
  double force_N = 0.0;
  Eigen::Vector2d moment_Nm = Eigen::Vector2d::Zero();  // force times place, about the middle
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    const double cell_N = measurement_.force_N[side][cell] / robot.cell_gain[side][cell];
    force_N += cell_N;
    moment_Nm += cell_N * (foot.cell_m[cell] - foot.centre_m);
  }
  const double compliance =
      ground.sole_compliance_m_per_N[side] * (1.0 + noise.next(deviations_.sole_unevenness));
  const Eigen::Vector2d lean =
      compliance * moment_Nm.cwiseQuotient((foot.size_m / 2.0).cwiseAbs2());  // downwards ahead, to the left
  const double tilt_rad = on_edge_[side] ? deviations_.edge_tilt_rad : deviations_.sole_tilt_rad;
  const double ahead = noise.next(tilt_rad) - lean.x(), left = noise.next(tilt_rad) - lean.y();
  at.normal[side] = at.sole[side].linear() * Eigen::Vector3d(ahead, left, 1.0).normalized();
  at.sink_m[side] = compliance * force_N;
}

void StandingModel::add_trunk(const RobotDeviations& robot, const Stance& stance, Noise& noise) {
  const Eigen::Matrix3d trunk = kinematics_.link_rotation(robot_.imu.link);  // in the base frame
  const Eigen::Vector3d up = trunk.transpose() * stance.up;
  Eigen::Vector3d force = measurement_.specific_force_m_per_s2;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    force[axis] += noise.next(measurement_.specific_force_deviation_m_per_s2[axis]);
  }
  const Eigen::Vector2d by_force =
      geometry::tilt_at_rest(force) - tilt_said(ImuSensor::accelerometer, robot_.imu, robot.imu, up);
  add(by_force.x());
  add(by_force.y());
  if (!measurement_.inclination_rad) return;
  const Eigen::Vector2d predicted = tilt_said(ImuSensor::inclinometer, robot_.imu, robot.imu, up);
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    add((*measurement_.inclination_rad)[axis] + noise.next(measurement_.inclination_deviation_rad[axis]) -
        predicted[axis]);
  }
}

void StandingModel::add_feet(const Stance& stance, const Ground& ground, Noise& noise) {
  const Eigen::Vector3d across = stance.sole[0].linear().transpose() * (stance.normal[1] - stance.normal[0]);
  add(across.x());
  add(across.y());
  const double height_m = on_edge_[0] || on_edge_[1] ? deviations_.edge_height_m : deviations_.sole_height_m;
  std::array<Eigen::Vector3d, 2> middle;
  for (std::size_t side = 0; side < 2; ++side) {
    const Eigen::Vector2d& centre = robot_.feet[side].centre_m;
    middle[side] = stance.sole[side] * Eigen::Vector3d(centre.x(), centre.y(), 0.0);
  }
  add((middle[1] - middle[0]).dot(stance.floor_up) + stance.sink_m[1] - stance.sink_m[0] +
      noise.next(height_m));
  const Eigen::Vector3d moved = planar(stance.sole[0].inverse() * stance.sole[1]) - ground.placement;
  add(moved.x() + noise.next(deviations_.creep_ahead_m));
  add(moved.y() + noise.next(deviations_.creep_aside_m));
  add(std::remainder(moved.z() + noise.next(deviations_.creep_rad), 2.0 * std::numbers::pi));
}

// Weight; moments about the point below the centre of mass; soles as rigid plates on four springs.
void StandingModel::add_forces(const RobotDeviations& robot, const Stance& stance, Noise& noise) {
  const double mass_kg = total_mass_kg(robot_, robot);
  const double weight_N = mass_kg * kGravity_m_per_s2;
  const Eigen::Vector3d com = com_m(robot, mass_kg);
  double force_N = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  std::array<double, 2> warp_N{}, load_N{};
  for (std::size_t side = 0; side < 2; ++side) {
    if (!measurement_.stands[side]) continue;
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      const double reading_N =
          measurement_.force_N[side][cell] + noise.next(measurement_.force_deviation_N[side][cell]);
      const double cell_N = reading_N / robot.cell_gain[side][cell];
      const Eigen::Vector2d& place = robot_.feet[side].cell_m[cell];
      moment += cell_N * (stance.sole[side] * Eigen::Vector3d(place.x(), place.y(), 0.0) - com);
      load_N[side] += cell_N;
      warp_N[side] += kWarp[cell] * cell_N;
    }
    force_N += load_N[side];
  }
  add(force_N - weight_N);
  const Eigen::Matrix3d& reference = stance.sole[measurement_.stands[0] ? 0 : 1].linear();
  const Eigen::Vector3d left = stance.up.cross(reference.col(0)).normalized();
  const Eigen::Vector3d ahead = left.cross(stance.up);
  add(moment.dot(ahead) / weight_N);
  add(moment.dot(left) / weight_N);
  for (std::size_t side = 0; side < 2; ++side) {
    if (measurement_.stands[side]) {
      add(warp_N[side] + noise.next(deviations_.plate_unevenness * std::abs(load_N[side])));
    }
  }
}

Eigen::Vector3d StandingModel::com_m(const RobotDeviations& robot, double mass_kg) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t link = 0; link < robot_.links.size(); ++link) {
    const int index = static_cast<int>(link);
    Eigen::Vector3d own = robot_.links[link].com_m;
    if (index == robot_.imu.link) own += robot.trunk_com_offset_m;
    sum += robot.mass_factor[link] * robot_.links[link].mass_kg *
           (kinematics_.link_rotation(index) * own + kinematics_.link_position_m(index));
  }
  return sum / mass_kg;
}

Eigen::MatrixXd StandingModel::covariance(const RobotDeviations& robot, const Ground& ground) {
  Eigen::VectorXd noise = Eigen::VectorXd::Zero(noise_count_);
  Eigen::MatrixXd sensitivity(residual_count_, noise_count_);
  for (Eigen::Index i = 0; i < noise_count_; ++i) {
    noise[i] = kNoiseStep;
    sensitivity.col(i) = residuals(robot, ground, noise);
    noise[i] = -kNoiseStep;
    sensitivity.col(i) -= residuals(robot, ground, noise);
    noise[i] = 0.0;
  }
  sensitivity /= 2.0 * kNoiseStep;
  return sensitivity * sensitivity.transpose();
}

Eigen::Vector3d StandingModel::placement(const RobotDeviations& robot) {
  const Eigen::VectorXd noise = Eigen::VectorXd::Zero(noise_count_);
  Noise none(noise);
  const Stance at = stance(robot, {}, none);
  return planar(at.sole[0].inverse() * at.sole[1]);
}

}  // namespace gaitway::calibration
