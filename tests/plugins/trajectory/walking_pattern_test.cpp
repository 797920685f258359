// The walk that was asked for: speed, turning, side steps, start and stop, the cart-table's ZMP, footsteps.
#include "gaitway/trajectory/walking_pattern.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <numbers>

#include "gaitway/facts/facts.hpp"
#include "planned_walk.hpp"

namespace gaitway::trajectory {
namespace {

class Walk : public PlannedWalk {
 protected:
  [[nodiscard]] Pose2 middle() const { return middle_of(pattern.state().feet); }
};

TEST_F(Walk, StandingStillGivesEqualPoints) {
  pattern.reset_to_stand({1.0, -2.0, 0.7});
  run(3);
  for (std::size_t i = 0; i < kBatchPoints + plan->tail_count; ++i) {
    EXPECT_EQ(com_of(*plan, i), com_of(*plan, 0));
    EXPECT_EQ(com_velocity_of(*plan, i), Eigen::Vector2d::Zero());
    EXPECT_EQ(foot_of(*plan, i, 0), foot_of(*plan, 0, 0));
    EXPECT_EQ(plan->support[i], 2);
  }
  EXPECT_NEAR(plan->com[0][0], 1.0 + parameters.stand_com_forward_m * std::cos(0.7), 1e-12);
  EXPECT_EQ(plan->footstep_count, 0U);
}

TEST_F(Walk, ForwardSpeedEqualsTheCommandWithinTwoPercent) {
  for (const double speed : {0.05, 0.20, 0.30, -0.20}) {
    command_walk(speed, 0.0, 0.0);
    run(60);
    const Eigen::Vector2d from = com_of(*plan, 0);
    run(50);  // 4 s
    const double measured = (com_of(*plan, 0) - from).x() / 4.0;
    EXPECT_NEAR(measured, speed, 0.02 * std::abs(speed));
  }
}

TEST_F(Walk, TurnsOnTheSpotBothWays) {
  for (const double rate : {0.3, -0.3}) {
    command_walk(0.0, 0.0, rate);
    run(60);
    const Eigen::Vector2d from = com_of(*plan, 0);
    const double yaw = plan->base_yaw[0];
    run(100);  // twenty steps
    EXPECT_NEAR((plan->base_yaw[0] - yaw) / 8.0, rate, 0.02 * std::abs(rate));
    EXPECT_LT((com_of(*plan, 0) - from).norm(), 0.05);
  }
}

TEST_F(Walk, StepsSidewaysBothWays) {
  for (const double speed : {0.05, -0.05}) {
    command_walk(0.0, speed, 0.0);
    run(60);
    const double from = plan->com[0][1];
    run(100);
    EXPECT_NEAR((plan->com[0][1] - from) / 8.0, speed, 0.02 * std::abs(speed));
  }
}

TEST_F(Walk, WalksACircleOfTheCommandedRadius) {
  command_walk(0.15, 0.0, 0.25);
  run(100);
  const Pose2 before = middle();
  const double yaw = plan->base_yaw[7];
  run(56);  // fourteen steps of 0.32 s: 1.12 rad of the circle of 0.6 m
  const double turned = plan->base_yaw[7] - yaw;
  EXPECT_NEAR(turned, 1.12, 0.02);
  const double chord = std::hypot(middle().x_m - before.x_m, middle().y_m - before.y_m);
  EXPECT_NEAR(chord, 2.0 * 0.6 * std::sin(0.56), 0.02);
}

TEST_F(Walk, YawFeedbackTurnsTheWalk) {
  command_walk(0.1, 0.0, 0.2);
  correction.turn_rate_offset = -0.2;
  run(100);
  EXPECT_NEAR(plan->base_yaw[7], 0.0, 1e-9);
}

TEST_F(Walk, StepOffsetMovesTheNextFreeFootstepOnly) {
  command_walk(0.0, 0.0, 0.0);
  run(1);
  const double nominal = plan->footstep[0][0];
  correction.step_offset[0] = 0.02;
  run(1);
  EXPECT_NEAR(plan->footstep[0][0], nominal + 0.02, 1e-9);
  EXPECT_NEAR(plan->footstep[1][0] - plan->footstep[0][0], 0.0, 1e-9);
}

TEST_F(Walk, LandsWhenAndWhereTheFootstepsSay) {
  command_walk(0.2, 0.0, 0.1);
  run(50);
  ASSERT_GE(plan->footstep_count, 2U);
  const std::int64_t landing = plan->footstep_landing_ns[0];
  const std::size_t side = plan->footstep_side[0];
  const Eigen::Vector2d place(plan->footstep[0][0], plan->footstep[0][1]);
  while (sequence * kCycle_ns + kCycle_ns < landing) run(1);
  const auto i = static_cast<std::size_t>((landing - plan->start_ns) / 10'000'000 - 1);
  ASSERT_LT(i, kBatchPoints);
  EXPECT_LT((foot_of(*plan, i, side).head<2>() - place).norm(), 0.03);  // the step may have been re-planned
  EXPECT_EQ(plan->foot_position[i][side][2], 0.0);
  EXPECT_EQ(plan->support[i], 2);
}

TEST_F(Walk, FixedFootstepIgnoresNewCommands) {
  command_walk(0.2, 0.0, 0.0);
  run(50);
  const auto& state = pattern.state();
  while (state.elapsed_points <
         state.step.double_support_points + parameters.freeze_share * state.step.swing_points) {
    run(1);
  }
  const Pose2 fixed = state.step.landing;
  const auto side = plan->footstep_side[0];
  command_walk(-0.1, 0.05, 0.3);
  run(1);
  ASSERT_EQ(plan->footstep_side[0], side);
  EXPECT_EQ(plan->footstep[0][0], fixed.x_m);
  EXPECT_EQ(plan->footstep[0][2], fixed.yaw_rad);
  EXPECT_NE(plan->footstep[1][2], fixed.yaw_rad);
}

TEST_F(Walk, LeadInShiftsTheWeightBeforeTheFirstLift) {
  command_walk(0.1, 0.0, 0.0);
  int points = 0;
  for (run(1);; run(1)) {
    std::size_t i = 0;
    while (i < kBatchPoints && plan->support[i] == 2) ++i, ++points;
    if (i < kBatchPoints) break;
  }
  EXPECT_EQ(points, 60);
}

// The whole body's as a cart on a table, and what the leg in the air adds.
TEST_F(Walk, PlannedZmpIsThatOfThePlannedMotion) {
  for (const double swing_moment_s2 : {0.0, 0.004}) {
    parameters.swing_moment_s2 = swing_moment_s2;
    pattern = WalkingPattern(parameters);
    command_walk(0.25, 0.0, 0.0);
    run(60);
    const double z_over_g = parameters.com_height_m / facts::kGravity_m_per_s2;
    const double T = facts::kSlot_s;
    double most_by_leg_m = 0.0;
    for (int n = 0; n < 5; ++n) {
      run(1);
      for (std::size_t i = 1; i + 1 < kBatchPoints; ++i) {
        const Eigen::Vector2d acceleration =
            (com_velocity_of(*plan, i + 1) - com_velocity_of(*plan, i - 1)) / (2.0 * T);
        Eigen::Vector2d feet = Eigen::Vector2d::Zero();
        for (std::size_t side = 0; side < 2; ++side) {
          feet += (foot_of(*plan, i + 1, side) - 2.0 * foot_of(*plan, i, side) + foot_of(*plan, i - 1, side))
                      .head<2>() /
                  (T * T);
        }
        const Eigen::Vector2d by_leg = swing_moment_s2 * feet;
        most_by_leg_m = std::max(most_by_leg_m, by_leg.norm());
        EXPECT_LT((com_of(*plan, i) - z_over_g * acceleration + by_leg - zmp_of(*plan, i)).norm(), 0.009);
      }
    }
    EXPECT_EQ(most_by_leg_m > 0.03, swing_moment_s2 > 0.0);
  }
}

TEST_F(Walk, FastWalkLowersTheHipsAndAStopRaisesThem) {
  command_walk(0.2, 0.0, 0.0);
  run(60);
  EXPECT_EQ(plan->hip_height[7], parameters.hip_height_m);
  command_walk(0.4, 0.0, 0.0);
  run(60);
  EXPECT_NEAR(plan->hip_height[7], parameters.fast_hip_height_m, 1e-12);
  command.walk = 0;
  run(30);
  EXPECT_EQ(plan->hip_height[7], parameters.hip_height_m);
}

TEST_F(Walk, CommandedYawIsTheBaseYawWithoutTheFeedback) {
  command_walk(0.1, 0.0, 0.2);
  correction.turn_rate_offset = 0.1;
  run(100);
  // Twelve and a half steps of 8 s: the commanded part grows by 0.2 rad/s, the base's yaw by 0.3.
  const double base = plan->base_yaw[7], commanded = plan->commanded_yaw[7];
  run(100);
  EXPECT_NEAR(plan->base_yaw[7] - base, 0.3 * 8.0, 0.03);
  EXPECT_NEAR(plan->commanded_yaw[7] - commanded, 0.2 * 8.0, 0.03);
}

TEST_F(Walk, SpeedFeedbackIsAddedToTheCommand) {
  command_walk(0.2, 0.0, 0.0);
  correction.velocity_offset[0] = -0.02;
  run(60);
  const double from = plan->com[0][0];
  run(100);
  EXPECT_NEAR((plan->com[0][0] - from) / 8.0, 0.18, 0.003);
}

TEST_F(Walk, ZmpTracksTheReferenceWithinMillimetres) {
  parameters.swing_moment_s2 = 0.0;
  parameters.step_time_s = 0.40;
  parameters.double_support_share = 0.15;
  pattern = WalkingPattern(parameters);
  command_walk(0.25, 0.0, 0.0);
  run(60);
  double worst_on_one_foot = 0.0, sum = 0.0;
  for (int n = 0; n < 20; ++n) {
    run(1);
    for (std::size_t i = 0; i < kBatchPoints; ++i) {
      const Eigen::Vector2d reference = pattern.reference().point.row(static_cast<Eigen::Index>(i) + 1);
      const double error = (zmp_of(*plan, i) - reference).norm();
      if (plan->support[i] != 2) worst_on_one_foot = std::max(worst_on_one_foot, error);
      sum += error * error;
    }
  }
  const double rms = std::sqrt(sum / 160.0);
  std::cout << "ZMP error: worst on one foot " << 1e3 * worst_on_one_foot << " mm, RMS of all " << 1e3 * rms
            << " mm\n";
  EXPECT_LT(worst_on_one_foot, 0.006);
  EXPECT_LT(rms, 0.004);
}

TEST_F(Walk, UndisturbedWalkNeedsNoOffset) {
  command_walk(0.25, 0.0, 0.1);
  run(80);
  EXPECT_LT(pattern.state().zmp_offset.point.cwiseAbs().maxCoeff(), 5e-4);
}

TEST_F(Walk, StopEndsInTheStandAndAgreesWithTheTail) {
  command_walk(0.2, 0.0, 0.0);
  run(57);
  const Pose2 promised = pattern.final_stance();
  command.walk = 0;
  run(25);
  EXPECT_EQ(pattern.state().phase, Phase::stand);
  EXPECT_NEAR(middle().x_m, promised.x_m, 1e-12);
  EXPECT_NEAR(middle().y_m, promised.y_m, 1e-12);
  EXPECT_NEAR(plan->com[7][0], promised.x_m + parameters.stand_com_forward_m, 1e-12);
}

TEST_F(Walk, StopCommandWalksExactlyTheTailThatWasPromised) {
  command_walk(0.2, 0.0, 0.2);
  run(53);
  const auto promise = std::make_unique<MotionPlan>(*plan);
  command.walk = 0;
  for (std::size_t done = 0; done < promise->tail_count; done += kBatchPoints) {
    run(1);
    for (std::size_t i = 0; i < kBatchPoints; ++i) {
      const std::size_t k = kBatchPoints + done + i;
      EXPECT_LT((com_of(*plan, i) - com_of(*promise, k)).norm(), 5e-4);
      EXPECT_LT((foot_of(*plan, i, 0) - foot_of(*promise, k, 0)).norm(), 1e-9);
      EXPECT_LT((foot_of(*plan, i, 1) - foot_of(*promise, k, 1)).norm(), 1e-9);
    }
  }
}

// A robot that has bowed straightens up in the second half of its tail: 0.6 rad within the hips' speed.
TEST_F(Walk, TheTailOfAStandIsLongEnoughToEndABow) {
  run(3);
  EXPECT_GE(plan->tail_count, 48U);
}

TEST_F(Walk, WalksOnWhenTheCommandComesBackWhileStopping) {
  command_walk(0.2, 0.0, 0.0);
  run(50);
  command.walk = 0;
  run(3);
  command.walk = 1;
  run(60);
  EXPECT_EQ(pattern.state().phase, Phase::walking);
  EXPECT_NEAR(pattern.state().step.velocity.forward_m_per_s, 0.2, 1e-12);
}

TEST_F(Walk, NonFiniteCommandStops) {
  command_walk(0.2, 0.0, 0.0);
  run(50);
  command.velocity[0] = std::numeric_limits<double>::quiet_NaN();
  run(30);
  EXPECT_EQ(pattern.state().phase, Phase::stand);
  EXPECT_TRUE(std::isfinite(plan->com[7][0]));
}

TEST_F(Walk, NonFiniteCorrectionCountsAsNone) {
  command_walk(0.2, 0.0, 0.0);
  correction.step_offset[1] = std::numeric_limits<double>::infinity();
  correction.turn_rate_offset = std::numeric_limits<double>::quiet_NaN();
  run(50);
  EXPECT_NEAR(plan->base_yaw[7], 0.0, 1e-12);
  EXPECT_TRUE(std::isfinite(plan->com[7][1]));
}

TEST_F(Walk, NamesTheRuleThatLimitedACommand) {
  command_walk(2.0, 0.0, 0.0);
  run(1);
  EXPECT_TRUE(has(pattern.applied_limits(), StepLimit::speed));
  EXPECT_TRUE(has(pattern.applied_limits(), StepLimit::acceleration));
  run(100);
  const Eigen::Vector2d from = com_of(*plan, 0);
  run(50);
  EXPECT_NEAR((com_of(*plan, 0) - from).x() / 4.0, parameters.max_step_forward_m / parameters.step_time_s,
              0.005);
}

TEST_F(Walk, CarriesSequenceAndStartAndTheConstantHipHeight) {
  run(2);
  EXPECT_EQ(plan->sequence, 2U);
  EXPECT_EQ(plan->start_ns, 2 * kCycle_ns);
  EXPECT_EQ(plan->hip_height[0], parameters.hip_height_m);
}

}  // namespace
}  // namespace gaitway::trajectory
