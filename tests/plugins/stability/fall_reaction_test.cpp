// When the joints are soft.
#include "gaitway/stability/fall_reaction.hpp"

#include <gtest/gtest.h>

namespace gaitway::stability {
namespace {

constexpr FallReaction::Plays kNothing{}, kMotionOnGround{.on_ground = true}, kPosture{.fall_posture = true};

TEST(FallReaction, IsSoftFromTheRecognitionOnAndWhileTheRobotLies) {
  const FallSoftness softness{.lying = 0.8, .posture = 0.3, .wait_s = 0.0};
  FallReaction reaction(softness);
  EXPECT_EQ(reaction.update(estimate::fall::upright, kNothing), 0.0);
  EXPECT_EQ(reaction.update(estimate::fall::falls, kNothing), 0.8);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(reaction.update(estimate::fall::lies, kNothing), 0.8);
  EXPECT_EQ(reaction.update(estimate::fall::upright, kNothing), 0.0);
}

TEST(FallReaction, StaysStiffEnoughForThePostureUntilTheRobotLies) {
  const FallSoftness softness{.lying = 1.0, .posture = 0.3, .wait_s = 0.1};
  FallReaction reaction(softness);
  for (int i = 0; i < 8; ++i)
    ASSERT_EQ(reaction.update(estimate::fall::falls, kNothing), 0.3) << "it may still come";
  for (int i = 0; i < 100; ++i) ASSERT_EQ(reaction.update(estimate::fall::falls, kPosture), 0.3);
  EXPECT_EQ(reaction.update(estimate::fall::lies, kPosture), 1.0);
  EXPECT_EQ(reaction.update(estimate::fall::upright, kPosture), 0.0);
}

TEST(FallReaction, WaitsForNoPostureInVain) {
  const FallSoftness softness{.lying = 1.0, .posture = 0.3, .wait_s = 0.1};
  FallReaction reaction(softness);
  for (int fall = 0; fall < 2; ++fall) {
    for (int i = 0; i < 10; ++i) ASSERT_EQ(reaction.update(estimate::fall::falls, kNothing), 0.3);
    ASSERT_EQ(reaction.update(estimate::fall::falls, kNothing), 1.0);
    ASSERT_EQ(reaction.update(estimate::fall::upright, kNothing), 0.0);
  }
}

TEST(FallReaction, JointsThatAreToStayStiffStaySo) {
  const FallSoftness softness{.lying = 0.0, .posture = 0.3, .wait_s = 0.1};
  FallReaction reaction(softness);
  EXPECT_EQ(reaction.update(estimate::fall::falls, kNothing), 0.0);
  EXPECT_EQ(reaction.update(estimate::fall::falls, kPosture), 0.0);
}

TEST(FallReaction, AMotionThatPlaysDuringTheFallDoesNotStiffen) {
  const FallSoftness softness{.lying = 1.0, .posture = 0.3, .wait_s = 0.0};
  FallReaction reaction(softness);
  EXPECT_EQ(reaction.update(estimate::fall::falls, kMotionOnGround), 1.0);
}

TEST(FallReaction, AMotionOnTheGroundStiffensUntilTheRobotStands) {
  const FallSoftness softness{.lying = 1.0, .posture = 0.3, .wait_s = 0.0};
  FallReaction reaction(softness);
  reaction.update(estimate::fall::lies, kNothing);
  EXPECT_EQ(reaction.update(estimate::fall::lies, kMotionOnGround), 0.0);
  for (int i = 0; i < 250; ++i)
    ASSERT_EQ(reaction.update(estimate::fall::lies, kNothing), 0.0) << "it rises on its feet";
  EXPECT_EQ(reaction.update(estimate::fall::upright, kNothing), 0.0);
  EXPECT_EQ(reaction.update(estimate::fall::falls, kNothing), 1.0) << "the next fall";
}

TEST(FallReaction, GettingUpThatFailsEndsSoft) {
  const FallSoftness softness{};
  FallReaction reaction(softness);
  reaction.update(estimate::fall::lies, kMotionOnGround);
  for (int i = 0; i < 299; ++i) ASSERT_EQ(reaction.update(estimate::fall::lies, kNothing), 0.0);
  EXPECT_EQ(reaction.update(estimate::fall::lies, kNothing), 1.0);
}

}  // namespace
}  // namespace gaitway::stability
