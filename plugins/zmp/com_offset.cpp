// The scalar filters.
#include "gaitway/zmp/com_offset.hpp"

namespace gaitway::zmp {
namespace {

constexpr double kFloorTime_s = 1.0;

}  // namespace

ComOffset::ComOffset(const EstimatorParameters& parameters, const Eigen::Vector2d& deviation_m) noexcept
    : noise_m_rts_(parameters.com_offset_noise_m_rts),
      drift_m_per_rts_(parameters.com_offset_drift_m_per_rts),
      prior_variance_(deviation_m.cwiseAbs2()),
      variance_(prior_variance_) {}

void ComOffset::update(const Eigen::Vector2d& unexplained_m_per_s2, double omega_rad_per_s,
                       const Eigen::Vector2d& zmp_variance_m2, double dt_s) noexcept {
  // Noise of so much in a second of samples, however many they are.
  const double noise = noise_m_rts_ * noise_m_rts_ / dt_s;
  variance_ =
      (variance_.array() + drift_m_per_rts_ * drift_m_per_rts_ * dt_s).matrix().cwiseMin(prior_variance_);
  const Eigen::Vector2d gain = variance_.array() / (variance_.array() + noise);
  const Eigen::Vector2d limit = 3.0 * prior_variance_.cwiseSqrt();
  offset_ -= gain.cwiseProduct(unexplained_m_per_s2) / (omega_rad_per_s * omega_rad_per_s);
  offset_ = offset_.cwiseMax(-limit).cwiseMin(limit);
  variance_ -= gain.cwiseProduct(variance_);
  floor_ += dt_s / (kFloorTime_s + dt_s) * (zmp_variance_m2.cwiseMin(prior_variance_) - floor_);
}

}  // namespace gaitway::zmp
