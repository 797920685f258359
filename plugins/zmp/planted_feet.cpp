// Load, time, the angle between the soles; and the rattle of the load.
#include "gaitway/zmp/planted_feet.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::zmp {
namespace {

constexpr double kTurnedFoot_rad = 0.015;  // soles that turn against each other by more have slipped
constexpr double kSettling_s = 1.0;        // time constant with which feet come to rest
constexpr double kLongestPlanted_s = 60.0;
constexpr double kRattleTime_s = 0.5;

}  // namespace

PlantedFeet::PlantedFeet(const EstimatorParameters& parameters, double weight_N) noexcept
    : weight_N_(weight_N),
      least_force_N_(parameters.planted_share * weight_N),
      least_s_(parameters.planted_time_s),
      creep_(parameters.creep_rad_rts),
      settling_creep_(parameters.settling_creep_rad_rts),
      rattle_creep_(parameters.rattle_creep_rad_rts),
      moved_creep_(parameters.moved_creep_rts) {}

void PlantedFeet::update(const std::array<double, 2>& force_N, double angle_rad, double leg_rate_rad_per_s,
                         double dt_s) noexcept {
  double change = 0.0;
  for (std::size_t side = 0; side < force_N.size(); ++side) {
    change = std::max(change, std::abs(force_N[side] - last_force_N_[side]) / weight_N_);
  }
  last_force_N_ = force_N;
  leg_rate_rad_per_s_ = leg_rate_rad_per_s;
  rattle_ += dt_s / (kRattleTime_s + dt_s) * (change * change - rattle_);
  const bool loaded = force_N[0] > least_force_N_ && force_N[1] > least_force_N_;
  const bool turned = planted() && std::abs(angle_rad - angle_rad_) > kTurnedFoot_rad;
  planted_s_ = loaded && !turned ? std::min(planted_s_ + dt_s, kLongestPlanted_s) : 0.0;
  if (planted_s_ < least_s_ + dt_s) angle_rad_ = angle_rad;
}

double PlantedFeet::creep_rad_rts() const noexcept {
  return creep_ + settling_creep_ * std::exp(-planted_s_ / kSettling_s) + rattle_creep_ * rattle_ +
         moved_creep_ * leg_rate_rad_per_s_;
}

}  // namespace gaitway::zmp
