// The estimator's trunk: turned by the gyro, upright by the inclinometer or by what accelerometer and soles
// tell, its heading held by feet that stand.
#include <algorithm>
#include <cmath>
#include <optional>

#include "gaitway/facts/facts.hpp"
#include "gaitway/zmp/state_estimator.hpp"

namespace gaitway::zmp {
namespace {

using facts::kGravity_m_per_s2;
constexpr int kLongestGapSlots = 10;  // of the IMU; after a longer one, roll and pitch start anew
// Of the accelerometer, one sample. A walk's accelerations are alike from one sample to the next, so it is
// taken for larger than it is.
constexpr double kRestlessTilt_rad = 0.2;
constexpr double kRest_m_per_s2 = 1.0;    // from gravity, of a body that is hardly accelerated
constexpr double kLevelSoles_rad = 0.02;  // deviation of soles on a floor, by joint zeros and the floor
// Of a body that has been calm for so long a pendulum hangs at rest: what it tells of one that moves is where
// the accelerations point, and late.
constexpr double kHangingTilt_rad = 0.05;
constexpr double kCalm_rad_per_s = 0.1;
constexpr double kCalm_m_per_s2 = 0.5;  // from gravity
constexpr int kCalmSlots = 15;
constexpr double kGainsaid_rad = 0.35;

}  // namespace

void StateEstimator::update_attitude() noexcept {
  const int slots = inputs_.imu_slots();
  if (slots == 0) return;
  if (slots > kLongestGapSlots) attitude_.lose_tilt();
  const double dt_s = facts::kSlot_s * std::min(slots, kLongestGapSlots);
  attitude_.predict(inputs_.gyro_rad_per_s(), dt_s, dt_s - facts::kSlot_s);
  turned_attitude_ = attitude_.attitude();
  correct_tilt();
  angular_velocity_ +=
      dt_s / (parameters_.rate_filter_s + dt_s) * (attitude_.rate_rad_per_s() - angular_velocity_);
}

void StateEstimator::correct_tilt() noexcept {
  if (senses_tilt_) {
    attitude_.correct_tilt(*inputs_.inclination_rad(), parameters_.tilt_noise_rad);
    return;
  }
  const Eigen::Vector3d& force_m_per_s2 = inputs_.acceleration_m_per_s2();
  if (!attitude_.has_tilt() && !begin_tilt(force_m_per_s2)) return;
  const double off_m_per_s2 = std::abs(force_m_per_s2.norm() - kGravity_m_per_s2);
  const bool calm = off_m_per_s2 < kCalm_m_per_s2 && attitude_.rate_rad_per_s().norm() < kCalm_rad_per_s;
  calm_slots_ = calm ? std::min(calm_slots_ + 1, kCalmSlots) : 0;
  if (inputs_.inclination_rad() && calm_slots_ == kCalmSlots) {
    attitude_.correct_tilt(*inputs_.inclination_rad(), kHangingTilt_rad);
  } else if (off_m_per_s2 <= parameters_.accelerometer_band_m_per_s2) {
    attitude_.correct_by_force(force_m_per_s2 / kGravity_m_per_s2, kRestlessTilt_rad);
  }
}

// It begins with what level soles say, unless the accelerometer gainsays them: a robot that gets its load in
// the first slots is shaken more than its soles are tilted, and one that lies is neither.
bool StateEstimator::begin_tilt(const Eigen::Vector3d& force_m_per_s2) noexcept {
  const auto tilt_rad = tilt_of_acceleration(force_m_per_s2, kRest_m_per_s2);
  if (!tilt_rad) return false;
  kinematics_.update(inputs_.position_rad(), Attitude{});
  const Eigen::Vector2d on_soles = kinematics_.tilt_on_level_soles();
  const bool level = (*tilt_rad - on_soles).norm() < kGainsaid_rad;
  attitude_.correct_tilt(level ? on_soles : *tilt_rad, level ? kLevelSoles_rad : kRestlessTilt_rad);
  return true;
}

void StateEstimator::hold_heading() noexcept {
  const InputFaults& faults = inputs_.faults();
  if (inputs_.imu_slots() == 0 || faults.joints_stale || faults.missing != 0) return;
  const double left = kinematics_.heading_rad(urdf::Side::left);
  const double right = kinematics_.heading_rad(urdf::Side::right);
  feet_planted_.update({pressure_[0].force_N, pressure_[1].force_N}, left - right,
                       inputs_.leg_reference_rate_rad_per_s(), facts::kSlot_s);
  if (feet_planted_.planted()) {
    attitude_.hold_heading(0.5 * (left + right), feet_planted_.creep_rad_rts(), facts::kSlot_s);
  } else {
    attitude_.release_heading();
  }
}

}  // namespace gaitway::zmp
