// Prediction by the way and the turn since the last estimate, correction with scalar gains.
#include "gaitway/navigation/pose_filter.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::navigation {
namespace {

constexpr double kStrange = 5.0;                   // standard deviations
constexpr double kNear_m = 0.10, kNear_rad = 0.2;  // what is so near is never strange

double square(double value) noexcept {
  return value * value;
}

}  // namespace

PoseFilter::PoseFilter(const planning::Pose& start, const PoseFilterParameters& parameters) noexcept
    : parameters_(parameters),
      odometry_(start),
      variance_m2_(square(parameters.start_deviation_m)),
      variance_rad2_(square(parameters.start_deviation_rad)) {}

double PoseFilter::deviation_m() const noexcept {
  return std::sqrt(variance_m2_);
}

double PoseFilter::deviation_rad() const noexcept {
  return std::sqrt(variance_rad2_);
}

void PoseFilter::predict(std::int64_t stamp_ns, const planning::Pose& base) noexcept {
  if (count_ > 0) {
    const Moment& last = moments_[(count_ - 1) % kRemembered];
    if (stamp_ns <= last.stamp_ns) return;
    const double way_m = planning::way_m(last.base, base), turn_rad = planning::turn_rad(last.base, base);
    variance_m2_ += square(parameters_.way_drift_m) * way_m;
    variance_rad2_ +=
        square(parameters_.way_drift_rad) * way_m + square(parameters_.turn_drift_rad) * turn_rad;
  }
  moments_[count_++ % kRemembered] = {stamp_ns, base};
}

// The newest one that is not younger by more than a time slot.
const PoseFilter::Moment* PoseFilter::at(std::int64_t stamp_ns) const noexcept {
  const std::size_t known = std::min(count_, kRemembered);
  const Moment* found = nullptr;
  for (std::size_t back = 1; back <= known; ++back) {
    const Moment& moment = moments_[(count_ - back) % kRemembered];
    found = &moment;
    if (moment.stamp_ns <= stamp_ns) return found;
  }
  constexpr std::int64_t kSlot_ns = 10'000'000;
  return found != nullptr && found->stamp_ns - stamp_ns <= kSlot_ns ? found : nullptr;
}

bool PoseFilter::correct(std::int64_t stamp_ns, const planning::Pose& base_in_world, double deviation_m,
                         double deviation_rad) noexcept {
  const Moment* const moment = at(stamp_ns);
  const bool usable = moment != nullptr && deviation_m > 0.0 && deviation_rad > 0.0 &&
                      std::isfinite(base_in_world.x_m + base_in_world.y_m + base_in_world.yaw_rad +
                                    deviation_m + deviation_rad);
  if (!usable) return false;
  const planning::Pose expected = odometry_.compose(moment->base);
  const double x_m = base_in_world.x_m - expected.x_m, y_m = base_in_world.y_m - expected.y_m;
  const double yaw_rad = planning::wrapped(base_in_world.yaw_rad - expected.yaw_rad);
  double variance_m2 = variance_m2_ + square(deviation_m),
         variance_rad2 = variance_rad2_ + square(deviation_rad);
  const bool strange = std::hypot(x_m, y_m) > std::max(kStrange * std::sqrt(variance_m2), kNear_m) ||
                       std::abs(yaw_rad) > std::max(kStrange * std::sqrt(variance_rad2), kNear_rad);
  strange_ = strange ? strange_ + 1 : 0;
  if (strange && strange_ < kInsistent) return false;
  if (strange) {  // it knows nothing any more but what it is told
    variance_m2_ = variance_m2 = square(x_m) + square(y_m) + square(deviation_m);
    variance_rad2_ = variance_rad2 = square(yaw_rad) + square(deviation_rad);
  }
  const double gain = variance_m2_ / variance_m2, turn_gain = variance_rad2_ / variance_rad2;
  const planning::Pose base{expected.x_m + gain * x_m, expected.y_m + gain * y_m,
                            expected.yaw_rad + turn_gain * yaw_rad};
  // odometry · moment->base = base
  const planning::Pose back = moment->base.relative_of({});
  odometry_ = base.compose(back);
  odometry_.yaw_rad = planning::wrapped(odometry_.yaw_rad);
  variance_m2_ *= 1.0 - gain;
  variance_rad2_ *= 1.0 - turn_gain;
  return true;
}

}  // namespace gaitway::navigation
