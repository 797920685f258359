// The order of one update: inputs, attitude, pressure and contacts, then the CoM's filter.
#include "gaitway/zmp/state_estimator.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::zmp {
namespace {

using facts::kGravity_m_per_s2;
constexpr double kLeastForceShare = 0.02;  // of the body weight: with less, a ZMP says nothing
// Without joint states the pendulum is predicted, but it is unstable: after so many ticks the CoM is held.
constexpr int kMostBlindTicks = 10;
// So many slots may go by without a prediction of the CoM (a tick that was missed). After more, what it has
// moved meanwhile is no sign of how fast it is now.
constexpr int kMostUnpredictedSlots = 2;
constexpr int kLongestMeanSlots = 25;  // over which the mean velocity says something about the present one
// After a longer gap the filters take so long until their velocities say whether the body falls.
constexpr int kSettlingTicks = 15;

const EstimatorParameters& checked(const EstimatorParameters& parameters) {
  parameters.validate();
  return parameters;
}

ContactThresholds thresholds_of(const EstimatorParameters& parameters, double mass_kg) {
  const double weight_N = mass_kg * kGravity_m_per_s2;
  return {parameters.contact_on_share * weight_N, parameters.contact_off_share * weight_N,
          parameters.support_margin};
}

}  // namespace

StateEstimator::StateEstimator(const urdf::RobotModel& model, const EstimatorParameters& parameters)
    : parameters_(checked(parameters)),
      mass_kg_(model.total_mass_kg()),
      nominal_com_height_m_(urdf::home_com_height_m(model)),
      neck_(urdf::neck_of(model, urdf::ForwardKinematics(model))),
      feet_(model.feet),
      inputs_(model, parameters.stale_after_s),
      contacts_(thresholds_of(parameters, mass_kg_)),
      senses_load_(model.senses_load()),
      senses_tilt_(model.senses_tilt()),
      load_model_(model),
      cells_(parameters, mass_kg_ * kGravity_m_per_s2),
      attitude_(parameters),
      feet_planted_(parameters, mass_kg_ * kGravity_m_per_s2),
      model_uncertainty_(model_uncertainty(model, parameters)),
      kinematics_(model),
      com_{ComFilter(parameters, std::sqrt(kGravity_m_per_s2 / nominal_com_height_m_), facts::kSlot_s),
           ComFilter(parameters, std::sqrt(kGravity_m_per_s2 / nominal_com_height_m_), facts::kSlot_s),
           ComFilter(parameters, 0.0, facts::kSlot_s)},
      com_offset_(parameters, model_uncertainty_.com_m.head<2>()),
      slip_{SlipObserver(parameters), SlipObserver(parameters)},
      fall_(parameters.fall) {}

bool StateEstimator::update(std::int64_t now_ns, const JointStates& joints, const FootForces& forces,
                            const gaitway::Imu& imu, Estimate& estimate) noexcept {
  inputs_.take(now_ns, joints, forces, imu);
  if (!inputs_.complete()) return false;
  update_attitude();
  place_body();
  update_pressure();
  hold_heading();
  update_slip();
  update_com();
  if (!inputs_.faults().joints_stale) odometry_.update(kinematics_, support_);
  update_fall();
  write(estimate);
  return true;
}

// What is learned of the attitude moves the CoM that is seen from the soles, but it is no movement of the
// body.
void StateEstimator::place_body() noexcept {
  kinematics_.update(inputs_.position_rad(), turned_attitude_);
  const Eigen::Vector3d before_m = kinematics_.com_m(support_);
  kinematics_.level(attitude_.attitude());
  turned_attitude_ = attitude_.attitude();
  if (!started_ || senses_tilt_) return;
  Eigen::Vector3d learned_m = kinematics_.com_m(support_) - before_m;
  learned_m.head<2>() = com_offset_.believed_of(learned_m.head<2>());
  for (std::size_t axis = 0; axis < 3; ++axis) com_[axis].shift(learned_m[static_cast<Eigen::Index>(axis)]);
  last_measured_m_ += learned_m;
}

void StateEstimator::update_pressure() noexcept {
  const double weight_N = mass_kg_ * kGravity_m_per_s2;
  const double least_force_N = kLeastForceShare * weight_N;
  if (const int slots = inputs_.force_slots(); slots > 0) {
    const Eigen::Vector3d force = attitude_.attitude().tilt() * inputs_.acceleration_m_per_s2();
    const double dt_s = facts::kSlot_s * slots;
    if (!senses_load_) load_model_.update(kinematics_, force, dt_s);
    cells_.update(senses_load_ ? inputs_.cell_force_N() : load_model_.force_N(),
                  force.z() / kGravity_m_per_s2, dt_s);
  }
  for (const urdf::Side side : urdf::kSides) {
    const std::size_t i = index_of(side);
    pressure_[i] = foot_pressure(feet_[i], cells_.force_N()[i], least_force_N);
  }
  contacts_.update({pressure_[0].force_N, pressure_[1].force_N});
}

void StateEstimator::update_slip() noexcept {
  if (inputs_.force_slots() == 0) return;
  for (const urdf::Side side : urdf::kSides) {
    const Eigen::Vector3d force = kinematics_.sole_tilt(side) * inputs_.foot_acceleration_m_per_s2(side);
    slip_[index_of(side)].update(contacts_.in_contact(side), force.head<2>(),
                                 facts::kSlot_s * inputs_.force_slots());
  }
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

// From the cells' noise and gains, and from how well the kinematics knows where the other foot is.
Eigen::Vector2d StateEstimator::zmp_variance_in(urdf::Side foot) const noexcept {
  const double force_N = pressure_[0].force_N + pressure_[1].force_N;
  if (force_N < kLeastForceShare * mass_kg_ * kGravity_m_per_s2) return zmp_variance_;
  std::array<CellCalibration::PerCell, 2> lever;
  for (const urdf::Side side : urdf::kSides) {
    for (std::size_t cell = 0; cell < 4; ++cell) {
      const Eigen::Vector3d place = kinematics_.sole_point_m(foot, side, feet_[index_of(side)].cell_m[cell]);
      for (Eigen::Index axis = 0; axis < 2; ++axis) {
        lever[static_cast<std::size_t>(axis)][static_cast<Eigen::Index>(4 * index_of(side) + cell)] =
            (place[axis] - zmp_m_[axis]) / force_N;
      }
    }
  }
  const double other_share = std::clamp(pressure_[1 - index_of(foot)].force_N / force_N, 0.0, 1.0);
  Eigen::Vector2d variance = (other_share * model_uncertainty_.foot_m.head<2>()).cwiseAbs2();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    variance[static_cast<Eigen::Index>(axis)] += cells_.variance_of_sum(lever[axis]);
  }
  if (!senses_load_) variance.array() += Eigen::numext::abs2(load_model_.zmp_deviation_m());
  return variance;
}

void StateEstimator::update_com() noexcept {
  if (!started_) begin_com(Eigen::Vector3d::Zero());
  if (inputs_.joint_slots() - predicted_ticks_ > kMostUnpredictedSlots + 1) resume_com();
  follow_frame();
  const InputFaults& faults = inputs_.faults();
  zmp_m_ = zmp_in(support_);
  zmp_variance_ = zmp_variance_in(support_);
  blind_ticks_ = faults.joints_stale ? std::min(blind_ticks_ + 1, kMostBlindTicks) : 0;
  if (!faults.joints_stale || (!faults.forces_stale && blind_ticks_ < kMostBlindTicks)) {
    const double stiffness = in_the_air() ? 0.0 : omega_rad_per_s() * omega_rad_per_s();
    com_[0].predict(stiffness * (com_[0].position_m() - zmp_m_.x()));
    com_[1].predict(stiffness * (com_[1].position_m() - zmp_m_.y()));
    com_[2].predict((pressure_[0].force_N + pressure_[1].force_N) / mass_kg_ - kGravity_m_per_s2);
    ++predicted_ticks_;
  }
  if (contacts_.support() != support_) change_support();
  if (faults.joints_stale) return;
  const Eigen::Vector3d measured = measured_com_m(support_);
  for (std::size_t axis = 0; axis < 3; ++axis) com_[axis].correct(measured[static_cast<Eigen::Index>(axis)]);
  last_measured_m_ = measured;
  predicted_ticks_ = 0;
  // A model's ZMP follows from where the CoM is thought to be, so it does not say that it is elsewhere.
  if (faults.forces_stale || in_the_air() || !senses_load_) return;
  com_offset_.update({com_[0].unexplained_m_per_s2(), com_[1].unexplained_m_per_s2()}, omega_rad_per_s(),
                     zmp_variance_, facts::kSlot_s);
}

void StateEstimator::begin_com(const Eigen::Vector3d& velocity_m_per_s) noexcept {
  support_ = contacts_.support();
  const Eigen::Vector3d com = measured_com_m(support_);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    com_[static_cast<std::size_t>(axis)].set_state({com[axis], velocity_m_per_s[axis], 0.0});
  }
  frame_heading_rad_ = kinematics_.world_heading_rad(support_);
  started_ = true;
}

// After a while in which nothing was heard, or nobody listened. Corrected as if it were of one slot, what the
// CoM has moved in all that time would look like a fall.
void StateEstimator::resume_com() noexcept {
  const int slots = inputs_.joint_slots();
  const bool says_something = contacts_.support() == support_ && slots <= kLongestMeanSlots;
  const Eigen::Vector3d mean = (measured_com_m(support_) - last_measured_m_) / (facts::kSlot_s * slots);
  begin_com(says_something ? mean : Eigen::Vector3d::Zero());
  predicted_ticks_ = 0;
  settling_ticks_ = says_something ? 0 : kSettlingTicks;
}

// Of old values a fall is neither told nor over.
void StateEstimator::update_fall() noexcept {
  if (inputs_.faults().joints_stale || inputs_.faults().imu_stale) return;
  if (settling_ticks_ > 0) {
    --settling_ticks_;
    return;
  }
  FallInputs now;
  now.body.com_m = filtered_com_m();
  now.body.com_velocity_m_per_s = {com_[0].velocity_m_per_s(), com_[1].velocity_m_per_s(),
                                   com_[2].velocity_m_per_s()};
  for (const urdf::Side side : urdf::kSides) {
    auto corner = now.body.sole_corner_m[index_of(side)].begin();
    for (const Eigen::Vector2d& place : feet_[index_of(side)].corners_m())
      *corner++ = kinematics_.sole_point_m(support_, side, place);
  }
  const Attitude& attitude = attitude_.attitude();
  now.heading_rad = -kinematics_.heading_rad(support_);
  now.trunk_tilt_rad =
      std::acos(std::clamp(std::cos(attitude.roll_rad) * std::cos(attitude.pitch_rad), -1.0, 1.0));
  now.load_share = (pressure_[0].force_N + pressure_[1].force_N) / (mass_kg_ * kGravity_m_per_s2);
  fall_.update(now);
}

bool StateEstimator::in_the_air() const noexcept {
  return !contacts_.in_contact(urdf::Side::left) && !contacts_.in_contact(urdf::Side::right);
}

Eigen::Vector3d StateEstimator::measured_com_m(urdf::Side foot) const noexcept {
  Eigen::Vector3d com = kinematics_.com_m(foot);
  com.head<2>() -= com_offset_.offset_m();
  return com;
}

// The level frame turns with its sole: little while the robot stands on it, anyhow when it lies, and at once
// by half a turn where the sole's x axis passes the vertical. Turned with it, the states stay those of the
// body.
void StateEstimator::follow_frame() noexcept {
  const double heading_rad = kinematics_.world_heading_rad(support_);
  const Eigen::Rotation2Dd turn(frame_heading_rad_ - heading_rad);
  Eigen::Matrix<double, 2, 3> states;  // row: axis; column: position, velocity, unexplained acceleration
  states << com_[0].state().transpose(), com_[1].state().transpose();
  states = (turn.toRotationMatrix() * states).eval();
  com_[0].set_state(states.row(0).transpose());
  com_[1].set_state(states.row(1).transpose());
  zmp_m_ = turn * zmp_m_;
  frame_heading_rad_ = heading_rad;
}

// The filters' states, seen from the other foot: what they know beyond the kinematics is kept.
void StateEstimator::change_support() noexcept {
  const urdf::Side to = contacts_.support();
  const Eigen::Matrix3d turn = kinematics_.turn(to, support_);
  Eigen::Matrix3d states;  // row: axis; column: position, velocity, unexplained acceleration
  for (std::size_t axis = 0; axis < 3; ++axis)
    states.row(static_cast<Eigen::Index>(axis)) = com_[axis].state();
  states.col(0) -= measured_com_m(support_);
  states = (turn * states).eval();
  states.col(0) += measured_com_m(to);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    com_[axis].set_state(states.row(static_cast<Eigen::Index>(axis)).transpose());
  }
  support_ = to;
  frame_heading_rad_ = kinematics_.world_heading_rad(to);
  zmp_m_ = zmp_in(to);
  zmp_variance_ = zmp_variance_in(to);
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
    estimate.slip_speed[i] = slip_[i].speed_m_per_s();
    estimate.foot_force[i] = pressure_[i].force_N;
    Eigen::Map<Eigen::Vector2d>(estimate.foot_zmp[i]) = pressure_[i].zmp_m;
  }
  estimate.fall = static_cast<std::uint32_t>(fall_.fall());
  estimate.fall_direction = fall_.direction_rad();
  estimate.time_to_impact = fall_.time_to_impact_s();
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
  Eigen::Map<Eigen::Vector3d>(estimate.gyro_bias) = attitude_.bias_rad_per_s();
  std::ranges::copy(neck_.angles_rad(inputs_.position_rad()), estimate.head);
  write_odometry(estimate);
  write_deviations(estimate);
}

void StateEstimator::write_odometry(Estimate& estimate) const noexcept {
  const auto write = [](const FootOdometry::Pose& pose, double* to) {
    to[0] = pose.place_m.x();
    to[1] = pose.place_m.y();
    to[2] = pose.yaw_rad;
  };
  for (const urdf::Side side : urdf::kSides)
    write(odometry_.foot(side), estimate.odometry_foot[index_of(side)]);
  write(odometry_.base(), estimate.odometry_base);
}

void StateEstimator::write_deviations(Estimate& estimate) const noexcept {
  const double omega = omega_rad_per_s();
  Eigen::Vector3d model = model_uncertainty_.com_m.cwiseAbs2();
  // Of a tilt that is off, the CoM is beside the foot. How the IMU is mounted is in the offset's variance.
  const double tilt_rad = attitude_.attitude_deviation_rad().head<2>().maxCoeff();
  model.head<2>() = com_offset_.variance_m2().array() + Eigen::numext::abs2(tilt_rad * com_[2].position_m());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double of_model = model[static_cast<Eigen::Index>(axis)];
    estimate.com_deviation[axis] = std::sqrt(com_[axis].position_variance() + of_model);
    if (axis < 2) estimate.dcm_deviation[axis] = std::sqrt(com_[axis].dcm_variance(omega) + of_model);
  }
  Eigen::Map<Eigen::Vector2d>(estimate.zmp_deviation) = zmp_variance_.cwiseSqrt();
  Eigen::Vector3d attitude_deviation_rad = attitude_.attitude_deviation_rad();
  for (double& deviation_rad : attitude_deviation_rad.head<2>())
    deviation_rad = std::hypot(deviation_rad, parameters_.tilt_zero_deviation_rad);
  Eigen::Map<Eigen::Vector3d>(estimate.attitude_deviation) = attitude_deviation_rad;
  Eigen::Map<Eigen::Vector3d>(estimate.gyro_bias_deviation) = attitude_.bias_deviation_rad_per_s();
}

}  // namespace gaitway::zmp
