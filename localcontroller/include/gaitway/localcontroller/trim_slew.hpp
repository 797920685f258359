// The joint's trim: follows the commanded correction at a limited rate and fades out when none comes any more.
#pragma once

#include <cstdint>

namespace gaitway::localcontroller {

// Without a trim frame for three time slots the correction goes back to zero.
inline constexpr std::int64_t kTrimTimeout_ns = 30'000'000;

class TrimSlew {
 public:
  TrimSlew(double limit_rad, double slew_rad_per_s) noexcept : limit_rad_(limit_rad), slew_rad_per_s_(slew_rad_per_s) {}

  void command(double angle_rad, std::int64_t now_ns) noexcept {
    target_rad_ = angle_rad > limit_rad_ ? limit_rad_ : angle_rad < -limit_rad_ ? -limit_rad_ : angle_rad;
    commanded_ns_ = now_ns;
  }
  void step(std::int64_t now_ns, double period_s) noexcept {
    if (now_ns - commanded_ns_ > kTrimTimeout_ns) {
      target_rad_ = 0.0;
    }
    const double largest = slew_rad_per_s_ * period_s;
    const double wanted = target_rad_ - angle_rad_;
    const double change = wanted > largest ? largest : wanted < -largest ? -largest : wanted;
    angle_rad_ += change;
    rate_rad_per_s_ = change / period_s;
  }
  [[nodiscard]] double angle_rad() const noexcept { return angle_rad_; }
  [[nodiscard]] double rate_rad_per_s() const noexcept { return rate_rad_per_s_; }

 private:
  double limit_rad_, slew_rad_per_s_;
  double target_rad_ = 0.0, angle_rad_ = 0.0, rate_rad_per_s_ = 0.0;
  std::int64_t commanded_ns_ = 0;
};

}  // namespace gaitway::localcontroller
