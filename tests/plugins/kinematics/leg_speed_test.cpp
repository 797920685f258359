// References keep within what the legs' joints can do: a point that asks for a little more is followed later,
// one that asks for much more is left to be refused.
#include "gaitway/kinematics/leg_speed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>

#include "gaitway/facts/facts.hpp"
#include "gaitway/kinematics/batch_solver.hpp"
#include "walking_plan.hpp"

namespace gaitway::kinematics {
namespace {

class LegSpeedTest : public ::testing::Test {
 protected:
  static constexpr int kPoints = 60;

  // The right knee goes to and fro by so much within 0.4 s: fastest in the middle.
  [[nodiscard]] double asked_rad(int point, double way_rad) const {
    return 0.5 * way_rad * (1.0 - std::cos(2.0 * std::numbers::pi * std::min(point, 40) / 40.0));
  }
  void ask(double way_rad) {
    for (int point = 0; point < kPoints; ++point)
      plan_->position[point][knee_] = static_cast<float>(asked_rad(point, way_rad));
  }
  [[nodiscard]] double way_within_speed_rad() const { return most_rad_ * 40.0 / std::numbers::pi; }
  [[nodiscard]] double fastest_rad(double start_rad = 0.0) const {
    double fastest = 0.0, before = start_rad;
    for (int point = 0; point < kPoints; ++point) {
      const double now = plan_->position[point][knee_];
      fastest = std::max(fastest, std::abs(now - before));
      before = now;
    }
    return fastest;
  }

  urdf::RobotModel robot_ = urdf::load_robot(GAITWAY_HUMANOID22_DIRECTORY);
  LegSpeed speed_{robot_};
  int knee_ = robot_.legs[1].joints[3];
  double most_rad_ = robot_.joints[static_cast<std::size_t>(knee_)].velocity_limit_rad_per_s * facts::kSlot_s;
  std::unique_ptr<JointPlan> plan_ = std::make_unique<JointPlan>();
};

TEST_F(LegSpeedTest, WhatIsWithinTheLimitsStaysAsItIs) {
  const double way_rad = 0.99 * way_within_speed_rad();
  ask(way_rad);
  speed_.keep(*plan_, kPoints, nullptr);
  for (int point = 0; point < kPoints; ++point)
    ASSERT_FLOAT_EQ(plan_->position[point][knee_], static_cast<float>(asked_rad(point, way_rad))) << point;
}

TEST_F(LegSpeedTest, ALittleMoreIsFollowedLaterAndArrives) {
  const double way_rad = 1.1 * way_within_speed_rad();
  ask(way_rad);
  ASSERT_GT(fastest_rad(), 1.05 * most_rad_);
  speed_.keep(*plan_, kPoints, nullptr);
  EXPECT_LE(fastest_rad(), most_rad_ + 1e-6);
  double behind_rad = 0.0;
  for (int point = 0; point < kPoints; ++point)
    behind_rad = std::max(behind_rad, std::abs(plan_->position[point][knee_] - asked_rad(point, way_rad)));
  EXPECT_GT(behind_rad, 0.0);
  EXPECT_LE(behind_rad, LegSpeed::kMostBehind_rad);
  EXPECT_NEAR(plan_->position[kPoints - 1][knee_], asked_rad(kPoints - 1, way_rad), 1e-6);
}

TEST_F(LegSpeedTest, GoesOnFromWhereTheLastBatchEnded) {
  ask(0.0);
  LegAngles start_rad{};
  start_rad[1][3] = 1.5 * most_rad_;
  speed_.keep(*plan_, kPoints, &start_rad);
  EXPECT_NEAR(plan_->position[0][knee_], 0.5 * most_rad_, 1e-6);
  EXPECT_NEAR(plan_->position[1][knee_], 0.0, 1e-6);
}

// It is for the check of the batch to say so.
TEST_F(LegSpeedTest, MuchMoreIsLeftToBeRefused) {
  ask(0.0);
  for (int point = 10; point < kPoints; ++point)
    plan_->position[point][knee_] = static_cast<float>(most_rad_ + 1.1 * LegSpeed::kMostBehind_rad);
  speed_.keep(*plan_, kPoints, nullptr);
  EXPECT_GT(fastest_rad(), most_rad_ + LegSpeed::kMostBehind_rad);
}

TEST_F(LegSpeedTest, NotANumberIsLeftToBeRefused) {
  ask(0.0);
  plan_->position[5][knee_] = std::nanf("");
  speed_.keep(*plan_, kPoints, nullptr);
  EXPECT_TRUE(std::isnan(plan_->position[5][knee_]));
}

// A walk whose knees are a little too slow for it: no point of any batch, nor from one batch to the next, is
// too fast.
TEST_F(LegSpeedTest, BatchesOfAWalkKeepWithinSlowKnees) {
  constexpr double kSlow_rad_per_s = 4.2;
  for (const urdf::Leg& leg : robot_.legs)
    robot_.joints[static_cast<std::size_t>(leg.joints[3])].velocity_limit_rad_per_s = kSlow_rad_per_s;
  BatchSolver solver(robot_, SolverChoice::automatic);
  const test::WalkingPlan walk(0.25, 0.0);
  double before_rad = 0.0, fastest_rad = 0.0;
  for (std::uint32_t sequence = 1; sequence <= 40; ++sequence) {
    const MotionPlan plan = walk.batch(sequence);
    const BatchOutcome outcome = solver.solve(plan, {}, *plan_);
    ASSERT_TRUE(outcome.solved()) << solver.describe(outcome);
    for (int point = 0; point < kBatchPoints; ++point) {
      const double now_rad = plan_->position[point][knee_];
      if (sequence > 1 || point > 0) fastest_rad = std::max(fastest_rad, std::abs(now_rad - before_rad));
      before_rad = now_rad;
    }
  }
  EXPECT_LE(fastest_rad, kSlow_rad_per_s * facts::kSlot_s + 1e-6);
  EXPECT_GT(fastest_rad, 0.99 * kSlow_rad_per_s * facts::kSlot_s) << "it was never asked for more";
}

}  // namespace
}  // namespace gaitway::kinematics
