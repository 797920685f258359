// Which plan plays now.
#include "gaitway/stability/plan_timeline.hpp"
#include "gaitway/facts/facts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace gaitway::stability {
namespace {

using facts::kSlot_ns;

std::unique_ptr<MotionPlan> plan_of(std::uint32_t sequence, std::int64_t start_ns, std::uint8_t batch_support,
                                    double yaw_rad = 0.0) {
  auto plan = std::make_unique<MotionPlan>();
  plan->sequence = sequence;
  plan->start_ns = start_ns;
  plan->tail_count = 16;
  plan->footstep_count = 1;
  for (std::size_t i = 0; i < 24; ++i) {
    plan->support[i] = i < 8 ? batch_support : std::uint8_t{2};
    plan->commanded_yaw[i] = yaw_rad + 0.001 * static_cast<double>(i + 1);
  }
  return plan;
}

TEST(PlanTimeline, NothingPlaysBeforeTheFirstPlanStarts) {
  PlanTimeline timeline;
  EXPECT_FALSE(timeline.at(0, std::nullopt));
  timeline.take(*plan_of(1, 80 * kSlot_ns, 0));
  EXPECT_FALSE(timeline.at(80 * kSlot_ns - 1, std::nullopt));
  ASSERT_TRUE(timeline.at(80 * kSlot_ns, std::nullopt));
}

TEST(PlanTimeline, ThePlanBeforeIsKeptUntilTheNewestStarts) {
  PlanTimeline timeline;
  timeline.take(*plan_of(1, 0, 0));
  timeline.take(*plan_of(2, 8 * kSlot_ns, 1));
  EXPECT_EQ(timeline.at(7 * kSlot_ns, std::nullopt)->support, 0U);
  EXPECT_EQ(timeline.at(8 * kSlot_ns, std::nullopt)->support, 1U);
}

TEST(PlanTimeline, TakingTheSamePlanEveryTickKeepsTheOnesBefore) {
  PlanTimeline timeline;
  timeline.take(*plan_of(1, 0, 0));
  const auto second = plan_of(2, 8 * kSlot_ns, 1);
  for (int i = 0; i < 8; ++i) timeline.take(*second);
  EXPECT_EQ(timeline.at(0, std::nullopt)->support, 0U);
}

TEST(PlanTimeline, ANewerPlanOfTheSameBatchReplacesItsPlan) {
  PlanTimeline timeline;
  timeline.take(*plan_of(1, 0, 0));
  timeline.take(*plan_of(1, 0, 1));
  EXPECT_EQ(timeline.at(kSlot_ns, std::nullopt)->support, 1U);
}

TEST(PlanTimeline, APlanThatWasNotAcceptedLeavesTheTailOfTheOneBefore) {
  PlanTimeline timeline;
  timeline.take(*plan_of(1, 0, 0));
  timeline.take(*plan_of(2, 8 * kSlot_ns, 1));
  EXPECT_EQ(timeline.at(9 * kSlot_ns, 1U)->support, 2U);
  EXPECT_EQ(timeline.at(9 * kSlot_ns, 2U)->support, 1U);
  EXPECT_FALSE(timeline.at(9 * kSlot_ns, 0U));
}

TEST(PlanTimeline, YawIsWhatWasReachedAndStaysAfterTheTail) {
  PlanTimeline timeline;
  timeline.take(*plan_of(1, 0, 0, 0.5));
  EXPECT_DOUBLE_EQ(timeline.at(3 * kSlot_ns, std::nullopt)->commanded_yaw_rad, 0.503);
  EXPECT_DOUBLE_EQ(timeline.at(24 * kSlot_ns, std::nullopt)->commanded_yaw_rad, 0.524);
  const auto late = timeline.at(5000 * kSlot_ns, std::nullopt);
  EXPECT_DOUBLE_EQ(late->commanded_yaw_rad, 0.524);
  EXPECT_EQ(late->support, 2U);
  EXPECT_FALSE(late->walking);
}

TEST(PlanTimeline, PlansWithoutSequenceOrNumberAreNotTaken) {
  PlanTimeline timeline;
  timeline.take(*plan_of(0, 0, 0));
  auto broken = plan_of(1, 0, 0);
  broken->base_yaw[3] = std::nan("");
  timeline.take(*broken);
  EXPECT_FALSE(timeline.at(kSlot_ns, std::nullopt));
}

TEST(PlanTimeline, TellsThePostureOfAFallFromAMotionOnTheGround) {
  PlanTimeline timeline;
  const auto plan = plan_of(1, 0, 3);
  plan->motion = 1;
  timeline.take(*plan);
  EXPECT_TRUE(timeline.at(0, std::nullopt)->on_ground);
  EXPECT_FALSE(timeline.at(0, std::nullopt)->fall_posture);
  plan->motion = 2;
  timeline.take(*plan);
  EXPECT_FALSE(timeline.at(0, std::nullopt)->on_ground) << "nobody has asked for it";
  EXPECT_TRUE(timeline.at(0, std::nullopt)->fall_posture);
  EXPECT_FALSE(timeline.at(0, std::nullopt)->motion) << "nothing to balance";
  EXPECT_FALSE(timeline.newest_stays_upright()) << "nor for the message controller";
}

}  // namespace
}  // namespace gaitway::stability
