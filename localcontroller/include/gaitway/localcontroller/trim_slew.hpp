// The joint's trim: goes to each commanded correction evenly over one time slot, at a limited rate, and fades
// out when none comes any more. Even, because the servo feeds the rate forward: a step would kick the joint.
#pragma once

#include <cstdint>

#include "gaitway/facts/facts.hpp"

namespace gaitway::localcontroller {

// Without a trim frame for three time slots the correction goes back to zero.
inline constexpr std::int64_t kTrimTimeout_ns = 3 * facts::kSlot_ns;
inline constexpr double kTrimInterval_s = facts::kSlot_s;  // between two trim frames

class TrimSlew {
 public:
  TrimSlew(double limit_rad, double slew_rad_per_s) noexcept
      : limit_rad_(limit_rad), slew_rad_per_s_(slew_rad_per_s) {}

  void command(double angle_rad, std::int64_t now_ns) noexcept {
    if (frozen_) {
      return;
    }
    commanded_ns_ = now_ns;
    head_for(limited(angle_rad, limit_rad_));
  }
  // Stays where it is, whatever comes.
  void freeze() noexcept {
    frozen_ = true;
    pace_rad_per_s_ = 0.0;
  }
  void step(std::int64_t now_ns, double period_s) noexcept {
    if (!frozen_ && now_ns - commanded_ns_ > kTrimTimeout_ns && target_rad_ != 0.0) {
      head_for(0.0);
    }
    const double change = limited(target_rad_ - angle_rad_, pace_rad_per_s_ * period_s);
    angle_rad_ += change;
    rate_rad_per_s_ = change / period_s;
  }
  [[nodiscard]] double angle_rad() const noexcept { return angle_rad_; }
  [[nodiscard]] double rate_rad_per_s() const noexcept { return rate_rad_per_s_; }

 private:
  static double limited(double value, double largest) noexcept {
    return value > largest ? largest : value < -largest ? -largest : value;
  }
  void head_for(double target_rad) noexcept {
    target_rad_ = target_rad;
    const double way_rad = target_rad_ > angle_rad_ ? target_rad_ - angle_rad_ : angle_rad_ - target_rad_;
    pace_rad_per_s_ = limited(way_rad / kTrimInterval_s, slew_rad_per_s_);
  }

  double limit_rad_, slew_rad_per_s_;
  double target_rad_ = 0.0, angle_rad_ = 0.0;
  double pace_rad_per_s_ = 0.0;  // at which the target is approached
  double rate_rad_per_s_ = 0.0;  // of the last step
  std::int64_t commanded_ns_ = 0;
  bool frozen_ = false;
};

}  // namespace gaitway::localcontroller
