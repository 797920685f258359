// The servo law.
#include "gaitway/localcontroller/servo.hpp"

namespace gaitway::localcontroller {
namespace {

constexpr double kVelocityBlend = 0.5;  // share of the newest difference

}  // namespace

double Servo::step(double reference_rad, double reference_rate_rad_per_s, double measured_rad,
                   double period_s) noexcept {
  if (started_) {
    velocity_rad_per_s_ += kVelocityBlend * ((measured_rad - last_rad_) / period_s - velocity_rad_per_s_);
  }
  last_rad_ = measured_rad;
  started_ = true;
  const double wanted =
      share_ * (gains_.stiffness_Nm_per_rad * (reference_rad - measured_rad) +
                gains_.damping_Nms_per_rad * (reference_rate_rad_per_s - velocity_rad_per_s_));
  const bool driving = wanted * velocity_rad_per_s_ > 0.0;
  const double speed = velocity_rad_per_s_ < 0.0 ? -velocity_rad_per_s_ : velocity_rad_per_s_;
  const double fade =
      driving && gains_.speed_limit_rad_per_s > 0.0 ? 1.0 - speed / gains_.speed_limit_rad_per_s : 1.0;
  const double limit = fade > 0.0 ? share_ * gains_.torque_limit_Nm * fade : 0.0;
  saturated_ = wanted > limit || wanted < -limit;
  return wanted > limit ? limit : wanted < -limit ? -limit : wanted;
}

}  // namespace gaitway::localcontroller
