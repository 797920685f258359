// The weighted mean of the cells; thresholds with a margin; load, time and rattle; a leaky integral.
#include "gaitway/zmp/foot_contact.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::zmp {
namespace {

constexpr double kTurnedFoot_rad = 0.015;  // soles that turn against each other by more have slipped
constexpr double kLongestPlanted_s = 60.0;

constexpr double kLargestOffset_m_per_s2 = 0.5;  // three degrees of tilt

}  // namespace

FootPressure foot_pressure(const urdf::Foot& foot, std::span<const double, 4> cell_force_N,
                           double least_force_N) noexcept {
  FootPressure pressure;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (std::size_t cell = 0; cell < cell_force_N.size(); ++cell) {
    pressure.force_N += cell_force_N[cell];
    moment += cell_force_N[cell] * foot.cell_m[cell];
  }
  pressure.zmp_m = foot.centre_m;
  if (pressure.force_N >= least_force_N && pressure.force_N > 0.0) {
    pressure.zmp_m = (moment / pressure.force_N)
                         .cwiseMax(foot.centre_m - 0.5 * foot.size_m)
                         .cwiseMin(foot.centre_m + 0.5 * foot.size_m);
  }
  return pressure;
}

void ContactDetector::update(const std::array<double, 2>& force_N) noexcept {
  for (std::size_t side = 0; side < contact_.size(); ++side) {
    contact_[side] = force_N[side] >= (contact_[side] ? thresholds_.off_N : thresholds_.on_N);
  }
  const std::size_t support = static_cast<std::size_t>(support_);
  const std::size_t other = 1 - support;
  if (!contact_[other]) return;
  const double change_at = (0.5 + thresholds_.support_margin) * (force_N[0] + force_N[1]);
  if (!contact_[support] || force_N[other] > change_at) support_ = static_cast<urdf::Side>(other);
}

void PlantedFeet::update(const std::array<double, 2>& force_N, double angle_rad, double leg_rate_rad_per_s,
                         double dt_s) noexcept {
  double change = 0.0;
  for (std::size_t side = 0; side < force_N.size(); ++side) {
    change = std::max(change, std::abs(force_N[side] - last_force_N_[side]) / weight_N_);
  }
  last_force_N_ = force_N;
  leg_rate_rad_per_s_ = leg_rate_rad_per_s;
  rattle_ += dt_s / (parameters_.rattle_time_s + dt_s) * (change * change - rattle_);
  const double least_force_N = parameters_.planted_share * weight_N_;
  const bool loaded = force_N[0] > least_force_N && force_N[1] > least_force_N;
  const bool turned = planted() && std::abs(angle_rad - angle_rad_) > kTurnedFoot_rad;
  planted_s_ = loaded && !turned ? std::min(planted_s_ + dt_s, kLongestPlanted_s) : 0.0;
  if (planted_s_ < parameters_.planted_time_s + dt_s) angle_rad_ = angle_rad;
}

double PlantedFeet::creep_rad_rts() const noexcept {
  const EstimatorParameters& p = parameters_;
  return p.creep_rad_rts + p.settling_creep_rad_rts * std::exp(-planted_s_ / p.settling_time_s) +
         p.rattle_creep_rad_rts * rattle_ + p.moved_creep_rts * leg_rate_rad_per_s_;
}

SlipObserver::SlipObserver(const EstimatorParameters& parameters) noexcept
    : impact_s_(parameters.slip_impact_s),
      leak_s_(parameters.slip_leak_s),
      offset_time_s_(parameters.slip_offset_time_s) {}

void SlipObserver::update(bool in_contact, const Eigen::Vector2d& acceleration_m_per_s2,
                          double dt_s) noexcept {
  contact_s_ = in_contact ? std::min(contact_s_ + dt_s, offset_time_s_) : 0.0;
  if (contact_s_ <= impact_s_) {
    velocity_.setZero();
    return;
  }
  velocity_ = (velocity_ + dt_s * (acceleration_m_per_s2 - offset_)) * std::exp(-dt_s / leak_s_);
  offset_ += dt_s / offset_time_s_ * (acceleration_m_per_s2.cwiseMax(-1.0).cwiseMin(1.0) - offset_);
  offset_ = offset_.cwiseMax(-kLargestOffset_m_per_s2).cwiseMin(kLargestOffset_m_per_s2);
}

}  // namespace gaitway::zmp
