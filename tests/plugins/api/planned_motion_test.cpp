// Which point of which plan is in force.
#include "gaitway/api/planned_motion.hpp"
#include "gaitway/facts/facts.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace gaitway::api {
namespace {

constexpr std::int64_t kPoint_ns = facts::kSlot_ns;

// Point i of plan n: the left foot at x = 8 n + i + 1 (as many points as have been reached since cycle 0
// began), tail of 16.
std::unique_ptr<MotionPlan> plan_of(std::uint32_t sequence) {
  auto plan = std::make_unique<MotionPlan>();
  plan->sequence = sequence;
  plan->tail_count = 16;
  plan->start_ns = std::int64_t{sequence} * 8 * kPoint_ns;
  for (int point = 0; point < kBatchPoints + 16; ++point) {
    plan->foot_position[point][0][0] = 8.0 * sequence + point + 1.0;
    plan->foot_yaw[point][1] = 0.1 * (8.0 * sequence + point + 1.0);
    plan->zmp[point][1] = -(8.0 * sequence + point + 1.0);
    plan->support[point] = point < 4 ? 0 : 2;
  }
  return plan;
}

double left_x(const PlannedMotion& motion, std::int64_t instant_ns, std::uint32_t accepted = 1000) {
  const auto moment = motion.at(instant_ns, accepted);
  return moment ? moment->feet[0].position_m.x() : -1.0;
}

class PlannedMotionTest : public ::testing::Test {
 protected:
  std::unique_ptr<PlannedMotion> motion = std::make_unique<PlannedMotion>();
};

TEST_F(PlannedMotionTest, KnowsNothingBeforeTheFirstPlanStarts) {
  motion->take(*plan_of(5));
  EXPECT_FALSE(motion->at(5 * 8 * kPoint_ns - 1, std::nullopt));
  EXPECT_TRUE(motion->at(5 * 8 * kPoint_ns, std::nullopt));
}

TEST_F(PlannedMotionTest, ReachesEveryPointAtTheEndOfItsSlot) {
  motion->take(*plan_of(5));
  EXPECT_DOUBLE_EQ(left_x(*motion, 41 * kPoint_ns), 41.0);
  EXPECT_DOUBLE_EQ(left_x(*motion, 48 * kPoint_ns), 48.0);
}

TEST_F(PlannedMotionTest, GoesStraightFromPointToPoint) {
  motion->take(*plan_of(5));
  const auto moment = motion->at(42 * kPoint_ns + kPoint_ns / 4, std::nullopt);
  ASSERT_TRUE(moment);
  EXPECT_DOUBLE_EQ(moment->feet[0].position_m.x(), 42.25);
  EXPECT_DOUBLE_EQ(moment->feet[1].yaw_rad, 4.225);
  EXPECT_DOUBLE_EQ(moment->zmp_m.y(), -42.25);
}

TEST_F(PlannedMotionTest, GoesFromTheLastPlansEndToTheFirstPointOfTheNext) {
  motion->take(*plan_of(5));
  motion->take(*plan_of(6));
  EXPECT_DOUBLE_EQ(left_x(*motion, 48 * kPoint_ns), 48.0);
  EXPECT_DOUBLE_EQ(left_x(*motion, 48 * kPoint_ns + kPoint_ns / 2), 48.5);
  EXPECT_EQ(motion->at(48 * kPoint_ns, std::nullopt)->plan->sequence, 6U);
}

TEST_F(PlannedMotionTest, StaysAtItsLastPointWhenThereIsNoOtherPlan) {
  motion->take(*plan_of(5));
  EXPECT_DOUBLE_EQ(left_x(*motion, 64 * kPoint_ns), 64.0);
  EXPECT_DOUBLE_EQ(left_x(*motion, 900 * kPoint_ns), 64.0);
}

TEST_F(PlannedMotionTest, PlaysTheTailOfTheLastAcceptedPlan) {
  motion->take(*plan_of(5));
  auto refused = plan_of(6);
  refused->foot_position[2][0][0] = -77.0;
  motion->take(*refused);
  EXPECT_DOUBLE_EQ(left_x(*motion, 51 * kPoint_ns, 5), 51.0);
  EXPECT_DOUBLE_EQ(left_x(*motion, 51 * kPoint_ns, 6), -77.0);
}

TEST_F(PlannedMotionTest, KeepsThePlanInForceWhileNewerOnesCome) {
  for (std::uint32_t sequence = 5; sequence < 9; ++sequence) motion->take(*plan_of(sequence));
  EXPECT_DOUBLE_EQ(left_x(*motion, 47 * kPoint_ns), 47.0);
  motion->take(*plan_of(9));
  EXPECT_FALSE(motion->at(47 * kPoint_ns, std::nullopt)) << "the oldest has made room";
  EXPECT_DOUBLE_EQ(left_x(*motion, 79 * kPoint_ns), 79.0);
}

TEST_F(PlannedMotionTest, TakesANewerPlanOfTheSameBatchInItsPlace) {
  motion->take(*plan_of(5));
  auto newer = plan_of(5);
  newer->foot_position[0][0][0] = 7.0;
  motion->take(*newer);
  EXPECT_DOUBLE_EQ(left_x(*motion, 41 * kPoint_ns), 7.0);
}

TEST_F(PlannedMotionTest, TellsWhichFeetAreOnTheGround) {
  motion->take(*plan_of(5));
  EXPECT_TRUE(motion->at(42 * kPoint_ns, std::nullopt)->feet[0].on_ground);
  EXPECT_FALSE(motion->at(42 * kPoint_ns, std::nullopt)->feet[1].on_ground);
  EXPECT_TRUE(motion->at(46 * kPoint_ns, std::nullopt)->feet[1].on_ground);
}

TEST_F(PlannedMotionTest, DoesNotTakeAPlanWithoutSequence) {
  motion->take(*plan_of(0));
  EXPECT_FALSE(motion->at(100 * kPoint_ns, std::nullopt));
}

}  // namespace
}  // namespace gaitway::api
