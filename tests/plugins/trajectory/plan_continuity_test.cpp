// A plan goes on only on top of an accepted batch; else the robot comes to its stand, and a new plan begins
// there.
#include "gaitway/trajectory/plan_continuity.hpp"

#include <gtest/gtest.h>

namespace gaitway::trajectory {
namespace {

constexpr Pose2 kHere{1.0, 0.0, 0.0}, kThere{2.0, 0.0, 0.0};

class Continuity : public ::testing::Test {
 protected:
  PlanDecision decide(std::uint32_t sequence, std::uint32_t mode, std::uint32_t accepted_sequence) {
    NetworkState network{};
    network.mode = mode;
    network.accepted_sequence = accepted_sequence;
    return continuity.decide(sequence, network);
  }

  PlanContinuity continuity;
};

TEST_F(Continuity, StartsAnewFromTheOriginWhenHoldingAtStartUp) {
  EXPECT_EQ(decide(5, network_state::mode::holding, 0), PlanDecision::begin_anew);
  EXPECT_EQ(continuity.restart_stance().x_m, 0.0);
}

TEST_F(Continuity, WaitsUntilTheRobotHolds) {
  EXPECT_EQ(decide(5, network_state::mode::safe_tail, 3), PlanDecision::wait);
  EXPECT_EQ(decide(6, network_state::mode::emergency_stop, 3), PlanDecision::wait);
  EXPECT_EQ(decide(7, network_state::mode::batches, 3), PlanDecision::wait);
  EXPECT_EQ(decide(8, network_state::mode::holding, 3), PlanDecision::begin_anew);
}

TEST_F(Continuity, ResumesWhenTheBatchBeforeWasAccepted) {
  continuity.published(5, kHere);
  EXPECT_EQ(decide(6, network_state::mode::holding, 5), PlanDecision::resume);
  continuity.published(6, kThere);
  EXPECT_EQ(decide(7, network_state::mode::batches, 6), PlanDecision::resume);
}

TEST_F(Continuity, RefusedBatchLeadsToTheStandOfTheLastAcceptedOne) {
  continuity.published(5, kHere);
  EXPECT_EQ(decide(6, network_state::mode::batches, 5), PlanDecision::resume);
  continuity.published(6, kThere);
  EXPECT_EQ(decide(7, network_state::mode::batches, 5), PlanDecision::wait);
  EXPECT_EQ(decide(8, network_state::mode::safe_tail, 5), PlanDecision::wait);
  EXPECT_EQ(decide(9, network_state::mode::holding, 5), PlanDecision::begin_anew);
  EXPECT_EQ(continuity.restart_stance().x_m, kHere.x_m);
}

TEST_F(Continuity, RefusedFirstBatchIsPlannedAnewAtOnce) {
  continuity.published(5, kHere);
  EXPECT_EQ(decide(6, network_state::mode::holding, 0), PlanDecision::begin_anew);
  EXPECT_EQ(continuity.restart_stance().x_m, 0.0);
}

TEST_F(Continuity, StopCommandThatPlaysAnAcceptedTailEndsInItsStance) {
  continuity.published(5, kHere);
  EXPECT_EQ(decide(6, network_state::mode::safe_tail, 5), PlanDecision::wait);
  EXPECT_EQ(decide(7, network_state::mode::holding, 5), PlanDecision::begin_anew);
  EXPECT_EQ(continuity.restart_stance().x_m, kHere.x_m);
}

TEST_F(Continuity, MissedCycleBreaksThePlan) {
  continuity.published(5, kHere);
  EXPECT_EQ(decide(7, network_state::mode::batches, 5), PlanDecision::wait);
  EXPECT_EQ(decide(8, network_state::mode::holding, 5), PlanDecision::begin_anew);
  EXPECT_EQ(continuity.restart_stance().x_m, kHere.x_m);
}

}  // namespace
}  // namespace gaitway::trajectory
