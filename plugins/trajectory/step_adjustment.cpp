// Closed forms, each axis for itself.
#include "gaitway/trajectory/step_adjustment.hpp"

#include <cmath>

namespace gaitway::trajectory {

StepAdjustment::StepAdjustment(const GaitParameters& parameters, double omega_per_s) noexcept
    : threshold_m_(parameters.adjust_threshold_m, parameters.adjust_side_threshold_m),
      share_(parameters.adjust_share),
      swing_speed_m_per_s_(parameters.adjust_speed_m_per_s),
      omega_per_s_(omega_per_s),
      half_double_support_s_(0.5 * parameters.double_support_points() * kPointPeriod_s) {}

// The ZMP moves to the new foot in the middle of the double support that follows the landing.
double StepAdjustment::decay(double landing_s) const noexcept {
  return std::exp(-omega_per_s_ * (landing_s + half_double_support_s_));
}

Eigen::Vector2d StepAdjustment::excess_m(const Eigen::Vector2d& deviation_m) const noexcept {
  if (share_ <= 0.0) return Eigen::Vector2d::Zero();
  return deviation_m - deviation_m.cwiseMax(-threshold_m_).cwiseMin(threshold_m_);
}

Eigen::Vector2d StepAdjustment::shift_m(const Eigen::Vector2d& excess_m, double landing_s,
                                        double swing_left_s) const noexcept {
  const double most_m = swing_speed_m_per_s_ * swing_left_s;
  return (share_ / decay(landing_s) * excess_m).cwiseMax(-most_m).cwiseMin(most_m);
}

}  // namespace gaitway::trajectory
