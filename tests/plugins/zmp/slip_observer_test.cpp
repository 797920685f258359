// Slip of a foot from the acceleration of its sole.
#include "gaitway/facts/facts.hpp"
#include "gaitway/zmp/foot_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gaitway::zmp {
namespace {

using facts::kSlot_s;

TEST(SlipObserver, FootThatStandsOnAnUnknownTiltDoesNotSlip) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.15 / std::sqrt(10.0));
  SlipObserver slip{EstimatorParameters{}};
  double squares = 0.0;
  for (int i = 0; i < 2000; ++i) {
    slip.update(true, {0.1 + noise(random), -0.05 + noise(random)}, kSlot_s);
    if (i >= 1000) squares += std::pow(slip.speed_m_per_s(), 2) / 1000.0;
  }
  EXPECT_LT(std::sqrt(squares), 0.004);
}

TEST(SlipObserver, ASlipShowsWithItsSpeedAndEnds) {
  SlipObserver slip{EstimatorParameters{}};
  for (int i = 0; i < 100; ++i) slip.update(true, {0.0, 0.0}, kSlot_s);
  for (int i = 0; i < 3; ++i) slip.update(true, {4.0, 3.0}, kSlot_s);  // to 0.15 m/s
  EXPECT_NEAR(slip.speed_m_per_s(), 0.15, 0.03);
  for (int i = 0; i < 3; ++i) slip.update(true, {-4.0, -3.0}, kSlot_s);
  EXPECT_LT(slip.speed_m_per_s(), 0.04);
  for (int i = 0; i < 60; ++i) slip.update(true, {0.0, 0.0}, kSlot_s);
  EXPECT_LT(slip.speed_m_per_s(), 0.005);
}

TEST(SlipObserver, FootInTheAirAndTheStrikeOfTouchdownAreNoSlip) {
  SlipObserver slip{EstimatorParameters{}};
  for (int i = 0; i < 50; ++i) {
    slip.update(false, {20.0, 0.0}, kSlot_s);
    EXPECT_EQ(slip.speed_m_per_s(), 0.0);
  }
  slip.update(true, {-50.0, 10.0}, kSlot_s);
  EXPECT_EQ(slip.speed_m_per_s(), 0.0);
  for (int i = 0; i < 10; ++i) slip.update(true, {0.0, 0.0}, kSlot_s);
  EXPECT_LT(slip.speed_m_per_s(), 0.001);
}

}  // namespace
}  // namespace gaitway::zmp
