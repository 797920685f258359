// Attitude from gyro and tilt.
#include "gaitway/zmp/attitude_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gaitway::zmp {
namespace {

constexpr double kTick_s = 0.010;

// Roll, pitch, yaw with R = Rz Ry Rx.
Eigen::Vector3d euler_of(const Eigen::Matrix3d& r) {
  return {std::atan2(r(2, 1), r(2, 2)), std::asin(-r(2, 0)), std::atan2(r(1, 0), r(0, 0))};
}

TEST(AttitudeFilter, TakesTheFirstMeasuredTiltAndDrawsToLaterOnes) {
  AttitudeFilter filter(0.5);
  filter.update(Eigen::Vector3d::Zero(), Eigen::Vector2d(0.1, -0.05), kTick_s);
  EXPECT_DOUBLE_EQ(filter.attitude().roll_rad, 0.1);
  EXPECT_DOUBLE_EQ(filter.attitude().pitch_rad, -0.05);
  for (int i = 0; i < 50; ++i) filter.update(Eigen::Vector3d::Zero(), Eigen::Vector2d(0.0, 0.0), kTick_s);
  EXPECT_NEAR(filter.attitude().roll_rad, 0.1 * std::exp(-1.0), 0.002);  // one time constant
  for (int i = 0; i < 500; ++i) filter.update(Eigen::Vector3d::Zero(), Eigen::Vector2d(0.0, 0.0), kTick_s);
  EXPECT_NEAR(filter.attitude().roll_rad, 0.0, 1e-5);
  EXPECT_NEAR(filter.attitude().pitch_rad, 0.0, 1e-5);
}

TEST(AttitudeFilter, IntegratesTurnsInSpaceWithoutMeasuredTilt) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> phase(0.0, 6.28);
  for (int run = 0; run < 20; ++run) {
    AttitudeFilter filter(0.5);
    Eigen::Matrix3d truth = Eigen::Matrix3d::Identity();
    const Eigen::Vector3d start(phase(random), phase(random), phase(random));
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d rate =
          ((start.array() + 0.07 * i).sin() * Eigen::Array3d(0.8, 0.6, 1.0)).matrix();
      truth = truth * Eigen::AngleAxisd(rate.norm() * kTick_s, rate.normalized());
      filter.update(rate, std::nullopt, kTick_s);
    }
    const Eigen::Vector3d expected = euler_of(truth);
    EXPECT_NEAR(filter.attitude().roll_rad, expected.x(), 0.01);
    EXPECT_NEAR(filter.attitude().pitch_rad, expected.y(), 0.01);
    EXPECT_NEAR(std::remainder(filter.attitude().yaw_rad - expected.z(), 2.0 * M_PI), 0.0, 0.01);
  }
}

TEST(AttitudeFilter, GyroBiasTiltsItByNoMoreThanBiasTimesTimeConstant) {
  AttitudeFilter filter(0.5);
  const Eigen::Vector3d bias(0.01, -0.02, 0.0);
  for (int i = 0; i < 2000; ++i) filter.update(bias, Eigen::Vector2d(0.0, 0.0), kTick_s);
  EXPECT_NEAR(filter.attitude().roll_rad, 0.005, 2e-4);
  EXPECT_NEAR(filter.attitude().pitch_rad, -0.010, 4e-4);
}

TEST(AttitudeFilter, FollowsASwayWithinATenthOfADegreeDespiteNoise) {
  std::mt19937 random(17);
  std::normal_distribution<double> gyro(0.0, 0.01 / std::sqrt(10.0)), tilt(0.0, 0.003);
  AttitudeFilter filter(0.5);
  double squares = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double t = i * kTick_s;
    const Eigen::Vector2d truth(0.05 * std::sin(8.0 * t), 0.03 * std::sin(5.0 * t));
    // the mean rate over the slot, as the sensor's filter gives it
    const Eigen::Vector2d before(0.05 * std::sin(8.0 * (t - kTick_s)), 0.03 * std::sin(5.0 * (t - kTick_s)));
    const Eigen::Vector2d rate = (truth - before) / kTick_s;
    filter.update({rate.x() + gyro(random), rate.y() + gyro(random), 0.0},
                  Eigen::Vector2d(truth.x() + tilt(random), truth.y() + tilt(random)), kTick_s);
    if (i < 200) continue;
    const Eigen::Vector2d error(filter.attitude().roll_rad - truth.x(),
                                filter.attitude().pitch_rad - truth.y());
    squares += error.squaredNorm() / 2.0;
  }
  EXPECT_LT(std::sqrt(squares / 1800.0), 0.1 * M_PI / 180.0);
}

TEST(AttitudeFilter, YawGoesOnBeyondATurn) {
  AttitudeFilter filter(0.5);
  for (int i = 0; i < 1000; ++i) filter.update({0.0, 0.0, 1.0}, Eigen::Vector2d(0.0, 0.0), kTick_s);
  EXPECT_NEAR(filter.attitude().yaw_rad, 10.0, 1e-9);
}

TEST(TiltOfAcceleration, InvertsTheGravityThatATiltedTrunkFeels) {
  std::mt19937 random(19);
  std::uniform_real_distribution<double> angle(-0.5, 0.5);
  for (int i = 0; i < 500; ++i) {
    Attitude attitude;
    attitude.roll_rad = angle(random);
    attitude.pitch_rad = angle(random);
    const auto tilt =
        tilt_of_acceleration(attitude.tilt().transpose() * Eigen::Vector3d(0.0, 0.0, 9.81), 1.0);
    ASSERT_TRUE(tilt);
    EXPECT_NEAR(tilt->x(), attitude.roll_rad, 1e-12);
    EXPECT_NEAR(tilt->y(), attitude.pitch_rad, 1e-12);
  }
}

TEST(TiltOfAcceleration, SaysNothingWhileTheTrunkIsAccelerated) {
  EXPECT_FALSE(tilt_of_acceleration({0.0, 0.0, 12.0}, 1.0));
  EXPECT_FALSE(tilt_of_acceleration({0.0, 0.0, 0.3}, 1.0));
  EXPECT_FALSE(tilt_of_acceleration({std::nan(""), 0.0, 9.81}, 1.0));
}

}  // namespace
}  // namespace gaitway::zmp
