// A plan goes on only on top of an accepted batch; else the robot comes to its stand, and a new plan begins
// there.
#include "gaitway/trajectory/plan_continuity.hpp"

#include <gtest/gtest.h>

namespace gaitway::trajectory {
namespace {

constexpr Pose2 kHere{1.0, 0.0, 0.0}, kThere{2.0, 0.0, 0.0};

class Continuity : public ::testing::Test {
 protected:
  PlanContinuity continuity;
};

TEST_F(Continuity, StartsAnewFromTheOriginWhenHoldingAtStartUp) {
  EXPECT_EQ(continuity.decide(5, NetworkMode::holding, 0), PlanDecision::begin_anew);
  EXPECT_EQ(continuity.restart_stance().x_m, 0.0);
}

TEST_F(Continuity, WaitsUntilTheRobotHolds) {
  EXPECT_EQ(continuity.decide(5, NetworkMode::safe_tail, 3), PlanDecision::wait);
  EXPECT_EQ(continuity.decide(6, NetworkMode::emergency, 3), PlanDecision::wait);
  EXPECT_EQ(continuity.decide(7, NetworkMode::batches, 3), PlanDecision::wait);
  EXPECT_EQ(continuity.decide(8, NetworkMode::holding, 3), PlanDecision::begin_anew);
}

TEST_F(Continuity, ResumesWhenTheBatchBeforeWasAccepted) {
  continuity.published(5, kHere);
  EXPECT_EQ(continuity.decide(6, NetworkMode::holding, 5), PlanDecision::resume);
  continuity.published(6, kThere);
  EXPECT_EQ(continuity.decide(7, NetworkMode::batches, 6), PlanDecision::resume);
}

TEST_F(Continuity, RefusedBatchLeadsToTheStandOfTheLastAcceptedOne) {
  continuity.published(5, kHere);
  EXPECT_EQ(continuity.decide(6, NetworkMode::batches, 5), PlanDecision::resume);
  continuity.published(6, kThere);
  EXPECT_EQ(continuity.decide(7, NetworkMode::batches, 5), PlanDecision::wait);
  EXPECT_EQ(continuity.decide(8, NetworkMode::safe_tail, 5), PlanDecision::wait);
  EXPECT_EQ(continuity.decide(9, NetworkMode::holding, 5), PlanDecision::begin_anew);
  EXPECT_EQ(continuity.restart_stance().x_m, kHere.x_m);
}

TEST_F(Continuity, RefusedFirstBatchIsPlannedAnewAtOnce) {
  continuity.published(5, kHere);
  EXPECT_EQ(continuity.decide(6, NetworkMode::holding, 0), PlanDecision::begin_anew);
  EXPECT_EQ(continuity.restart_stance().x_m, 0.0);
}

TEST_F(Continuity, StopCommandThatPlaysAnAcceptedTailEndsInItsStance) {
  continuity.published(5, kHere);
  EXPECT_EQ(continuity.decide(6, NetworkMode::safe_tail, 5), PlanDecision::wait);
  EXPECT_EQ(continuity.decide(7, NetworkMode::holding, 5), PlanDecision::begin_anew);
  EXPECT_EQ(continuity.restart_stance().x_m, kHere.x_m);
}

TEST_F(Continuity, MissedCycleBreaksThePlan) {
  continuity.published(5, kHere);
  EXPECT_EQ(continuity.decide(7, NetworkMode::batches, 5), PlanDecision::wait);
  EXPECT_EQ(continuity.decide(8, NetworkMode::holding, 5), PlanDecision::begin_anew);
  EXPECT_EQ(continuity.restart_stance().x_m, kHere.x_m);
}

}  // namespace
}  // namespace gaitway::trajectory
