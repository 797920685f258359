// The CoM's offset, learned from what the pendulum does not explain.
#include "gaitway/facts/facts.hpp"
#include "gaitway/zmp/com_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gaitway::zmp {
namespace {

using facts::kSlot_s;
constexpr double kPendulum_rad_per_s = 5.1;
const Eigen::Vector2d kDeviation_m(0.004, 0.003);
const Eigen::Vector2d kZmpVariance_m2(1e-6, 1e-6);

// A pendulum whose CoM is misplaced by `error`, walking: the limbs accelerate it to and fro.
void walk(ComOffset& offset, const Eigen::Vector2d& error, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    const double swing = 0.5 * std::sin(2.0 * M_PI * i * kSlot_s / 0.4);
    offset.update(-kPendulum_rad_per_s * kPendulum_rad_per_s * (error - offset.offset_m()) +
                      Eigen::Vector2d(swing, -swing),
                  kPendulum_rad_per_s, kZmpVariance_m2, kSlot_s);
  }
}

TEST(ComOffset, IsLearnedInSomeSecondsAndBecomesMoreCertain) {
  ComOffset offset(EstimatorParameters{}, kDeviation_m);
  EXPECT_NEAR(std::sqrt(offset.variance_m2().x()), kDeviation_m.x(), 1e-9);
  const Eigen::Vector2d error(0.006, -0.004);
  walk(offset, error, 2000);
  EXPECT_NEAR(offset.offset_m().x(), error.x(), 0.001);
  EXPECT_NEAR(offset.offset_m().y(), error.y(), 0.001);
  EXPECT_LT(offset.variance_m2().x(), 0.5 * kDeviation_m.x() * kDeviation_m.x());
  EXPECT_GT(offset.variance_m2().x(), kZmpVariance_m2.x());  // never better than the forces
}

TEST(ComOffset, APushMovesItLittle) {
  ComOffset offset(EstimatorParameters{}, kDeviation_m);
  walk(offset, Eigen::Vector2d::Zero(), 1000);
  for (int i = 0; i < 10; ++i)
    offset.update({3.0, 0.0}, kPendulum_rad_per_s, kZmpVariance_m2, kSlot_s);  // 2 N s in 0.1 s
  EXPECT_LT(offset.offset_m().norm(), 0.002);
}

TEST(ComOffset, IsLimitedToWhatADescriptionCanBeWrongBy) {
  ComOffset offset(EstimatorParameters{}, kDeviation_m);
  walk(offset, {0.1, -0.1}, 20000);
  EXPECT_NEAR(offset.offset_m().x(), 3.0 * kDeviation_m.x(), 1e-9);
  EXPECT_NEAR(offset.offset_m().y(), -3.0 * kDeviation_m.y(), 1e-9);
}

TEST(ComOffset, AShiftOfTheKinematicsIsBelievedUntilTheForcesHaveToldWhereTheCoMIs) {
  ComOffset offset(EstimatorParameters{}, kDeviation_m);
  const Eigen::Vector2d shift_m(0.002, -0.001);
  EXPECT_TRUE(offset.believed_of(shift_m).isApprox(shift_m));
  EXPECT_TRUE(offset.offset_m().isZero());
  walk(offset, Eigen::Vector2d::Zero(), 2000);
  const Eigen::Vector2d before_m = offset.offset_m();
  const Eigen::Vector2d believed_m = offset.believed_of(shift_m);
  EXPECT_LT(believed_m.norm(), 0.5 * shift_m.norm());
  EXPECT_TRUE((believed_m + offset.offset_m() - before_m).isApprox(shift_m)) << "the rest becomes offset";
}

TEST(ComOffset, WhatNoDescriptionCanBeWrongByIsBelieved) {
  ComOffset offset(EstimatorParameters{}, kDeviation_m);
  walk(offset, Eigen::Vector2d::Zero(), 2000);
  const Eigen::Vector2d believed_m = offset.believed_of({0.5, -0.5});
  EXPECT_NEAR(offset.offset_m().x(), 3.0 * kDeviation_m.x(), 1e-9);
  EXPECT_GT(believed_m.x(), 0.48);
  EXPECT_LT(believed_m.y(), -0.48);
}

TEST(ComOffset, OfADescriptionThatIsExactEveryShiftIsBelieved) {
  ComOffset offset(EstimatorParameters{}, Eigen::Vector2d::Zero());
  const Eigen::Vector2d shift_m(0.002, -0.001);
  EXPECT_EQ(offset.believed_of(shift_m), shift_m);
  EXPECT_EQ(offset.offset_m(), Eigen::Vector2d::Zero());
}

}  // namespace
}  // namespace gaitway::zmp
