// Euler rates, integrated, and a first-order pull towards the measured tilt.
#include "gaitway/zmp/attitude_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gaitway::zmp {
namespace {

constexpr double kGravity_m_per_s2 = 9.81;
constexpr double kLeastCosine = 0.1;  // of the pitch: beyond 84 degrees the robot lies, and yaw means little

double turned_towards(double angle_rad, double measured_rad, double share) noexcept {
  return angle_rad + share * std::remainder(measured_rad - angle_rad, 2.0 * std::numbers::pi);
}

}  // namespace

Eigen::Matrix3d Attitude::tilt() const noexcept {
  return (Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

void AttitudeFilter::update(const Eigen::Vector3d& angular_velocity_rad_per_s,
                            const std::optional<Eigen::Vector2d>& tilt, double dt_s) noexcept {
  const Eigen::Vector3d& w = angular_velocity_rad_per_s;
  const double sine = std::sin(attitude_.roll_rad);
  const double cosine = std::cos(attitude_.roll_rad);
  const double cosine_pitch = std::max(std::cos(attitude_.pitch_rad), kLeastCosine);
  const double yaw_rate = (w.y() * sine + w.z() * cosine) / cosine_pitch;
  attitude_.roll_rad += dt_s * (w.x() + std::sin(attitude_.pitch_rad) * yaw_rate);
  attitude_.pitch_rad += dt_s * (w.y() * cosine - w.z() * sine);
  attitude_.yaw_rad += dt_s * yaw_rate;
  if (!tilt) return;
  const double share = has_tilt_ ? dt_s / (time_constant_s_ + dt_s) : 1.0;
  attitude_.roll_rad = turned_towards(attitude_.roll_rad, tilt->x(), share);
  attitude_.pitch_rad = turned_towards(attitude_.pitch_rad, tilt->y(), share);
  has_tilt_ = true;
}

std::optional<Eigen::Vector2d> tilt_of_acceleration(const Eigen::Vector3d& specific_force_m_per_s2,
                                                    double band_m_per_s2) noexcept {
  const Eigen::Vector3d& f = specific_force_m_per_s2;
  if (!(std::abs(f.norm() - kGravity_m_per_s2) <= band_m_per_s2)) return std::nullopt;
  return Eigen::Vector2d(std::atan2(f.y(), f.z()), std::atan2(-f.x(), std::hypot(f.y(), f.z())));
}

}  // namespace gaitway::zmp
