// Learning the gyro's bias.
#include "gaitway/zmp/gyro_bias.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gaitway::zmp {
namespace {

constexpr double kTick_s = 0.010;

TEST(GyroBias, IsLearnedWhileStandingStill) {
  std::mt19937 random(23);
  std::normal_distribution<double> noise(0.0, 0.01 / std::sqrt(10.0));
  GyroBias learner{EstimatorParameters{}};
  const Eigen::Vector3d bias(0.0035, -0.002, 0.0035);  // 0.2 degrees/s
  for (int i = 0; i < 300; ++i) {
    learner.update(bias + Eigen::Vector3d(noise(random), noise(random), noise(random)), true, 0.0, kTick_s);
  }
  EXPECT_TRUE(learner.is_still());
  EXPECT_NEAR((learner.bias_rad_per_s() - bias).cwiseAbs().maxCoeff(), 0.0, 0.0007);
}

TEST(GyroBias, StaysWhileWalkingSwayingOrInTheAir) {
  GyroBias learner{EstimatorParameters{}};
  for (int i = 0; i < 500; ++i) learner.update({0.0, 0.0, 0.03}, true, 2.0, kTick_s);   // legs move
  for (int i = 0; i < 500; ++i) learner.update({0.0, 0.0, 0.3}, true, 0.0, kTick_s);    // turns
  for (int i = 0; i < 500; ++i) learner.update({0.0, 0.0, 0.03}, false, 0.0, kTick_s);  // one foot
  for (int i = 0; i < 500; ++i)
    learner.update({0.0, 0.0, 0.03}, i % 40 != 0, 0.0, kTick_s);  // never long enough
  EXPECT_FALSE(learner.is_still());
  EXPECT_EQ(learner.bias_rad_per_s(), Eigen::Vector3d::Zero());
}

TEST(GyroBias, IsLimited) {
  EstimatorParameters parameters;
  parameters.still_rate_rad_per_s = 0.2;
  GyroBias learner(parameters);
  for (int i = 0; i < 2000; ++i) learner.update({0.15, -0.15, 0.0}, true, 0.0, kTick_s);
  EXPECT_DOUBLE_EQ(learner.bias_rad_per_s().x(), parameters.bias_limit_rad_per_s);
  EXPECT_DOUBLE_EQ(learner.bias_rad_per_s().y(), -parameters.bias_limit_rad_per_s);
}

}  // namespace
}  // namespace gaitway::zmp
