// The way strayed so far, filtered, times the gain.
#include "gaitway/stability/heading_feedback.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::stability {
namespace {

constexpr double kPlanJump_rad = 0.2;  // in one tick: the plan was placed anew, the robot has not slipped

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

}  // namespace gaitway::stability
