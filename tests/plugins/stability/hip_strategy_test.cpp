// When a standing robot bows, how far, and how it straightens up again.
#include "gaitway/stability/hip_strategy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "test_robot.hpp"

namespace gaitway::stability {
namespace {

using Batching = HipStrategy::Batching;
constexpr double kMiddle_m = 0.010;  // of the soles
constexpr int kTicks = 8;            // of a batch
constexpr double kBatch_s = 0.080;
constexpr std::uint32_t kTail = 48;

class HipStrategyTest : public ::testing::Test {
 protected:
  // One batch with the DCM there all the time, and the CoM above the soles' middle.
  msgclient::Bow batch(std::optional<double> dcm_ahead_m, bool steps = false) {
    return batch_at(
        dcm_ahead_m ? std::optional(HipStrategy::Standing{*dcm_ahead_m, kMiddle_m}) : std::nullopt, steps);
  }
  msgclient::Bow batch_at(const std::optional<HipStrategy::Standing>& standing, bool steps = false) {
    for (int tick = 0; tick < kTicks; ++tick) hips_.follow(standing);
    hips_.begin_batch(++sequence_, steps ? Batching::steps : Batching::stands, kTail);
    return hips_.target();
  }

  BalanceParameters parameters_;
  void begin_anew() {
    std::destroy_at(&hips_);
    std::construct_at(&hips_, test::humanoid(), parameters_);
  }

  HipStrategy hips_{test::humanoid(), parameters_};
  std::uint32_t sequence_ = 0;
};

TEST_F(HipStrategyTest, StandsUprightWhileTheAnklesCanBringTheBodyBack) {
  for (const double ahead_m : {0.0, 0.019, -0.019}) {
    const msgclient::Bow bow = batch(kMiddle_m + ahead_m);
    EXPECT_EQ(bow.angle_rad, 0.0);
    EXPECT_EQ(bow.rate_rad_per_s, 0.0);
  }
  EXPECT_FALSE(hips_.bows());
}

// On a slope of 5 degrees the CoM is 31 mm off, until the robot has brought it back: nobody pushes.
TEST_F(HipStrategyTest, StandsUprightWhereItOnlyStandsAskew) {
  for (const double sense : {1.0, -1.0}) {
    const double com_m = kMiddle_m + sense * 0.04;
    EXPECT_EQ(batch_at(HipStrategy::Standing{com_m + sense * 0.010, com_m}).angle_rad, 0.0);
    EXPECT_EQ(batch_at(HipStrategy::Standing{com_m - sense * 0.015, com_m}).angle_rad, 0.0);
  }
}

TEST_F(HipStrategyTest, BowsTowardsThePushWithinItsSpeedAndRestsAtItsLimit) {
  for (const double sense : {1.0, -1.0}) {
    begin_anew();
    double last_rad_per_s = 0.0;
    for (int i = 0; i < 8; ++i) {
      const msgclient::Bow bow = batch(kMiddle_m + sense * 0.06);
      EXPECT_LE(std::abs(bow.rate_rad_per_s), parameters_.bow_speed_rad_per_s);
      EXPECT_GE(sense * bow.rate_rad_per_s, -1e-12) << "it does not overshoot";
      last_rad_per_s = bow.rate_rad_per_s;
    }
    EXPECT_NEAR(last_rad_per_s, 0.0, 1e-3);
    EXPECT_NEAR(hips_.target().angle_rad, sense * parameters_.bow_limit_rad, 1e-3);
    EXPECT_TRUE(hips_.bows());
  }
}

TEST_F(HipStrategyTest, BatchesJoinWithoutAJump) {
  for (int i = 0; i < 12; ++i) {
    batch(kMiddle_m + (i < 4 ? 0.07 : 0.0));
    if (sequence_ < 2) continue;
    const msgclient::Bow before = hips_.at(sequence_ - 1, kBatch_s), after = hips_.at(sequence_, 0.0);
    EXPECT_NEAR(before.angle_rad, after.angle_rad, 1e-12);
    EXPECT_NEAR(before.rate_rad_per_s, after.rate_rad_per_s, 1e-12);
  }
}

TEST_F(HipStrategyTest, StraightensUpSlowlyAndIsNotThrownToTheOtherSide) {
  for (int i = 0; i < 4; ++i) batch(kMiddle_m + 0.07);
  double last_rad = hips_.target().angle_rad;
  ASSERT_GT(last_rad, 0.3);
  for (int i = 0; i < 40; ++i) {
    // Swinging back, the body is as far behind as it was ahead.
    const msgclient::Bow bow = batch(kMiddle_m + (i < 6 ? -0.05 : 0.0));
    EXPECT_GE(bow.rate_rad_per_s, -parameters_.bow_return_rad_per_s - 1e-9);
    EXPECT_GE(bow.angle_rad, -1e-6);
    last_rad = bow.angle_rad;
  }
  EXPECT_NEAR(last_rad, 0.0, 1e-3);
  EXPECT_FALSE(hips_.bows());
}

TEST_F(HipStrategyTest, HoldsItsTrunkStillInABatchThatSteps) {
  batch(kMiddle_m + 0.07);
  ASSERT_GT(hips_.target().rate_rad_per_s, 1.0);
  const double reached_rad = hips_.target().angle_rad;
  const msgclient::Bow bow = batch(std::nullopt, true);
  EXPECT_NEAR(bow.rate_rad_per_s, 0.0, 1e-12);
  EXPECT_GT(bow.angle_rad, reached_rad);
}

TEST_F(HipStrategyTest, TheSameBatchAgainChangesNothing) {
  batch(kMiddle_m + 0.07);
  const msgclient::Bow bow = hips_.target();
  hips_.begin_batch(sequence_, Batching::stands, kTail);
  EXPECT_EQ(hips_.target().angle_rad, bow.angle_rad);
  EXPECT_EQ(hips_.target().rate_rad_per_s, bow.rate_rad_per_s);
}

TEST_F(HipStrategyTest, GoesOnFromWhereTheTailIsAfterBatchesThatWereMissed) {
  batch(kMiddle_m + 0.07);
  const double rests_rad = hips_.at(sequence_, 3.0 * kBatch_s).angle_rad;
  sequence_ += 3;
  batch(kMiddle_m + 0.07);
  EXPECT_NEAR(hips_.at(sequence_, 0.0).angle_rad, rests_rad, 1e-12);
}

TEST_F(HipStrategyTest, GoesOnFromWhatPlaysAfterABatchThatWasRefused) {
  batch(kMiddle_m + 0.07);
  const msgclient::Bow plays = hips_.target();
  batch(kMiddle_m + 0.07);
  ASSERT_GT(hips_.target().angle_rad, plays.angle_rad + 0.05);
  ++sequence_;
  hips_.begin_batch(sequence_, Batching::stands, kTail, sequence_ - 2);
  EXPECT_NEAR(hips_.at(sequence_, 0.0).angle_rad, hips_.at(sequence_ - 2, 2.0 * kBatch_s).angle_rad, 1e-12);
}

TEST_F(HipStrategyTest, NothingIsLeftOfABowWhenTheJointsGoHome) {
  for (int i = 0; i < 4; ++i) batch(kMiddle_m + 0.07);
  hips_.begin_batch(++sequence_, Batching::lies_down, kTail);
  EXPECT_EQ(hips_.target().angle_rad, 0.0);
  batch(kMiddle_m + 0.07);
  EXPECT_EQ(hips_.at(sequence_, 0.0).angle_rad, 0.0);
  EXPECT_GT(hips_.target().angle_rad, 0.0);
}

// A body twice as large sways by twice as much before anybody has pushed it.
TEST_F(HipStrategyTest, WhatIsAPushGrowsWithTheBody) {
  BalanceParameters larger;
  scale_to_body(larger.numbers(), facts::BodyScale(0.72, 54.72));
  HipStrategy hips(test::humanoid(), larger);
  const auto bow_at = [&hips](std::uint32_t sequence, double falling_m) {
    for (int tick = 0; tick < kTicks; ++tick)
      hips.follow(HipStrategy::Standing{kMiddle_m + 0.1, kMiddle_m + 0.1 - falling_m});
    hips.begin_batch(sequence, Batching::stands, kTail);
    return hips.target().angle_rad;
  };
  EXPECT_EQ(bow_at(1, 0.025), 0.0);
  EXPECT_GT(bow_at(2, 0.035), 0.0);
}

// As the kinematics has it: trims that balanced a trunk about a bow which the tail has ended would fell it.
TEST_F(HipStrategyTest, TheTailEndsTheBow) {
  for (int i = 0; i < 4; ++i) batch(kMiddle_m + 0.07);
  double last_rad = hips_.at(sequence_, kBatch_s + 0.24).angle_rad;
  EXPECT_GT(last_rad, 0.3) << "held through the first half";
  for (double time_s = kBatch_s + 0.25; time_s < kBatch_s + 0.485; time_s += 0.01) {
    const double angle_rad = hips_.at(sequence_, time_s).angle_rad;
    EXPECT_LT(angle_rad, last_rad) << time_s;
    last_rad = angle_rad;
  }
  EXPECT_EQ(last_rad, 0.0);
  EXPECT_EQ(hips_.at(sequence_, 100.0).angle_rad, 0.0);
}

TEST_F(HipStrategyTest, KnowsNothingOfABatchThatIsNotRemembered) {
  for (int i = 0; i < 6; ++i) batch(kMiddle_m + 0.07);
  EXPECT_EQ(hips_.at(1, 0.04).angle_rad, 0.0);
  EXPECT_EQ(hips_.at(0, 0.04).angle_rad, 0.0);
  EXPECT_GT(hips_.at(sequence_, 0.04).angle_rad, 0.1);
}

TEST_F(HipStrategyTest, ADcmThatIsNotANumberIsNoReasonToBow) {
  const msgclient::Bow bow = batch(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(bow.angle_rad, 0.0);
  EXPECT_FALSE(std::isnan(batch(kMiddle_m).angle_rad));
}

TEST_F(HipStrategyTest, CanBeTurnedOff) {
  parameters_.bow_gain_rad_per_m = 0.0;
  EXPECT_EQ(batch(kMiddle_m + 0.07).angle_rad, 0.0);
}

}  // namespace
}  // namespace gaitway::stability
