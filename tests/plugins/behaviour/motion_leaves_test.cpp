// Motions and getting up: which is chosen, when it is left, and when it is given up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scripted_robot.hpp"

namespace gaitway::behaviour_leaves {
namespace {

using behaviour::NodeStatus;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::uint32_t kPlays = 2, kIsBeingLeft = 3;
constexpr std::uint32_t kToItsEnd = 1, kBrokenOff = 3;
constexpr double kOnFront_rad = 1.5, kOnBack_rad = -1.5;

TEST(PlayMotion, PlaysToTheEnd) {
  ScriptedRun run(R"(<PlayMotion motion="kick"/>)");
  EXPECT_EQ(run.tick(), NodeStatus::running);
  EXPECT_THAT(run.take_motions(), ElementsAre("kick"));
  run.answer_motion(kPlays);
  EXPECT_EQ(run.tick(), NodeStatus::running);
  run.end_motion(kToItsEnd);
  EXPECT_EQ(run.tick(), NodeStatus::success);
}

TEST(PlayMotion, FailsWithTheReasonForWhichItWasRefused) {
  ScriptedRun run(R"(<PlayMotion motion="kick"/>)");
  run.tick();
  run.refuse_motion("'kick' cannot begin: the robot walks");
  EXPECT_EQ(run.tick(), NodeStatus::failure);
  EXPECT_THAT(run.take_sayings(), ElementsAre("PlayMotion: 'kick' cannot begin: the robot walks"));
}

// A kick must not go on in a robot that falls, nor after it has got up.
TEST(PlayMotion, IsLeftInTheTickOfTheFallAndNotGoneOnWith) {
  ScriptedRun run(
      R"(<ReactiveFallback><Sequence><Fallen/><GetUp/></Sequence><PlayMotion motion="kick"/></ReactiveFallback>)");
  run.tick();
  run.answer_motion(kPlays);
  run.tick();
  run.take_motions();
  run.estimate.fall = estimate::fall::falls;
  run.tick();
  EXPECT_THAT(run.take_motions(), ElementsAre("(leave)"));
  run.answer_motion(kIsBeingLeft);
  run.lie(kOnFront_rad);
  EXPECT_EQ(run.tick_for(2.0), NodeStatus::running);
  EXPECT_THAT(run.take_motions(), ElementsAre()) << "getting up waits until it has been left";
  run.end_motion(2);
  run.tick_for(1.0);
  EXPECT_THAT(run.take_motions(), ElementsAre("get_up_front"));
}

TEST(PlayMotion, HaltedItIsLeftAndThatIsWaitedFor) {
  ScriptedRun run(R"(<PlayMotion motion="kick"/>)");
  run.tick();
  run.answer_motion(1);  // its approach can't be left
  run.tick();
  run.take_motions();
  EXPECT_FALSE(run.halt());
  run.answer_motion(1);
  for (int i = 0; i < 6; ++i) EXPECT_FALSE(run.halt());
  run.motion.state = kPlays;
  for (int i = 0; i < 6; ++i) EXPECT_FALSE(run.halt());
  EXPECT_GT(run.take_motions().size(), 2U) << "ordered anew until it shows";
  run.answer_motion(kIsBeingLeft);
  EXPECT_FALSE(run.halt());
  run.end_motion(2);
  bool has_ended = false;
  for (int i = 0; i < 4 && !has_ended; ++i) has_ended = run.halt();
  EXPECT_TRUE(has_ended);
}

TEST(GetUp, WaitsUntilItLiesStillAndChoosesTheSide) {
  for (const auto& [pitch_rad, name] :
       {std::pair{kOnFront_rad, "get_up_front"}, std::pair{kOnBack_rad, "get_up_back"}}) {
    ScriptedRun run("<GetUp/>");
    run.lie(pitch_rad);
    run.estimate.fall = estimate::fall::falls;
    EXPECT_EQ(run.tick_for(3.0), NodeStatus::running);
    run.lie(pitch_rad);
    run.estimate.angular_velocity[1] = 1.0;
    EXPECT_EQ(run.tick_for(3.0), NodeStatus::running);
    EXPECT_THAT(run.take_motions(), ElementsAre()) << "it rolls";
    run.estimate.angular_velocity[1] = 0.0;
    run.network.mode = network_state::mode::safe_tail;
    run.tick_for(3.0);
    EXPECT_THAT(run.take_motions(), ElementsAre()) << "a safe tail plays";
    run.network.mode = network_state::mode::holding;
    run.tick_for(1.0);
    EXPECT_THAT(run.take_motions(), ElementsAre(name));
  }
}

void be_up_for(ScriptedRun& run, double seconds) {
  for (double s = 0.0; s < seconds; s += 0.08) {  // whatever is ticked meanwhile
    run.now_ns += facts::kCycle_ns;
    run.look();
    run.robot->begin();
  }
}

void get_up(ScriptedRun& run, std::uint32_t result) {
  run.tick_for(0.9);
  run.answer_motion(kPlays);
  run.tick();
  run.end_motion(result);
}

// Readings of the fall go on for a while when the robot is up again: it must not get up once more.
TEST(GetUp, OldReadingsOfTheFallDoNotHaveItGetUpAgain) {
  ScriptedRun run("<GetUp/>");
  run.lie(kOnFront_rad);
  get_up(run, kToItsEnd);
  run.take_motions();
  EXPECT_EQ(run.tick_for(2.0), NodeStatus::running);
  EXPECT_THAT(run.take_motions(), ElementsAre());
  run.stand();
  EXPECT_EQ(run.tick_for(2.0), NodeStatus::success);
  EXPECT_THAT(run.take_motions(), ElementsAre());
}

TEST(GetUp, GivesUpAfterThreeAttemptsUntilItHasStood) {
  ScriptedRun run("<GetUp/>");
  run.lie(kOnBack_rad);
  NodeStatus status = NodeStatus::running;
  for (int attempt = 0; attempt < 3; ++attempt) {
    ASSERT_EQ(status, NodeStatus::running);
    get_up(run, kBrokenOff);
    status = run.tick();
  }
  EXPECT_EQ(status, NodeStatus::failure);
  EXPECT_THAT(run.take_motions(), ElementsAre("get_up_back", "get_up_back", "get_up_back"));
  EXPECT_THAT(run.take_sayings().back(), HasSubstr("gives up after 3 attempts"));
  for (int i = 0; i < 100; ++i) EXPECT_EQ(run.tick(), NodeStatus::failure);
  EXPECT_THAT(run.take_motions(), ElementsAre());
  EXPECT_THAT(run.take_sayings(), ElementsAre()) << "said once";

  run.stand();  // somebody has helped
  be_up_for(run, 4.0);
  run.lie(kOnFront_rad);
  EXPECT_EQ(run.tick_for(1.0), NodeStatus::running);
  EXPECT_THAT(run.take_motions(), ElementsAre("get_up_front"));
}

TEST(GetUp, StandsThatDoNotLastCountAsAttempts) {
  ScriptedRun run("<GetUp/>");
  for (int fall = 0; fall < 3; ++fall) {
    run.lie(kOnFront_rad);
    get_up(run, kToItsEnd);
    run.stand();
    EXPECT_EQ(run.tick_for(2.0), NodeStatus::success);
  }
  run.lie(kOnFront_rad);
  run.take_sayings();
  EXPECT_EQ(run.tick(), NodeStatus::failure);
  EXPECT_THAT(run.take_sayings(), ElementsAre(HasSubstr("gives up after 3 attempts: no stand has lasted")));
}

TEST(GetUp, AttemptsAreForgottenOnceItHasBeenUpForLong) {
  for (const std::uint32_t feet : {footstep_state::state::stands, footstep_state::state::other}) {
    ScriptedRun run("<GetUp/>");
    for (int fall = 0; fall < 5; ++fall) {
      run.lie(kOnFront_rad);
      get_up(run, kToItsEnd);
      run.stand();
      EXPECT_EQ(run.tick_for(2.0), NodeStatus::success) << fall;
      run.footsteps.state = feet;
      be_up_for(run, 3.5);
    }
  }
}

TEST(GetUp, CatchingItselfIsNoAttempt) {
  ScriptedRun run("<GetUp/>");
  for (int stumble = 0; stumble < 5; ++stumble) {
    run.estimate.fall = estimate::fall::falls;
    run.footsteps.state = footstep_state::state::other;
    EXPECT_EQ(run.tick_for(0.5), NodeStatus::running);
    run.stand();
    EXPECT_EQ(run.tick_for(2.0), NodeStatus::success);
  }
  EXPECT_THAT(run.take_motions(), ElementsAre());
  run.lie(kOnFront_rad);
  EXPECT_EQ(run.tick_for(1.0), NodeStatus::running);
  EXPECT_THAT(run.take_motions(), ElementsAre("get_up_front"));
}

TEST(GetUp, ARefusalIsAnAttempt) {
  ScriptedRun run(R"(<GetUp attempts="2"/>)");
  run.lie(kOnFront_rad);
  for (int attempt = 0; attempt < 2; ++attempt) {
    run.tick_for(0.9);
    run.refuse_motion("there is no motion 'get_up_front'");
  }
  EXPECT_EQ(run.tick(), NodeStatus::failure);
}

TEST(GetUp, OnItsSideItTriesBothInTurnTheLikelierFirst) {
  for (const double pitch_rad : {0.2, -0.2}) {
    ScriptedRun run("<GetUp/>");
    run.lie(pitch_rad);
    get_up(run, kBrokenOff);
    run.tick();
    run.tick_for(0.9);
    const std::vector<std::string> motions = run.take_motions();
    ASSERT_EQ(motions.size(), 2U);
    EXPECT_EQ(motions[0], pitch_rad > 0.0 ? "get_up_front" : "get_up_back");
    EXPECT_NE(motions[1], motions[0]);
  }
}

TEST(GetUp, OnItsFeetThereIsNothingToDo) {
  ScriptedRun run("<GetUp/>");
  EXPECT_EQ(run.tick_for(2.0), NodeStatus::success);
  EXPECT_THAT(run.take_motions(), ElementsAre());
}

}  // namespace
}  // namespace gaitway::behaviour_leaves
