// Low-passes and integrators, each with its limit.
#include "gaitway/stability/batch_feedback.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::stability {
namespace {

constexpr double kPlanJump_rad = 0.2;  // in one tick: the plan was placed anew, the robot has not slipped

constexpr double kFadePerTick = 0.995;  // half in 1.4 s

}  // namespace

double HeadingFeedback::update(double measured_yaw_rad, double commanded_yaw_rad, bool walking) noexcept {
  const double difference = measured_yaw_rad - commanded_yaw_rad;
  if (last_difference_rad_ && std::abs(difference - *last_difference_rad_) < kPlanJump_rad) {
    strayed_rad_ += difference - *last_difference_rad_;
  }
  last_difference_rad_ = difference;
  error_rad_ +=
      facts::kSlot_s / (parameters_.heading_filter_s + facts::kSlot_s) * (-strayed_rad_ - error_rad_);
  if (!walking) return 0.0;
  const double limit_rad_per_s = parameters_.heading_limit_rad_per_s;
  return std::clamp(parameters_.heading_gain_per_s * error_rad_, -limit_rad_per_s, limit_rad_per_s);
}

Eigen::Vector2d SpeedFeedback::update(const Eigen::Vector2d& planned_m_per_s,
                                      const Eigen::Vector2d& estimated_m_per_s, bool walking) noexcept {
  const double filter_s = parameters_.speed_filter_s, limit_m_per_s = parameters_.speed_limit_m_per_s;
  if (filter_s <= 0.0) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d slower =
      walking ? (planned_m_per_s - estimated_m_per_s).eval() : Eigen::Vector2d::Zero().eval();
  offset_m_per_s_ += facts::kSlot_s / (filter_s + facts::kSlot_s) * (slower - offset_m_per_s_);
  offset_m_per_s_ = offset_m_per_s_.cwiseMax(-limit_m_per_s).cwiseMin(limit_m_per_s);
  return offset_m_per_s_;
}

void LeanIntegrator::update(double roll_rad, double pitch_rad, bool walking) noexcept {
  const double gain_per_s = walking ? parameters_.walking_lean_gain_per_s : parameters_.lean_gain_per_s;
  const std::array<double, 2>& reference_rad = parameters_.attitude_reference_rad;
  const std::array<double, 2> lean{roll_rad - reference_rad[0], pitch_rad - reference_rad[1]};
  const double limit_rad = parameters_.lean_limit_rad;
  for (std::size_t axis = 0; axis < lean.size(); ++axis) {
    offset_rad_[axis] =
        std::clamp(offset_rad_[axis] - gain_per_s * facts::kSlot_s * lean[axis], -limit_rad, limit_rad);
  }
}

void LeanIntegrator::fade() noexcept {
  for (double& offset : offset_rad_) offset *= kFadePerTick;
}

void ComCentring::learn(const Eigen::Vector2d& com_error_m, const Eigen::Vector2d& dcm_error_m) noexcept {
  if (!com_error_m.allFinite() || !(dcm_error_m.norm() < parameters_.centring_calm_m)) return;
  const double most_m = parameters_.centring_most_m;
  offset_m_ -=
      parameters_.centring_gain_per_s * facts::kSlot_s * com_error_m.cwiseMax(-most_m).cwiseMin(most_m);
  const double limit_m = parameters_.centring_limit_m;
  offset_m_ = offset_m_.cwiseMax(-limit_m).cwiseMin(limit_m);
}

}  // namespace gaitway::stability
