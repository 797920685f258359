// The filters, and the iteration for a gain.
#include "gaitway/zmp/com_filter.hpp"

namespace gaitway::zmp {
namespace {

constexpr int kMostIterations = 20000;
constexpr double kStandstill = 1e-13;

constexpr double kFloorTime_s = 1.0;

}  // namespace

ComFilter::ComFilter(const EstimatorParameters& parameters, double omega_rad_per_s, double dt_s)
    : dt_s_(dt_s) {
  const double w2 = omega_rad_per_s * omega_rad_per_s;
  const double half = 0.5 * dt_s * dt_s;
  Eigen::Matrix3d transition;
  transition << 1.0 + w2 * half, dt_s, half, w2 * dt_s, 1.0, dt_s, 0.0, 0.0, 1.0;
  const Eigen::Vector3d from_acceleration(half, dt_s, 0.0);
  const double acceleration_variance =
      parameters.acceleration_noise_m_per_s2 * parameters.acceleration_noise_m_per_s2;
  Eigen::Matrix3d process = acceleration_variance * from_acceleration * from_acceleration.transpose();
  process(2, 2) +=
      parameters.acceleration_drift_m_per_s2_rts * parameters.acceleration_drift_m_per_s2_rts * dt_s;
  const double measurement = parameters.com_noise_m * parameters.com_noise_m;

  for (int i = 0; i < kMostIterations; ++i) {
    covariance_ = (transition * covariance_ * transition.transpose() + process).eval();
    const Eigen::Vector3d gain = covariance_.col(0) / (covariance_(0, 0) + measurement);
    covariance_ = (covariance_ - gain * covariance_.row(0)).eval();
    covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
    const double change = (gain - gain_).cwiseAbs().maxCoeff();
    gain_ = gain;
    if (change < kStandstill) break;
  }
}

void ComFilter::predict(double acceleration_m_per_s2) noexcept {
  const double acceleration = acceleration_m_per_s2 + state_[2];
  state_[0] += dt_s_ * state_[1] + 0.5 * dt_s_ * dt_s_ * acceleration;
  state_[1] += dt_s_ * acceleration;
}

void ComFilter::correct(double measured_position_m) noexcept {
  state_ += gain_ * (measured_position_m - state_[0]);
}

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
  offset_ = bounded(offset_ - gain.cwiseProduct(unexplained_m_per_s2) / (omega_rad_per_s * omega_rad_per_s));
  variance_ -= gain.cwiseProduct(variance_);
  floor_ += dt_s / (kFloorTime_s + dt_s) * (zmp_variance_m2.cwiseMin(prior_variance_) - floor_);
}

Eigen::Vector2d ComOffset::believed_of(const Eigen::Vector2d& shift_m) noexcept {
  const Eigen::Vector2d before_m = offset_;
  // A prior of zero: the description is taken for exact, and nothing gainsays what it says.
  const Eigen::Array2d unknown_share =
      (prior_variance_.array() > 0.0).select(variance_.array() / prior_variance_.array(), 1.0);
  const Eigen::Vector2d gainsaid_m = (1.0 - unknown_share) * shift_m.array();
  offset_ = bounded(offset_ + gainsaid_m);
  return shift_m - (offset_ - before_m);
}

Eigen::Vector2d ComOffset::bounded(const Eigen::Vector2d& offset_m) const noexcept {
  const Eigen::Vector2d limit = 3.0 * prior_variance_.cwiseSqrt();
  return offset_m.cwiseMax(-limit).cwiseMin(limit);
}

}  // namespace gaitway::zmp
