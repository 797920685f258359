// The order of one update: inputs, attitude, pressure and contacts, then the CoM's filter.
#include "gaitway/zmp/state_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gaitway::zmp {
namespace {

constexpr double kTick_s = 0.010;
constexpr double kGravity_m_per_s2 = 9.81;
constexpr double kLeastForceShare = 0.02;  // of the body weight: with less, a ZMP says nothing
// Without joint states the pendulum is predicted, but it is unstable: after so many ticks the CoM is held.
constexpr int kMostBlindTicks = 10;
constexpr int kLongestGapSlots = 10;  // of the IMU; after a longer one, roll and pitch start anew

const EstimatorParameters& checked(const EstimatorParameters& parameters) {
  parameters.validate();
  return parameters;
}

ContactThresholds thresholds_of(const EstimatorParameters& parameters, double mass_kg) {
  const double weight_N = mass_kg * kGravity_m_per_s2;
  return {parameters.contact_on_share * weight_N, parameters.contact_off_share * weight_N,
          parameters.support_margin};
}

double home_com_height_m(const urdf::RobotModel& model) {
  const urdf::ForwardKinematics home(model);
  const double height_m = (home.com_m() - home.sole_pose(urdf::Side::left).translation()).z();
  if (!(height_m > 0.0)) {
    throw std::invalid_argument("the CoM of robot '" + model.name +
                                "' is not above its soles in the home posture; check home_deg in robot.yaml");
  }
  return height_m;
}

std::size_t index_of(urdf::Side side) noexcept {
  return static_cast<std::size_t>(side);
}

}  // namespace

StateEstimator::StateEstimator(const urdf::RobotModel& model, const EstimatorParameters& parameters)
    : parameters_(checked(parameters)),
      mass_kg_(model.total_mass_kg()),
      nominal_com_height_m_(home_com_height_m(model)),
      feet_(model.feet),
      inputs_(model, parameters.stale_after_s),
      contacts_(thresholds_of(parameters, mass_kg_)),
      bias_(parameters),
      attitude_(parameters.tilt_time_constant_s),
      kinematics_(model),
      com_{ComFilter(parameters, std::sqrt(kGravity_m_per_s2 / nominal_com_height_m_), kTick_s),
           ComFilter(parameters, std::sqrt(kGravity_m_per_s2 / nominal_com_height_m_), kTick_s),
           ComFilter(parameters, 0.0, kTick_s)} {}

bool StateEstimator::update(std::int64_t now_ns, const JointStates& joints, const FootForces& forces,
                            const gaitway::Imu& imu, Estimate& estimate) noexcept {
  inputs_.take(now_ns, joints, forces, imu);
  if (!inputs_.complete()) return false;
  update_attitude();
  kinematics_.update(inputs_.position_rad(), attitude_.attitude());
  update_pressure();
  update_com();
  write(estimate);
  return true;
}

void StateEstimator::update_attitude() noexcept {
  const int slots = inputs_.imu_slots();
  if (slots == 0) return;
  const bool planted = contacts_.in_contact(urdf::Side::left) && contacts_.in_contact(urdf::Side::right);
  const double dt_s = kTick_s * std::min(slots, kLongestGapSlots);
  bias_.update(inputs_.gyro_rad_per_s(), planted, inputs_.fastest_leg_joint_rad_per_s(), dt_s);
  if (slots > kLongestGapSlots) attitude_.lose_tilt();
  const Eigen::Vector3d rate = inputs_.gyro_rad_per_s() - bias_.bias_rad_per_s();
  angular_velocity_ += dt_s / (parameters_.rate_filter_s + dt_s) * (rate - angular_velocity_);
  const std::optional<Eigen::Vector2d> tilt =
      inputs_.inclination_rad()
          ? inputs_.inclination_rad()
          : tilt_of_acceleration(inputs_.acceleration_m_per_s2(), parameters_.accelerometer_band_m_per_s2);
  attitude_.update(rate, tilt, dt_s);
}

void StateEstimator::update_pressure() noexcept {
  const double least_force_N = kLeastForceShare * mass_kg_ * kGravity_m_per_s2;
  for (const urdf::Side side : urdf::kSides) {
    const std::size_t i = index_of(side);
    pressure_[i] = foot_pressure(feet_[i], inputs_.cell_force_N(side), least_force_N);
  }
  contacts_.update({pressure_[0].force_N, pressure_[1].force_N});
}

// Mean of the feet's ZMPs, weighted by force; the last one while there is no load.
Eigen::Vector2d StateEstimator::zmp_in(urdf::Side foot) const noexcept {
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  double force_N = 0.0;
  for (const urdf::Side side : urdf::kSides) {
    const FootPressure& pressure = pressure_[index_of(side)];
    const double weight = std::max(pressure.force_N, 0.0);
    moment += weight * kinematics_.sole_point_m(foot, side, pressure.zmp_m).head<2>();
    force_N += weight;
  }
  return force_N < kLeastForceShare * mass_kg_ * kGravity_m_per_s2 ? zmp_m_
                                                                   : Eigen::Vector2d(moment / force_N);
}

void StateEstimator::update_com() noexcept {
  if (!started_) {
    support_ = contacts_.support();
    const Eigen::Vector3d com = kinematics_.com_m(support_);
    for (std::size_t axis = 0; axis < 3; ++axis) com_[axis].start(com[static_cast<Eigen::Index>(axis)]);
    started_ = true;
  }
  const InputFaults& faults = inputs_.faults();
  zmp_m_ = zmp_in(support_);
  blind_ticks_ = faults.joints_stale ? std::min(blind_ticks_ + 1, kMostBlindTicks) : 0;
  if (!faults.joints_stale || (!faults.forces_stale && blind_ticks_ < kMostBlindTicks)) {
    const bool in_the_air =
        !contacts_.in_contact(urdf::Side::left) && !contacts_.in_contact(urdf::Side::right);
    const double stiffness = in_the_air ? 0.0 : omega_rad_per_s() * omega_rad_per_s();
    com_[0].predict(stiffness * (com_[0].position_m() - zmp_m_.x()));
    com_[1].predict(stiffness * (com_[1].position_m() - zmp_m_.y()));
    com_[2].predict((pressure_[0].force_N + pressure_[1].force_N) / mass_kg_ - kGravity_m_per_s2);
  }
  if (contacts_.support() != support_) change_support();
  if (faults.joints_stale) return;
  const Eigen::Vector3d measured = kinematics_.com_m(support_);
  for (std::size_t axis = 0; axis < 3; ++axis) com_[axis].correct(measured[static_cast<Eigen::Index>(axis)]);
}

// The filters' states, seen from the other foot: what they know beyond the kinematics is kept.
void StateEstimator::change_support() noexcept {
  const urdf::Side to = contacts_.support();
  const Eigen::Matrix3d turn = kinematics_.turn(to, support_);
  Eigen::Matrix3d states;  // row: axis; column: position, velocity, unexplained acceleration
  for (std::size_t axis = 0; axis < 3; ++axis)
    states.row(static_cast<Eigen::Index>(axis)) = com_[axis].state();
  states.col(0) -= kinematics_.com_m(support_);
  states = (turn * states).eval();
  states.col(0) += kinematics_.com_m(to);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    com_[axis].set_state(states.row(static_cast<Eigen::Index>(axis)).transpose());
  }
  support_ = to;
  zmp_m_ = zmp_in(to);
}

Eigen::Vector3d StateEstimator::filtered_com_m() const noexcept {
  return {com_[0].position_m(), com_[1].position_m(), com_[2].position_m()};
}

double StateEstimator::omega_rad_per_s() const noexcept {
  const double height_m = started_ ? com_[2].position_m() : nominal_com_height_m_;
  return std::sqrt(kGravity_m_per_s2 /
                   std::clamp(height_m, 0.5 * nominal_com_height_m_, 1.5 * nominal_com_height_m_));
}

void StateEstimator::write(Estimate& estimate) const noexcept {
  estimate.stamp_ns = inputs_.stamp_ns();
  estimate.support = static_cast<std::uint32_t>(support_);
  for (const urdf::Side side : urdf::kSides) {
    const std::size_t i = index_of(side);
    estimate.contact[i] = contacts_.in_contact(side) ? 1 : 0;
    estimate.foot_force[i] = pressure_[i].force_N;
    Eigen::Map<Eigen::Vector2d>(estimate.foot_zmp[i]) = pressure_[i].zmp_m;
  }
  Eigen::Map<Eigen::Vector2d>(estimate.zmp) = zmp_m_;
  const double omega = omega_rad_per_s();
  const Eigen::Vector3d com = filtered_com_m();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    estimate.com[axis] = com[static_cast<Eigen::Index>(axis)];
    estimate.com_velocity[axis] = com_[axis].velocity_m_per_s();
    if (axis < 2) estimate.dcm[axis] = estimate.com[axis] + estimate.com_velocity[axis] / omega;
  }
  const Attitude& attitude = attitude_.attitude();
  estimate.attitude[0] = attitude.roll_rad;
  estimate.attitude[1] = attitude.pitch_rad;
  estimate.attitude[2] = attitude.yaw_rad;
  Eigen::Map<Eigen::Vector3d>(estimate.angular_velocity) = angular_velocity_;
}

}  // namespace gaitway::zmp
