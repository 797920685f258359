// By how much a body will be off its plan when the next batch begins.
#include "gaitway/trajectory/divergence_feedback.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/footstep_planner.hpp"

namespace gaitway::trajectory {
namespace {

constexpr std::int64_t kCycle_ns = 80'000'000, kPoint_ns = 10'000'000;

class Deviation : public ::testing::Test {
 protected:
  // A plan that stands still: CoM and ZMP at (0.01, 0), feet beside.
  Deviation() {
    plan->start_ns = kCycle_ns;
    for (std::size_t i = 0; i < kBatchPoints; ++i) {
      plan->com[i][0] = plan->zmp[i][0] = 0.01;
      plan->hip_height[i] = parameters.hip_height_m;
      plan->foot_position[i][0][1] = 0.05;
      plan->foot_position[i][1][1] = -0.05;
      plan->foot_yaw[i][0] = plan->foot_yaw[i][1] = 0.3;
    }
    feedback.take(*plan);
    estimate->support = 1;
    estimate->stamp_ns = start_ns - 20'000'000;
    see({0.01, 0.0}, {0.01, 0.0});
  }
  // In the plan's frame; the estimate has it in the right foot's.
  void see(const Eigen::Vector2d& dcm, const Eigen::Vector2d& zmp) {
    const Pose2 foot{0.0, -0.05, 0.3};
    const Pose2 d = foot.relative_of({dcm.x(), dcm.y(), 0.0}), z = foot.relative_of({zmp.x(), zmp.y(), 0.0});
    estimate->dcm[0] = d.x_m;
    estimate->dcm[1] = d.y_m;
    estimate->zmp[0] = z.x_m;
    estimate->zmp[1] = z.y_m;
  }

  GaitParameters parameters;
  double omega_per_s = std::sqrt(facts::kGravity_m_per_s2 / parameters.com_height_m);
  DivergenceFeedback feedback{parameters};
  std::unique_ptr<MotionPlan> plan = std::make_unique<MotionPlan>();
  std::unique_ptr<Estimate> estimate = std::make_unique<Estimate>();
  std::int64_t start_ns = 2 * kCycle_ns;
};

TEST_F(Deviation, IsNothingForABodyOnItsPlan) {
  EXPECT_LT(feedback.deviation_m(*estimate, start_ns).norm(), 1e-12);
}

TEST_F(Deviation, GrowsAwayFromTheZmpUntilTheBatchBegins) {
  see({0.03, -0.01}, {0.01, 0.0});
  const double growth = std::exp(omega_per_s * 0.020);
  const Eigen::Vector2d deviation = feedback.deviation_m(*estimate, start_ns);
  EXPECT_NEAR(deviation.x(), 0.02 * growth, 1e-12);
  EXPECT_NEAR(deviation.y(), -0.01 * growth, 1e-12);
  see({0.03, -0.01}, {0.03, -0.01});  // a ZMP below it holds it where it is
  EXPECT_LT((feedback.deviation_m(*estimate, start_ns) - Eigen::Vector2d(0.02, -0.01)).norm(), 1e-12);
}

// The estimate's pendulum is as high as the body is.
TEST_F(Deviation, IsNothingForABodyOnItsPlanWithLowHips) {
  constexpr double kLower_m = 0.05, kSpeed_m_per_s = 0.5;
  for (std::size_t i = 0; i < kBatchPoints; ++i) {
    plan->hip_height[i] = parameters.hip_height_m - kLower_m;
    plan->com_velocity[i][0] = kSpeed_m_per_s;
  }
  DivergenceFeedback low{parameters};
  low.take(*plan);
  const double low_omega_per_s = std::sqrt(facts::kGravity_m_per_s2 / (parameters.com_height_m - kLower_m));
  see({0.01 + kSpeed_m_per_s / low_omega_per_s, 0.0}, {0.01, 0.0});
  EXPECT_LT(low.deviation_m(*estimate, start_ns).norm(), 1e-12);
}

TEST_F(Deviation, ABatchThatIsPlannedAnewTakesItsOwnPlace) {
  for (std::size_t i = 0; i < kBatchPoints; ++i) plan->com[i][0] = plan->zmp[i][0] = 0.03;
  feedback.take(*plan);
  see({0.03, 0.0}, {0.03, 0.0});
  EXPECT_LT(feedback.deviation_m(*estimate, start_ns).norm(), 1e-12);
}

TEST_F(Deviation, WhatThePlanHasAnsweredSinceTheEstimateIsOffNoMore) {
  see({0.03, 0.0}, {0.01, 0.0});
  const Eigen::Vector2d before = feedback.deviation_m(*estimate, start_ns);
  feedback.answered({0.01, 0.0}, start_ns - 80'000'000);
  EXPECT_EQ(feedback.deviation_m(*estimate, start_ns), before) << "the estimate has seen it";
  feedback.answered({0.01, 0.0}, start_ns - 10'000'000);
  const Eigen::Vector2d after = feedback.deviation_m(*estimate, start_ns);
  EXPECT_NEAR(after.x(), before.x() - 0.01 * std::exp(omega_per_s * 0.010), 1e-12);
}

TEST_F(Deviation, IsNothingThatCanBeActedOnWithoutAFreshUprightFiniteEstimate) {
  const auto expect_none = [&](const char* why) {
    EXPECT_EQ(feedback.deviation_m(*estimate, start_ns), Eigen::Vector2d::Zero()) << why;
    see({0.05, 0.0}, {0.01, 0.0});
    estimate->support = 1;
    estimate->fall = 0;
    estimate->stamp_ns = start_ns - 20'000'000;
    ASSERT_GT(feedback.deviation_m(*estimate, start_ns).norm(), 0.03);
  };
  see({0.05, 0.0}, {0.01, 0.0});
  estimate->stamp_ns = start_ns - 70'000'000;
  expect_none("too old");
  estimate->stamp_ns = start_ns + kPoint_ns;
  expect_none("of the future");
  estimate->fall = 1;
  expect_none("falls");
  estimate->support = 7;
  expect_none("no such foot");
  estimate->dcm[0] = std::numeric_limits<double>::quiet_NaN();
  expect_none("not a number");
  EXPECT_EQ(DivergenceFeedback(parameters).deviation_m(*estimate, start_ns), Eigen::Vector2d::Zero())
      << "no plan";
}

}  // namespace
}  // namespace gaitway::trajectory
