// The servo law: its torque limits, and that it is stable on the inertias that a small humanoid's joints see.
#include "gaitway/localcontroller/servo.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gaitway::localcontroller {
namespace {

constexpr double kPeriod_s = 0.001;
constexpr ServoGains kGains{.stiffness_Nm_per_rad = 300.0,
                            .damping_Nms_per_rad = 4.0,
                            .torque_limit_Nm = 8.0,
                            .speed_limit_rad_per_s = 8.0};

// Lets the servo see a joint at `speed` until its smoothed velocity has settled; the position error stays.
double torque_at(double speed_rad_per_s, double error_rad) {
  Servo servo(kGains);
  double torque = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double position = speed_rad_per_s * kPeriod_s * i;
    torque = servo.step(position + error_rad, speed_rad_per_s, position, kPeriod_s);
  }
  return torque;
}

TEST(Servo, IsProportionalToErrorWithinItsLimit) {
  EXPECT_NEAR(torque_at(0.0, 0.01), 3.0, 1e-9);
  EXPECT_NEAR(torque_at(0.0, -0.02), -6.0, 1e-9);
  EXPECT_NEAR(torque_at(0.0, 1.0), 8.0, 1e-9);
}

TEST(Servo, DrivingTorqueFadesToZeroAtTheSpeedLimitAndBrakingDoesNot) {
  for (const double speed : {0.0, 2.0, 4.0, 6.0, 8.0, 12.0}) {
    const double faded = 8.0 * std::max(0.0, 1.0 - speed / 8.0);
    EXPECT_NEAR(torque_at(speed, 1.0), faded, 1e-6) << speed;
    EXPECT_NEAR(torque_at(-speed, -1.0), -faded, 1e-6) << speed;
    EXPECT_NEAR(torque_at(speed, -1.0), -8.0, 1e-6) << speed;
    EXPECT_NEAR(torque_at(-speed, 1.0), 8.0, 1e-6) << speed;
  }
}

// How far the inertia gets, and how far from `target_rad` it still is after 1 s. An encoder of 4096 lines a
// turn, quadrature; the physics run at 0.1 ms.
constexpr double kEncoderCount_rad = 6.283185307179586 / 16384.0;
struct Step {
  double largest_rad = 0.0, last_error_rad = 0.0;
};
Step play_step(Servo& servo, double target_rad, double inertia_kgm2) {
  Step step;
  double position = 0.0, speed = 0.0;
  for (int ms = 0; ms < 1500; ++ms) {
    const double torque =
        servo.step(target_rad, 0.0, std::floor(position / kEncoderCount_rad) * kEncoderCount_rad, kPeriod_s);
    for (int i = 0; i < 10; ++i) {
      speed += (torque - 0.15 * speed) / inertia_kgm2 * kPeriod_s / 10;
      position += speed * kPeriod_s / 10;
    }
    step.largest_rad = std::max(step.largest_rad, position);
    if (ms >= 1000) {
      step.last_error_rad = std::max(step.last_error_rad, std::abs(position - target_rad));
    }
  }
  return step;
}

class ServoOnInertia : public testing::TestWithParam<double> {};

TEST_P(ServoOnInertia, SettlesOnAStepAndStaysQuiet) {
  const double inertia_kgm2 = GetParam();
  Servo servo(kGains);
  const Step step = play_step(servo, 0.02, inertia_kgm2);
  const double damping_ratio = 4.15 / (2.0 * std::sqrt(300.0 * inertia_kgm2));
  const double overshoot =
      damping_ratio < 1.0
          ? std::exp(-3.141592653589793 * damping_ratio / std::sqrt(1.0 - damping_ratio * damping_ratio))
          : 0.0;
  EXPECT_LT(step.largest_rad, 0.02 * (1.15 + overshoot))
      << "more than a continuous servo would overshoot, and 15 %";
  EXPECT_LT(step.last_error_rad, 2.0 * kEncoderCount_rad);
}

TEST_P(ServoOnInertia, HoldsCompliantlyWithoutRinging) {
  Servo servo(kGains);
  servo.set_compliance(1.0);
  const Step step = play_step(servo, 0.02, GetParam());
  EXPECT_LT(step.largest_rad, 0.02 + kEncoderCount_rad) << "it is damped more than it is stiff";
  EXPECT_LT(step.last_error_rad, 2.0 * kEncoderCount_rad);
}

INSTANTIATE_TEST_SUITE_P(Inertias_kgm2, ServoOnInertia, testing::Values(0.01, 0.02, 0.05, 0.1));

}  // namespace
}  // namespace gaitway::localcontroller
