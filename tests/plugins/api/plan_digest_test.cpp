// What is told of a plan: whether the robot walks, and which steps are still to come.
#include "gaitway/api/plan_digest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/memory_block.hpp"

namespace gaitway::api {
namespace {

using facts::kSecond_ns;

class PlanDigestTest : public ::testing::Test {
 protected:
  PlanDigestTest() {
    plan->sequence = 12;
    std::ranges::fill(plan->support, std::uint8_t{2});
  }
  [[nodiscard]] PlannedState told() const {
    PlannedMoment moment;
    moment.plan = plan.get();
    return planned_state_of(moment, kSecond_ns);
  }
  std::unique_ptr<MotionPlan> plan = std::make_unique<MotionPlan>();
};

TEST_F(PlanDigestTest, OfNoPlanNothingIsTold) {
  const PlannedState state = planned_state_of(std::nullopt, 7);
  EXPECT_EQ(state.stamp_ns, 7);
  EXPECT_EQ(state.sequence, 0U);
}

TEST_F(PlanDigestTest, WalksWhileAFootIsLiftedOrAStepIsToCome) {
  EXPECT_EQ(told().walks, 0U);
  plan->support[3] = 0;
  EXPECT_EQ(told().walks, 1U);
  plan->support[3] = 2;
  plan->footstep_count = 1;
  plan->footstep_landing_ns[0] = kSecond_ns + 1;
  EXPECT_EQ(told().walks, 1U);
  plan->footstep_landing_ns[0] = kSecond_ns;
  EXPECT_EQ(told().walks, 0U);
}

TEST_F(PlanDigestTest, WalksUntilItHasComeToRestAfterTheLastStep) {
  plan->com_velocity[kBatchPoints - 1][1] = -0.01;
  EXPECT_EQ(told().walks, 1U);
  plan->com_velocity[kBatchPoints - 1][1] = 0.0;
  EXPECT_EQ(told().walks, 0U);
}

TEST_F(PlanDigestTest, FootstepsAreThoseThatHaveNotLanded) {
  plan->footstep_count = 3;
  for (int i = 0; i < 3; ++i) {
    plan->footstep[i][0] = 0.1 * (i + 1);
    plan->footstep_landing_ns[i] = kSecond_ns + i;  // the first lands at the instant
  }
  const PlannedState state = told();
  ASSERT_EQ(state.footstep_count, 2U);
  EXPECT_EQ(state.footstep[0][0], 0.2);
  EXPECT_EQ(state.footstep[1][0], 0.1 * 3);
}

TEST_F(PlanDigestTest, IsPublishedOnceASlotFromThePlanThatPlays) {
  msgclient::MemoryBlock block;
  msgclient::Client robot = block.local_client("robot"), api = block.local_client("api");
  auto plans = robot.write<MotionPlan>("motion_plan");
  auto network = robot.write<NetworkState>("network_state");
  PlanDigest digest(api);
  auto told = robot.read<PlannedState>("planned_state");
  plan->start_ns = 10 * facts::kSlot_ns;
  plans.publish(*plan, 0);
  NetworkState state{};
  state.accepted_sequence = 11;
  network.publish(state, 0);
  PlannedState value;
  digest.step(10 * facts::kSlot_ns + 3);
  ASSERT_TRUE(told.read(value));
  EXPECT_EQ(value.sequence, 0U) << "it is not accepted";
  state.accepted_sequence = 12;
  network.publish(state, 0);
  digest.step(10 * facts::kSlot_ns + 4);
  EXPECT_EQ(told.newest_sequence(), 1U) << "the same slot";
  digest.step(11 * facts::kSlot_ns);
  ASSERT_TRUE(told.read(value));
  EXPECT_EQ(value.sequence, 12U);
  EXPECT_EQ(value.stamp_ns, 11 * facts::kSlot_ns);
}

}  // namespace
}  // namespace gaitway::api
