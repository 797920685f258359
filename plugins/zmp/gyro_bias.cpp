// Stillness first, then a running mean.
#include "gaitway/zmp/gyro_bias.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::zmp {

GyroBias::GyroBias(const EstimatorParameters& parameters) noexcept
    : still_rate_(parameters.still_rate_rad_per_s),
      still_joint_rate_(parameters.still_joint_rate_rad_per_s),
      still_time_s_(parameters.still_time_s),
      time_constant_s_(parameters.bias_time_constant_s),
      limit_(parameters.bias_limit_rad_per_s) {}

void GyroBias::update(const Eigen::Vector3d& gyro_rad_per_s, bool planted, double joint_rate_rad_per_s,
                      double dt_s) noexcept {
  const bool still = planted && std::abs(joint_rate_rad_per_s) <= still_joint_rate_ &&
                     (gyro_rad_per_s - bias_).cwiseAbs().maxCoeff() <= still_rate_;
  still_s_ = still ? still_s_ + dt_s : 0.0;
  if (!is_still()) return;
  learned_s_ = std::min(learned_s_ + dt_s, time_constant_s_);
  bias_ += std::min(dt_s / learned_s_, 1.0) * (gyro_rad_per_s - bias_);
  bias_ = bias_.cwiseMax(-limit_).cwiseMin(limit_);
}

}  // namespace gaitway::zmp
