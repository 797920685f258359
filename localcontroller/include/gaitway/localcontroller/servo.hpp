// The joint's position servo: proportional to the position error, damping on the velocity error, torque
// limited as the motor can give it.
#pragma once

namespace gaitway::localcontroller {

struct ServoGains {
  double stiffness_Nm_per_rad = 0.0;
  double damping_Nms_per_rad = 0.0;
  double torque_limit_Nm = 0.0;
  double speed_limit_rad_per_s = 0.0;  // the torque limit fades to zero there, in the direction of motion
};

class Servo {
 public:
  explicit Servo(const ServoGains& gains) noexcept : gains_(gains) {}

  // One servo period. Measured position from the encoder; velocity from its differences, smoothed by a
  // first-order low-pass that takes half of each new difference (time constant 1.4 periods, -3 dB at 115 Hz
  // for 1 ms): enough against quantisation, little enough for the damping.
  double step(double reference_rad, double reference_rate_rad_per_s, double measured_rad,
              double period_s) noexcept {
    if (started_) {
      velocity_rad_per_s_ += kVelocityBlend * ((measured_rad - last_rad_) / period_s - velocity_rad_per_s_);
    }
    last_rad_ = measured_rad;
    started_ = true;
    const double stiffness = gains_.stiffness_Nm_per_rad * (1.0 + compliance_ * (kCompliantStiffness - 1.0));
    const double damping = gains_.damping_Nms_per_rad * (1.0 + compliance_ * (kCompliantDamping - 1.0));
    const double wanted = share_ * (stiffness * (reference_rad - measured_rad) +
                                    damping * (reference_rate_rad_per_s - velocity_rad_per_s_));
    const bool driving = wanted * velocity_rad_per_s_ > 0.0;
    const double speed = velocity_rad_per_s_ < 0.0 ? -velocity_rad_per_s_ : velocity_rad_per_s_;
    const double fade =
        driving && gains_.speed_limit_rad_per_s > 0.0 ? 1.0 - speed / gains_.speed_limit_rad_per_s : 1.0;
    const double limit = fade > 0.0 ? share_ * gains_.torque_limit_Nm * fade : 0.0;
    saturated_ = wanted > limit || wanted < -limit;
    return wanted > limit ? limit : wanted < -limit ? -limit : wanted;
  }
  // The position that comes next has nothing to do with the last one: it is no movement.
  void forget_motion() noexcept {
    started_ = false;
    velocity_rad_per_s_ = 0.0;
  }
  // Of both gains and of the torque limit: 1 all, 0 nothing. For a joint that goes soft.
  void set_share(double share) noexcept { share_ = share; }
  // 0: the gains are those configured. 1: less stiffness and more damping, for a joint that has no movement
  // to follow and above which nobody balances the robot: it takes the sway out of it.
  void set_compliance(double compliance) noexcept { compliance_ = compliance; }
  [[nodiscard]] double velocity_rad_per_s() const noexcept { return velocity_rad_per_s_; }
  [[nodiscard]] bool saturated() const noexcept { return saturated_; }

 private:
  static constexpr double kVelocityBlend = 0.5;  // share of the newest difference
  // Of the configured gains. Measured on walks that end without SYNC: at 0.2 and 2.5 the robot is still after
  // 0.4 s in the median, at 1 and 1 after 0.7 s. The damping stays stable on a bare rotor of humanoid22.
  static constexpr double kCompliantStiffness = 0.2, kCompliantDamping = 2.5;

  ServoGains gains_;
  double last_rad_ = 0.0;
  double velocity_rad_per_s_ = 0.0;
  double share_ = 1.0;
  double compliance_ = 0.0;
  bool started_ = false;
  bool saturated_ = false;
};

}  // namespace gaitway::localcontroller
