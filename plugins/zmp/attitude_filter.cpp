// The error's dynamics in world axes, and scalar corrections one after another.
#include "gaitway/zmp/attitude_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/tilt.hpp"

namespace gaitway::zmp {
namespace {

using facts::kGravity_m_per_s2;
constexpr double kLeastCosine = 0.1;  // of the pitch: beyond 84 degrees the robot lies, and yaw means little
constexpr double kTurn_rad = 2.0 * std::numbers::pi;
// An unknown heading is no more uncertain than this.
constexpr double kLargestYawDeviation_rad = std::numbers::pi;
// The yaw is brought back by whole turns before it leaves what the topic holds.
constexpr double kLargestYaw_rad = 1000.0 * kTurn_rad;
constexpr double kSmallTurn_rad = 1e-9;

Eigen::Matrix3d turn_by(const Eigen::Vector3d& turn) noexcept {
  const double angle = turn.norm();
  if (angle < kSmallTurn_rad) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

Eigen::Matrix3d tilt_of(double roll_rad, double pitch_rad) noexcept {
  return (Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

Eigen::Matrix3d about_vertical(double angle_rad) noexcept {
  return Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

}  // namespace

Eigen::Matrix3d Attitude::tilt() const noexcept {
  return tilt_of(roll_rad, pitch_rad);
}

AttitudeFilter::AttitudeFilter(const EstimatorParameters& parameters) noexcept
    : gyro_noise_(parameters.gyro_noise_rad_per_s),
      unheard_rate_rad_per_s_(parameters.unheard_rate_rad_per_s),
      bias_deviation_(parameters.bias_deviation_rad_per_s),
      bias_lifetime_s_(parameters.bias_lifetime_s),
      bias_walk_(parameters.bias_walk_rad_per_s_rts),
      heading_noise_(parameters.heading_noise_rad) {
  covariance_.block<3, 3>(kBias, kBias).diagonal().setConstant(Eigen::numext::abs2(bias_deviation_));
}

void AttitudeFilter::predict(const Eigen::Vector3d& gyro_rad_per_s, double dt_s, double unheard_s) noexcept {
  gyro_ = gyro_rad_per_s;
  Matrix transition = Matrix::Identity();
  transition.block<3, 3>(kTurn, kBias) = -dt_s * world_from_trunk_;
  const double kept = std::exp(-dt_s / bias_lifetime_s_);
  transition.block<3, 3>(kBias, kBias).diagonal().setConstant(kept);
  covariance_ = (transition * covariance_ * transition.transpose()).eval();
  covariance_.block<3, 3>(kTurn, kTurn).diagonal().array() +=
      Eigen::numext::abs2(gyro_noise_ * (dt_s - unheard_s)) +
      Eigen::numext::abs2(unheard_rate_rad_per_s_ * unheard_s);
  covariance_.block<3, 3>(kBias, kBias).diagonal().array() +=
      Eigen::numext::abs2(bias_deviation_) * (1.0 - kept * kept);
  covariance_.block<2, 2>(kBias, kBias).diagonal().array() += Eigen::numext::abs2(bias_walk_) * dt_s;
  world_from_trunk_ = (world_from_trunk_ * turn_by(dt_s * rate_rad_per_s())).eval();
  bias_ *= kept;
  bound_yaw();
  read_angles();
}

// Beyond what can be said about an angle, variance is only a number that grows; scaling keeps the matrix
// valid.
void AttitudeFilter::bound_yaw() noexcept {
  const double variance = covariance_(kTurn + 2, kTurn + 2);
  if (variance <= Eigen::numext::abs2(kLargestYawDeviation_rad)) return;
  const double scale = kLargestYawDeviation_rad / std::sqrt(variance);
  covariance_.row(kTurn + 2) *= scale;
  covariance_.col(kTurn + 2) *= scale;
}

void AttitudeFilter::correct_tilt(const Eigen::Vector2d& roll_pitch_rad, double deviation_rad) noexcept {
  if (!has_tilt_) {
    start_tilt(roll_pitch_rad, deviation_rad);
    return;
  }
  correct_by_force(tilt_of(roll_pitch_rad.x(), roll_pitch_rad.y()).row(2).transpose(), deviation_rad);
}

void AttitudeFilter::correct_by_force(const Eigen::Vector3d& force_g, double deviation_rad) noexcept {
  // A mean over the slot is the tilt in its middle.
  constexpr double kHalfSlot_s = 0.005;
  const Eigen::Matrix3d middle = world_from_trunk_ * turn_by(-kHalfSlot_s * rate_rad_per_s());
  const Eigen::Vector3d up = middle * force_g;  // exp(-turn) z: z, if the attitude is right
  const double variance = Eigen::numext::abs2(deviation_rad);
  Vector sensitivity = Vector::Zero();
  sensitivity[kTurn] = 1.0;
  correct(sensitivity, up.y(), variance);
  sensitivity[kTurn] = 0.0;
  sensitivity[kTurn + 1] = 1.0;
  correct(sensitivity, -up.x(), variance);
  read_angles();
}

void AttitudeFilter::start_tilt(const Eigen::Vector2d& roll_pitch_rad, double deviation_rad) noexcept {
  world_from_trunk_ = about_vertical(attitude_.yaw_rad) * tilt_of(roll_pitch_rad.x(), roll_pitch_rad.y());
  for (const int axis : {kTurn, kTurn + 1}) {
    covariance_.row(axis).setZero();
    covariance_.col(axis).setZero();
    covariance_(axis, axis) = Eigen::numext::abs2(deviation_rad);
  }
  has_tilt_ = true;
  read_angles();
}

void AttitudeFilter::hold_heading(double feet_against_trunk_rad, double creep_rad_rts, double dt_s) noexcept {
  const double heading = attitude_.yaw_rad + feet_against_trunk_rad;
  if (!feet_heading_rad_) {
    feet_heading_rad_ = heading;
    covariance_.row(kFeet) = covariance_.row(kTurn + 2).eval();
    covariance_.col(kFeet) = covariance_.col(kTurn + 2).eval();
    covariance_(kFeet, kFeet) = covariance_(kTurn + 2, kTurn + 2) + Eigen::numext::abs2(heading_noise_);
    return;
  }
  covariance_(kFeet, kFeet) += Eigen::numext::abs2(creep_rad_rts) * dt_s;
  Vector sensitivity = Vector::Zero();
  sensitivity[kTurn + 2] = 1.0;
  sensitivity[kFeet] = -1.0;
  correct(sensitivity, std::remainder(*feet_heading_rad_ - heading, kTurn_rad),
          Eigen::numext::abs2(heading_noise_));
  read_angles();
}

void AttitudeFilter::release_heading() noexcept {
  feet_heading_rad_.reset();
  covariance_.row(kFeet).setZero();
  covariance_.col(kFeet).setZero();
}

void AttitudeFilter::correct(const Vector& sensitivity, double residual, double variance) noexcept {
  const Vector spread = covariance_ * sensitivity;
  const double whole = sensitivity.dot(spread) + variance;
  if (!(whole > 0.0)) return;
  const Vector error = spread * (residual / whole);
  covariance_ -= spread * spread.transpose() / whole;
  world_from_trunk_ = (turn_by(error.segment<3>(kTurn)) * world_from_trunk_).eval();
  bias_ += error.segment<3>(kBias);
  if (feet_heading_rad_) *feet_heading_rad_ += error[kFeet];
}

// Rounding is taken out of rotation and covariance here: they are the same after thirty days as after one.
void AttitudeFilter::read_angles() noexcept {
  world_from_trunk_ = Eigen::Quaterniond(world_from_trunk_).normalized().toRotationMatrix();
  covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
  const Eigen::Matrix3d& r = world_from_trunk_;
  attitude_.roll_rad = std::atan2(r(2, 1), r(2, 2));
  attitude_.pitch_rad = std::atan2(-r(2, 0), std::hypot(r(2, 1), r(2, 2)));
  attitude_.yaw_rad += std::remainder(std::atan2(r(1, 0), r(0, 0)) - attitude_.yaw_rad, kTurn_rad);
  if (std::abs(attitude_.yaw_rad) <= kLargestYaw_rad) return;
  const double whole_turns = kTurn_rad * std::round(attitude_.yaw_rad / kTurn_rad);
  attitude_.yaw_rad -= whole_turns;
  if (feet_heading_rad_) *feet_heading_rad_ -= whole_turns;
}

Eigen::Vector3d AttitudeFilter::attitude_deviation_rad() const noexcept {
  const Eigen::Matrix3d heading = about_vertical(-attitude_.yaw_rad);
  const Eigen::Vector3d variance =
      (heading * covariance_.block<3, 3>(kTurn, kTurn) * heading.transpose()).diagonal().cwiseMax(0.0);
  Eigen::Vector3d deviation = variance.cwiseSqrt();
  deviation.x() /= std::max(std::cos(attitude_.pitch_rad), kLeastCosine);
  return deviation;
}

Eigen::Vector3d AttitudeFilter::bias_deviation_rad_per_s() const noexcept {
  return covariance_.block<3, 3>(kBias, kBias).diagonal().cwiseMax(0.0).cwiseSqrt();
}

std::optional<Eigen::Vector2d> tilt_of_acceleration(const Eigen::Vector3d& specific_force_m_per_s2,
                                                    double band_m_per_s2) noexcept {
  const Eigen::Vector3d& f = specific_force_m_per_s2;
  if (!(std::abs(f.norm() - kGravity_m_per_s2) <= band_m_per_s2)) return std::nullopt;
  return geometry::tilt_at_rest(f);
}

}  // namespace gaitway::zmp
