// The way strayed so far, filtered, times the gain.
#include "gaitway/stability/heading_feedback.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::stability {
namespace {

constexpr double kPlanJump_rad = 0.2;  // in one tick: the plan was placed anew, the robot has not slipped

}  // namespace

HeadingFeedback::HeadingFeedback(const BalanceParameters& parameters) noexcept
    : gain_per_s_(parameters.heading_gain_per_s),
      limit_rad_per_s_(parameters.heading_limit_rad_per_s),
      filter_s_(parameters.heading_filter_s) {}

double HeadingFeedback::update(double measured_yaw_rad, double commanded_yaw_rad, bool walking) noexcept {
  const double difference = measured_yaw_rad - commanded_yaw_rad;
  if (last_difference_rad_ && std::abs(difference - *last_difference_rad_) < kPlanJump_rad) {
    strayed_rad_ += difference - *last_difference_rad_;
  }
  last_difference_rad_ = difference;
  error_rad_ += facts::kSlot_s / (filter_s_ + facts::kSlot_s) * (-strayed_rad_ - error_rad_);
  if (!walking) return 0.0;
  return std::clamp(gain_per_s_ * error_rad_, -limit_rad_per_s_, limit_rad_per_s_);
}

}  // namespace gaitway::stability
