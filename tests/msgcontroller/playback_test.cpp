// The running eight points, the prepared ones and the walk along the safe tail.
#include "gaitway/msgcontroller/playback.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace gaitway::msgcontroller {
namespace {

// One joint that climbs one count a point, from 1.
std::unique_ptr<CountPlan> ramp(std::uint32_t sequence, int points, int from) {
  auto plan = std::make_unique<CountPlan>();
  plan->sequence = sequence;
  plan->joint_count = 1;
  plan->point_count = points;
  for (int point = 0; point < points; ++point) {
    plan->count[static_cast<std::size_t>(point)][0] = from + point + 1;
    plan->support[static_cast<std::size_t>(point)] = 1;
  }
  return plan;
}

TEST(Playback, HoldsTheInitialCountUntilABatchRuns) {
  Playback playback(std::vector<std::int32_t>{42});
  playback.begin_cycle();
  EXPECT_FALSE(playback.running_segment().active);
  EXPECT_EQ(playback.expected_count(0, 5), 42);
  EXPECT_EQ(playback.support(), 2);
}

TEST(Playback, ABatchStartsWithTheNextCycleAndTogglesAlternate) {
  Playback playback(std::vector<std::int32_t>{0});
  playback.accept(*ramp(1, 8, 0));
  EXPECT_EQ(playback.waiting_delta(0, 0), 1);
  playback.begin_cycle();
  const bool first = playback.running_segment().toggle;
  EXPECT_EQ(playback.expected_count(0, 7), 8);
  playback.accept(*ramp(2, 8, 8));
  EXPECT_EQ(playback.waiting_delta(0, 0), 1);
  playback.begin_cycle();
  EXPECT_NE(playback.running_segment().toggle, first);
  EXPECT_EQ(playback.expected_count(0, 0), 9);
}

TEST(Playback, TheTailGoesOnToItsEndAndThenHolds) {
  Playback playback(std::vector<std::int32_t>{0});
  playback.accept(*ramp(1, 8 + 11, 0));
  playback.begin_cycle();
  ASSERT_TRUE(playback.prepare_from_tail());
  playback.begin_cycle();
  EXPECT_EQ(playback.expected_count(0, 7), 16);
  ASSERT_TRUE(playback.prepare_from_tail());
  EXPECT_EQ(playback.waiting_delta(0, 2), 1);
  EXPECT_EQ(playback.waiting_delta(0, 3), 0) << "past the tail's end the joint stands";
  playback.begin_cycle();
  EXPECT_FALSE(playback.prepare_from_tail());
  playback.begin_cycle();
  EXPECT_FALSE(playback.running_segment().active);
  EXPECT_EQ(playback.expected_count(0, 0), 19);
  EXPECT_EQ(playback.next_start()[0], 19);
}

// Two plans later it is still the first one's tail along which the joints went.
TEST(Playback, JointsThatWereLeftWentAlongTheTailOfWhatTheyPlayed) {
  const std::vector<std::int32_t> start(2, 0);
  Playback playback(start);
  const auto plan_of = [](std::uint32_t sequence, std::int32_t from) {
    CountPlan plan;
    plan.sequence = sequence;
    plan.joint_count = 2;
    plan.point_count = 3 * kBatchPoints;
    for (int point = 0; point < plan.point_count; ++point) {
      plan.count[static_cast<std::size_t>(point)].fill(from + point + 1);
    }
    return plan;
  };
  playback.accept(plan_of(1, 0));
  playback.begin_cycle();
  ASSERT_TRUE(playback.prepare_from_tail());
  playback.begin_cycle();
  playback.accept(plan_of(3, 1000));
  playback.leave_to_joints(8);
  for (int slot = 0; slot < kBatchPoints; ++slot) {
    EXPECT_EQ(playback.expected_count(0, slot), kBatchPoints + slot + 1);
  }
  EXPECT_TRUE(playback.left_to_joints());
  playback.begin_cycle();
  EXPECT_FALSE(playback.left_to_joints());
  EXPECT_EQ(playback.expected_count(1, 0), 2 * kBatchPoints);
  ASSERT_TRUE(playback.prepare_from_tail());
  EXPECT_EQ(playback.waiting_delta(0, 0), 1) << "the rest of the safe tail follows";
}

}  // namespace
}  // namespace gaitway::msgcontroller
