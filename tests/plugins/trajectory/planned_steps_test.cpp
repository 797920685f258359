// Footsteps in place of a velocity: the feet go where they are planned, in the order of their numbers, and
// what cannot be followed is not.
#include "gaitway/trajectory/planned_steps.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <optional>

#include "planned_walk.hpp"

namespace gaitway::trajectory {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Odometry that lies elsewhere than the frame `plan`.
const Pose2 kPlanInOdometry{3.0, -1.0, 2.5};

class FollowedSteps : public PlannedWalk {
 protected:
  FollowedSteps() { steps.valid_until_ns = 1'000'000'000'000; }
  // What a robot that walks exactly as planned measures.
  [[nodiscard]] Estimate measured() const {
    Estimate estimate{};
    for (std::size_t side = 0; side < 2; ++side) {
      const Pose2 pose = kPlanInOdometry.compose(pattern.state().feet[side]);
      estimate.odometry_foot[side][0] = pose.x_m;
      estimate.odometry_foot[side][1] = pose.y_m;
      estimate.odometry_foot[side][2] = pose.yaw_rad;
    }
    return estimate;
  }
  // In the frame `plan`.
  void add(Side side, const Pose2& place) {
    const Pose2 pose = kPlanInOdometry.compose(place);
    steps.side[steps.step_count] = static_cast<std::uint32_t>(side);
    steps.step[steps.step_count][0] = pose.x_m;
    steps.step[steps.step_count][1] = pose.y_m;
    steps.step[steps.step_count][2] = pose.yaw_rad;
    ++steps.step_count;
  }
  void plan_straight(std::uint32_t count, double step_m) {
    const double half = 0.5 * parameters.foot_spacing_m;
    for (std::uint32_t i = 0; i < count; ++i) {
      const Side side = i % 2 == 0 ? Side::left : Side::right;
      const double x_m = step_m * (i + 1 == count ? i : i + 1);
      add(side, {x_m, sign_of(side) * half, 0.0});
    }
    steps.first = 1;
    steps.ends = 1;
  }
  void follow(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      ++sequence;
      const Estimate estimate = measured();
      pattern.plan(sequence, sequence * kCycle_ns, command, correction, *plan, Eigen::Vector2d::Zero(),
                   planned_steps(steps, estimate, pattern.state(), sequence * kCycle_ns));
      if (pattern.state().landed != landed) {
        landed = pattern.state().landed;
        const std::size_t i_landed = landed - steps.first;
        if (i_landed < steps.step_count) placed.push_back(error_of(i_landed));
      }
    }
  }
  // Of the foot that has just landed, from its place.
  [[nodiscard]] double error_of(std::size_t i) const {
    const Pose2 place = kPlanInOdometry.relative_of({steps.step[i][0], steps.step[i][1], steps.step[i][2]});
    return (pattern.state().feet[steps.side[i]].position() - place.position()).norm();
  }

  FootstepPlan steps{};
  std::uint32_t landed = 0;
  std::vector<double> placed;
};

TEST_F(FollowedSteps, TheFeetLandWhereTheyArePlannedAndTheRobotStandsAfterTheLast) {
  plan_straight(9, 0.08);
  for (int i = 0; i < 60; ++i) {
    follow(1);
    const bool walks = pattern.state().phase == Phase::walking;
    EXPECT_TRUE(!walks || pattern.state().step.number != 0) << "a step that nobody has planned, cycle " << i;
  }
  ASSERT_EQ(placed.size(), 9U);
  for (const double error_m : placed) EXPECT_LT(error_m, 1e-9);
  EXPECT_EQ(pattern.state().phase, Phase::stand);
  EXPECT_NEAR(middle_of(pattern.state().feet).x_m, 0.64, 1e-9);
}

// Turning and to the side, whole soles apart, and the ZMP stays on the soles.
TEST_F(FollowedSteps, ACurveIsFollowedWithTheZmpOnTheSoles) {
  Pose2 middle;
  for (int i = 0; i < 12; ++i) {
    const Side side = i % 2 == 0 ? Side::left : Side::right;
    middle = middle.compose({0.05, 0.01, 0.1});
    const double half_m = 0.5 * parameters.foot_spacing_m + 0.012;  // toes that turn in need it
    add(side, middle.compose({0.0, sign_of(side) * half_m, 0.0}));
  }
  steps.first = 1;
  steps.ends = 1;
  for (int i = 0; i < 70; ++i) {
    follow(1);
    for (std::size_t point = 0; point < kBatchPoints; ++point) {
      EXPECT_GT(zmp_depth_m(*plan, point, parameters.sole), 0.002) << "cycle " << i << ", point " << point;
      EXPECT_GT(sole_gap_m(*plan, point, parameters.sole), 0.0);
    }
  }
  ASSERT_EQ(placed.size(), 12U);
  for (std::size_t i = 0; i + 1 < placed.size(); ++i) EXPECT_LT(placed[i], 1e-9) << i;
  EXPECT_EQ(pattern.state().phase, Phase::stand);
}

TEST_F(FollowedSteps, AListThatIsNotRenewedEndsInAStand) {
  plan_straight(9, 0.08);
  steps.ends = 0;
  steps.step_count = 4;
  follow(60);
  EXPECT_EQ(pattern.state().phase, Phase::stand);
  EXPECT_EQ(landed, 4U);
  const double x_m = middle_of(pattern.state().feet).x_m;
  EXPECT_NEAR(x_m, 0.32, 1e-9) << "the other foot was set beside the fourth";
}

TEST_F(FollowedSteps, TooOldOrBrokenPlansAreNone) {
  plan_straight(9, 0.08);
  const auto count = [this](const FootstepPlan& plan_to_try) {
    return planned_steps(plan_to_try, measured(), pattern.state(), 10).count;
  };
  EXPECT_EQ(count(steps), 9U);
  const auto broken = [&](const auto& breaks) {
    FootstepPlan other = steps;
    breaks(other);
    return count(other);
  };
  EXPECT_EQ(broken([](FootstepPlan& p) { p.valid_until_ns = 10; }), 0U);
  EXPECT_EQ(broken([](FootstepPlan& p) { p.first = 0; }), 0U);
  EXPECT_EQ(broken([](FootstepPlan& p) { p.step_count = kMaxPlannedSteps + 1; }), 0U);
  EXPECT_EQ(broken([](FootstepPlan& p) { p.side[3] = p.side[2]; }), 0U);
  EXPECT_EQ(broken([](FootstepPlan& p) { p.side[3] = 7; }), 0U);
  EXPECT_EQ(broken([](FootstepPlan& p) { p.step[8][2] = kNan; }), 0U);
}

TEST_F(FollowedSteps, AFirstStepOutOfReachIsNotTaken) {
  const double half = 0.5 * parameters.foot_spacing_m;
  add(Side::left, {0.5, half, 0.0});
  add(Side::right, {0.5, -half, 0.0});
  steps.first = 1;
  steps.ends = 1;
  follow(10);
  EXPECT_EQ(pattern.state().phase, Phase::stand);
  EXPECT_EQ(plan->footstep_count, 0U);
}

// Whoever planned it may have been wrong by a step; the gait's limits hold all the same.
TEST_F(FollowedSteps, ALaterStepOutOfReachIsLimited) {
  plan_straight(9, 0.08);
  for (std::uint32_t i = 4; i < 9; ++i) {
    Pose2 pose{steps.step[i][0], steps.step[i][1], steps.step[i][2]};
    pose = pose.compose({0.4, 0.0, 0.0});
    steps.step[i][0] = pose.x_m;
    steps.step[i][1] = pose.y_m;
  }
  double longest_m = 0.0;
  for (int i = 0; i < 60; ++i) {
    follow(1);
    const Step& step = pattern.state().step;
    if (pattern.state().phase == Phase::walking) {
      longest_m = std::max(longest_m, step.stance.relative_of(step.landing).x_m);
    }
  }
  EXPECT_LE(longest_m, parameters.max_step_forward_m + 1e-9);
  EXPECT_GT(longest_m, 0.08);
}

// A velocity is a person's: the robot walks by it at once. The plan is followed only from a stand.
TEST_F(FollowedSteps, AVelocityComesFirst) {
  plan_straight(12, 0.08);
  follow(16);
  EXPECT_EQ(pattern.state().phase, Phase::walking);
  command_walk(-0.05, 0.0, 0.0);
  follow(30);
  EXPECT_LT(pattern.state().step.velocity.forward_m_per_s, -0.04);
  EXPECT_EQ(pattern.state().step.number, 0U);
  command.walk = 0;
  steps.step_count = 0;
  follow(30);
  EXPECT_EQ(pattern.state().phase, Phase::stand);
}

// Odometry says that the stance foot has slipped: the next landing makes up for it.
TEST_F(FollowedSteps, WhatTheOdometryHasSeenIsMadeUpFor) {
  plan_straight(12, 0.06);
  follow(14);
  Estimate slipped = measured();
  const Side stance = other(pattern.state().step.swing);
  slipped.odometry_foot[static_cast<std::size_t>(stance)][2] += 0.05;
  const PlannedSteps seen = planned_steps(steps, slipped, pattern.state(), 0);
  const PlannedSteps before = planned_steps(steps, measured(), pattern.state(), 0);
  EXPECT_NEAR(seen.yaw_correction_rad, before.yaw_correction_rad - 0.05, 1e-12);
  EXPECT_NEAR(seen.place[6].pose.yaw_rad, before.place[6].pose.yaw_rad - 0.05, 1e-12);
}

TEST_F(FollowedSteps, WithoutOdometryThereAreNoStepsAndNothingIsTold) {
  plan_straight(9, 0.08);
  Estimate unknown = measured();
  for (auto& foot : unknown.odometry_foot) foot[1] = kNan;
  EXPECT_EQ(planned_steps(steps, unknown, pattern.state(), 0).count, 0U);
  FootstepState told{};
  EXPECT_FALSE(describe(pattern.state(), unknown, true, told));
}

TEST_F(FollowedSteps, WhoPlansIsToldWhichStepIsInFlight) {
  plan_straight(9, 0.08);
  FootstepState told{};
  EXPECT_TRUE(describe(pattern.state(), measured(), true, told));
  EXPECT_EQ(told.state, std::uint32_t{footstep_state::state::stands});
  follow(16);
  EXPECT_TRUE(describe(pattern.state(), measured(), true, told));
  EXPECT_EQ(told.state, std::uint32_t{footstep_state::state::follows});
  ASSERT_GE(told.step, 2U);
  EXPECT_EQ(told.landed, told.step - 1);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(told.landing[axis], steps.step[told.step - 1][axis], 1e-9);
  EXPECT_TRUE(describe(pattern.state(), measured(), false, told));
  EXPECT_EQ(told.state, std::uint32_t{footstep_state::state::other}) << "a motion plays";
  command_walk(0.1, 0.0, 0.0);
  follow(4);
  EXPECT_TRUE(describe(pattern.state(), measured(), true, told));
  EXPECT_EQ(told.state, std::uint32_t{footstep_state::state::other}) << "it walks by a velocity";
}

}  // namespace
}  // namespace gaitway::trajectory
