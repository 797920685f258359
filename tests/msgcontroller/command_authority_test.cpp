// Who commands, event by event, and what must hold whatever comes in whatever order.
#include "gaitway/msgcontroller/command_authority.hpp"

#include <gtest/gtest.h>

#include <random>

namespace gaitway::msgcontroller {
namespace {

TEST(CommandAuthorityTest, APersonTakesTheCommandFromTheBehaviourAndGivesItBack) {
  CommandAuthority authority;
  EXPECT_EQ(authority.commander(), Commander::nobody);
  EXPECT_TRUE(authority.behaviour_commands());
  EXPECT_EQ(authority.commander(), Commander::behaviour);
  EXPECT_TRUE(authority.person_commands(CommandReason::person_orders));
  EXPECT_FALSE(authority.behaviour_commands());
  EXPECT_EQ(authority.commander(), Commander::person);
  EXPECT_TRUE(authority.person_lets_go());
  EXPECT_TRUE(authority.behaviour_commands());
}

TEST(CommandAuthorityTest, AfterAStopThePersonsEndNeitherItsLossGivesTheCommandBack) {
  CommandAuthority authority;
  authority.behaviour_commands();
  authority.person_stops();
  EXPECT_EQ(authority.reason(), CommandReason::person_stops);
  authority.person_is_lost();
  EXPECT_EQ(authority.reason(), CommandReason::person_stops) << "who has stopped has the last word";
  EXPECT_FALSE(authority.behaviour_commands());
  authority.behaviour_is_done();
  EXPECT_EQ(authority.commander(), Commander::person);
}

TEST(CommandAuthorityTest, AReleasedEmergencyStopLeavesTheCommandWithThePerson) {
  CommandAuthority authority;
  authority.behaviour_commands();
  authority.emergency_stop(true);
  EXPECT_FALSE(authority.person_commands(CommandReason::person_orders));
  EXPECT_FALSE(authority.person_lets_go());
  EXPECT_FALSE(authority.behaviour_commands());
  authority.emergency_stop(false);
  EXPECT_EQ(authority.commander(), Commander::person);
  EXPECT_EQ(authority.reason(), CommandReason::emergency_stop_released);
  EXPECT_FALSE(authority.behaviour_commands());
}

TEST(CommandAuthorityTest, AfterAFallUnderAPersonTheBehaviourMayGetTheRobotUpAndNoMore) {
  CommandAuthority authority;
  authority.person_commands(CommandReason::person_orders);
  authority.fall(true);
  EXPECT_TRUE(authority.may_get_up());
  EXPECT_FALSE(authority.behaviour_commands());
  authority.fall(false);
  EXPECT_TRUE(authority.may_get_up()) << "the motion goes on";
  authority.got_up();
  EXPECT_FALSE(authority.may_get_up());
}

TEST(CommandAuthorityTest, ARobotThatWasStoppedIsNotGotUpWhenItFalls) {
  CommandAuthority authority;
  authority.person_stops();
  authority.fall(true);
  EXPECT_FALSE(authority.may_get_up());
  authority.fall(false);
  authority.emergency_stop(true);
  authority.emergency_stop(false);
  authority.fall(true);
  EXPECT_FALSE(authority.may_get_up());
}

TEST(CommandAuthorityTest, AStopEndsTheRightToGetUp) {
  CommandAuthority authority;
  authority.person_commands(CommandReason::person_orders);
  authority.fall(true);
  authority.person_stops();
  EXPECT_FALSE(authority.may_get_up());
}

// A model of the promise beside it: between a stop and the next order of a person, or their letting go, the
// behaviour gets nothing.
TEST(CommandAuthorityTest, WhateverComesNothingGoesOnByItselfAfterAStop) {
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    std::mt19937 random(seed);
    CommandAuthority authority;
    bool stopped = false, emergency = false;
    for (int i = 0; i < 500; ++i) {
      switch (random() % 9) {
        case 0:
          stopped = !authority.person_commands(CommandReason::person_orders) && stopped;
          break;
        case 1:
          authority.person_stops();
          stopped = true;
          break;
        case 2:
          authority.person_is_lost();
          break;
        case 3:
          stopped = !authority.person_lets_go() && stopped;
          break;
        case 4:
          emergency = !emergency;
          authority.emergency_stop(emergency);
          stopped = true;
          break;
        case 5:
          authority.fall(random() % 2 == 0);
          break;
        case 6:
          authority.behaviour_is_done();
          break;
        case 7:
          authority.got_up();
          break;
        default:
          const bool may = authority.behaviour_commands();
          ASSERT_FALSE(may && (stopped || emergency)) << "seed " << seed << ", event " << i;
      }
      ASSERT_FALSE(authority.may_get_up() && stopped) << "seed " << seed << ", event " << i;
      ASSERT_EQ(authority.commander() == Commander::emergency_stop, emergency);
      ASSERT_FALSE(sentence(authority.commander(), authority.reason()).empty());
    }
  }
}

}  // namespace
}  // namespace gaitway::msgcontroller
