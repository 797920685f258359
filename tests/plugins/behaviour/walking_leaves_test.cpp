// Walks by velocities and ways: what is ordered, how they end, and that nothing goes on when they are halted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "scripted_robot.hpp"

namespace gaitway::behaviour_leaves {
namespace {

using behaviour::NodeStatus;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Walk, IsAskedForInEachTickUntilItsTimeIsOverAndThenStands) {
  ScriptedRun run(R"(<Walk forward="0.2 m/s" left="-5 cm/s" turn="10 deg/s" for="0.4 s"/>)");
  EXPECT_EQ(run.tick(), NodeStatus::running);
  ASSERT_TRUE(run.robot->orders.walking());
  EXPECT_DOUBLE_EQ(run.robot->orders.walking()->forward_m_per_s, 0.2);
  EXPECT_DOUBLE_EQ(run.robot->orders.walking()->left_m_per_s, -0.05);
  EXPECT_NEAR(run.robot->orders.walking()->turn_rad_per_s, 0.1745, 1e-3);
  run.footsteps.state = footstep_state::state::other;
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(run.tick(), NodeStatus::running);
    EXPECT_TRUE(run.robot->orders.walking());
  }
  for (int i = 0; i < 10; ++i) EXPECT_EQ(run.tick(), NodeStatus::running) << "still steps";
  EXPECT_FALSE(run.robot->orders.walking());
  run.stand();
  EXPECT_EQ(run.tick(), NodeStatus::success);
}

// A condition above a walk that is no longer true must end it: by itself nothing does.
TEST(Walk, EndsWhenWhatItDependsOnDoesNotHoldAnyMore) {
  ScriptedRun run(
      R"(<ReactiveSequence><SeesTag id="3" not_older="1 s"/><Walk forward="0.1 m/s"/></ReactiveSequence>)");
  run.see_tag(3, 2.0, 0.0);
  EXPECT_EQ(run.tick(), NodeStatus::running);
  EXPECT_TRUE(run.robot->orders.walking());
  run.footsteps.state = footstep_state::state::other;
  run.targets.count = 0;
  EXPECT_EQ(run.tick(), NodeStatus::running) << "its end takes ticks";
  EXPECT_FALSE(run.robot->orders.walking());
  EXPECT_EQ(run.tick_for(1.0), NodeStatus::running);
  run.stand();
  EXPECT_EQ(run.tick(), NodeStatus::failure);
}

// What comes next begins when the robot stands, not when the walk has been halted.
TEST(Walk, IsOverBeforeTheNextNodeBegins) {
  ScriptedRun run(
      R"(<Sequence><ForceSuccess><Timeout msec="300"><Walk forward="0.1 m/s"/></Timeout></ForceSuccess>
                     <PlayMotion motion="wave"/></Sequence>)");
  run.tick();
  run.footsteps.state = footstep_state::state::other;
  for (int i = 0; i < 20; ++i) EXPECT_EQ(run.tick(), NodeStatus::running);
  EXPECT_THAT(run.take_motions(), ElementsAre()) << "it still steps";
  run.stand();
  run.tick();
  EXPECT_THAT(run.take_motions(), ElementsAre("wave"));
}

// The walk begins some 0.1 s after its order: until then the robot still stands, and yet it is not over.
TEST(Walk, HaltedAtOnceItWaitsUntilItsOrderWouldHaveShown) {
  ScriptedRun run(R"(<Walk forward="0.1 m/s"/>)");
  run.tick();
  EXPECT_FALSE(run.halt());
  EXPECT_FALSE(run.halt());
  EXPECT_FALSE(run.halt());
  EXPECT_TRUE(run.halt());
}

TEST(Walk, FailsInAFall) {
  ScriptedRun run(R"(<Walk forward="0.1 m/s"/>)");
  run.tick();
  run.estimate.fall = estimate::fall::falls;
  EXPECT_EQ(run.tick(), NodeStatus::failure);
  EXPECT_FALSE(run.robot->orders.walking());
  EXPECT_THAT(run.take_sayings(), ElementsAre("Walk: the robot falls"));
}

TEST(Walk, HaltedWhileAPersonCommandsHasEnded) {
  ScriptedRun run(R"(<Walk forward="0.1 m/s"/>)");
  run.tick();
  run.footsteps.state = footstep_state::state::other;
  run.command.commander = command_state::commander::person;
  EXPECT_TRUE(run.halt()) << "it steps because the person has it walk";
}

TEST(TurnTo, TurnsTheShorterWayAndStandsWhereItFaces) {
  ScriptedRun run(R"(<TurnTo to="-150 deg" from="world" within="4 deg" rate="0.5 rad/s"/>)");
  run.estimate.odometry_base[2] = 170.0 * std::numbers::pi / 180.0;
  run.tick();
  ASSERT_TRUE(run.robot->orders.walking());
  EXPECT_GT(run.robot->orders.walking()->turn_rad_per_s, 0.0) << "40 degrees to the left";
  NodeStatus status = NodeStatus::running;
  for (int i = 0; i < 200 && status == NodeStatus::running; ++i) {
    const auto& walking = run.robot->orders.walking();
    run.footsteps.state = walking ? footstep_state::state::other : footstep_state::state::stands;
    if (walking) run.estimate.odometry_base[2] += walking->turn_rad_per_s * 0.08;
    status = run.tick();
  }
  EXPECT_EQ(status, NodeStatus::success);
  EXPECT_NEAR(wrapped_rad(run.estimate.odometry_base[2] + 150.0 * std::numbers::pi / 180.0), 0.0, 0.07);
}

TEST(WalkTo, OrdersAWayAndTellsWhatBecameOfIt) {
  ScriptedRun run(R"(<WalkTo x="1 m" y="-0.5 m" heading="90 deg"/>)");
  EXPECT_EQ(run.tick(), NodeStatus::running);
  ASSERT_TRUE(run.robot->orders.way());
  const WalkToRequest order = *run.robot->orders.way();
  EXPECT_TRUE((order.number & kBehaviourNumber) != 0);
  EXPECT_DOUBLE_EQ(order.goal[0], 1.0);
  EXPECT_DOUBLE_EQ(order.goal[1], -0.5);
  EXPECT_NEAR(order.goal[2], std::numbers::pi / 2.0, 1e-12);
  run.answer_way(navigation_state::state::walks);
  for (int i = 0; i < 30; ++i) EXPECT_EQ(run.tick(), NodeStatus::running);
  EXPECT_FALSE(run.robot->orders.way()) << "ordered once";
  run.answer_way(navigation_state::state::idle, navigation_state::result::arrived);
  EXPECT_EQ(run.tick(), NodeStatus::success);
}

TEST(WalkTo, FailsWithNavigationsReason) {
  ScriptedRun run(R"(<WalkTo x="1 m" y="0 m"/>)");
  run.tick();
  run.answer_way(navigation_state::state::idle, navigation_state::result::refused);
  std::strcpy(reinterpret_cast<char*>(run.navigation.text), "goal: a box stands there");
  EXPECT_EQ(run.tick(), NodeStatus::failure);
  EXPECT_THAT(run.take_sayings(), ElementsAre("WalkTo: goal: a box stands there"));
}

TEST(WalkTo, AnOrderThatNobodyAnswersFails) {
  ScriptedRun run(R"(<WalkTo x="1 m" y="0 m"/>)");
  EXPECT_EQ(run.tick_for(5.0), NodeStatus::failure);
  EXPECT_THAT(run.take_sayings(), ElementsAre(HasSubstr("has not answered")));
  ScriptedRun alone(R"(<WalkTo x="1 m" y="0 m"/>)");
  alone.has_navigation = false;
  EXPECT_EQ(alone.tick(), NodeStatus::failure);
}

TEST(WalkTo, HaltedItCancelsTheWayAndWaitsForTheStand) {
  ScriptedRun run(R"(<WalkTo x="1 m" y="0 m"/>)");
  run.tick();
  run.answer_way(navigation_state::state::walks);
  run.footsteps.state = footstep_state::state::follows;
  run.tick();
  EXPECT_FALSE(run.halt());
  ASSERT_TRUE(run.robot->orders.way());
  EXPECT_EQ(run.robot->orders.way()->cancel, 1U);
  for (int i = 0; i < 8; ++i) EXPECT_FALSE(run.halt());
  run.answer_way(navigation_state::state::idle, navigation_state::result::cancelled);
  EXPECT_FALSE(run.halt()) << "it still steps";
  run.stand();
  EXPECT_TRUE(run.halt());
}

TEST(WalkTo, ACancellationThatGotLostIsOrderedAgain) {
  ScriptedRun run(R"(<WalkTo x="1 m" y="0 m"/>)");
  run.tick();
  run.answer_way(navigation_state::state::walks);
  run.tick();
  EXPECT_FALSE(run.halt());
  const std::uint32_t first = run.robot->orders.way_number();
  for (int i = 0; i < 15; ++i) EXPECT_FALSE(run.halt());
  EXPECT_NE(run.robot->orders.way_number(), first);
}

TEST(WalkToTag, StandsBeforeItAndFollowsIt) {
  ScriptedRun run(R"(<WalkToTag id="7" distance="0.5 m"/>)");
  run.navigation.odometry[0] = 10.0;  // the frame odometry lies there, turned to the left
  run.navigation.odometry[2] = std::numbers::pi / 2.0;
  run.see_tag(7, 2.0, 0.0);
  const double h = std::sqrt(0.5);  // its face looks to -x: z of it is there
  for (int k = 0; k < 4; ++k)
    run.targets.orientation[0][k] = std::array{h, 0.0, -h, 0.0}[static_cast<std::size_t>(k)];
  run.tick();
  ASSERT_TRUE(run.robot->orders.way());
  EXPECT_NEAR(run.robot->orders.way()->goal[0], 10.0, 1e-9);
  EXPECT_NEAR(run.robot->orders.way()->goal[1], 1.5, 1e-9);
  EXPECT_NEAR(run.robot->orders.way()->goal[2], std::numbers::pi / 2.0, 1e-9) << "faces it";
  run.answer_way(navigation_state::state::walks);
  run.tick();
  EXPECT_FALSE(run.robot->orders.way());
  run.see_tag(7, 2.5, 0.0);
  run.tick();
  ASSERT_TRUE(run.robot->orders.way());
  EXPECT_NEAR(run.robot->orders.way()->goal[1], 2.0, 1e-9);
}

TEST(WalkTo, ATextWithoutAnEndIsReadToTheEndOfItsField) {
  ScriptedRun run(R"(<WalkTo x="1 m" y="0 m"/>)");
  run.tick();
  run.answer_way(navigation_state::state::idle, navigation_state::result::refused);
  std::memset(run.navigation.text, 'x', sizeof run.navigation.text);
  EXPECT_EQ(run.tick(), NodeStatus::failure);
  EXPECT_THAT(run.take_sayings(), ElementsAre(testing::MatchesRegex("WalkTo: x+")));
}

TEST(WalkTo, FailsWhereNavigationGoesSilent) {
  ScriptedRun run(R"(<WalkTo x="1 m" y="0 m"/>)");
  run.tick();
  run.answer_way(navigation_state::state::walks);
  run.tick();
  run.has_navigation = false;
  EXPECT_EQ(run.tick(), NodeStatus::failure);
  EXPECT_THAT(run.take_sayings(), ElementsAre(HasSubstr("silent")));
}

TEST(WalkTo, AWayThatIsGivenUpIsCancelled) {
  ScriptedRun run(R"(<WalkTo x="1 m" y="0 m"/>)");
  run.tick();
  run.answer_way(navigation_state::state::walks);
  run.tick();
  run.has_navigation = false;
  EXPECT_EQ(run.tick(), NodeStatus::failure);
  ASSERT_TRUE(run.robot->orders.way());
  EXPECT_EQ(run.robot->orders.way()->cancel, 1U) << "whoever comes back must not walk on";
}

TEST(WalkTo, HaltedItDoesNotWaitForEverForOneWhoDoesNotObey) {
  ScriptedRun run(R"(<WalkTo x="1 m" y="0 m"/>)");
  run.tick();
  run.answer_way(navigation_state::state::walks);
  run.tick();
  bool has_ended = false;
  double waited_s = 0.0;
  for (; !has_ended && waited_s < 30.0; waited_s += 0.08) has_ended = run.halt();
  EXPECT_TRUE(has_ended);
  EXPECT_GT(waited_s, 5.0);
  EXPECT_THAT(run.take_sayings(), ElementsAre(HasSubstr("does not end the way")));
}

TEST(WalkToTag, ATagThatIsForgottenBeforeItStandsFails) {
  ScriptedRun run(R"(<WalkToTag id="7" not_older="1 s"/>)");
  run.see_tag(7, 2.0, 0.0);
  run.footsteps.state = footstep_state::state::follows;
  EXPECT_EQ(run.tick(), NodeStatus::running);
  EXPECT_EQ(run.tick_for(3.0), NodeStatus::failure);
  EXPECT_THAT(run.take_sayings(), ElementsAre(HasSubstr("too long ago")));
}

TEST(SeesTag, OneThatWillBeSeenIsNotSeen) {
  ScriptedRun run(R"(<SeesTag id="7"/>)");
  run.see_tag(7, 2.0, 0.0);
  run.targets.seen_ns[0] += 10'000'000'000;
  EXPECT_EQ(run.tick(), NodeStatus::failure);
}

TEST(Walk, HaltedItWaitsForNobodyWhereNobodyPlansSteps) {
  ScriptedRun run(R"(<Walk forward="0.1 m/s"/>)");
  run.tick();
  run.plans_footsteps = false;
  EXPECT_TRUE(run.halt());
}

TEST(WalkToTag, ATagThatWasNeverSeenFails) {
  ScriptedRun run(R"(<WalkToTag id="7"/>)");
  EXPECT_EQ(run.tick(), NodeStatus::failure);
}

}  // namespace
}  // namespace gaitway::behaviour_leaves
