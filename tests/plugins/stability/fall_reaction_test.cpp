// When the joints are soft.
#include "gaitway/stability/fall_reaction.hpp"

#include <gtest/gtest.h>

namespace gaitway::stability {
namespace {

constexpr std::uint32_t kUpright = 0, kFalls = 1, kLies = 2;
constexpr FallReaction::Plays kNothing{}, kMotionOnGround{.on_ground = true}, kPosture{.fall_posture = true};

TEST(FallReaction, IsSoftFromTheRecognitionOnAndWhileTheRobotLies) {
  const FallSoftness softness{.lying = 0.8, .posture = 0.3, .wait_s = 0.0};
  FallReaction reaction(softness);
  EXPECT_EQ(reaction.update(kUpright, kNothing), 0.0);
  EXPECT_EQ(reaction.update(kFalls, kNothing), 0.8);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(reaction.update(kLies, kNothing), 0.8);
  EXPECT_EQ(reaction.update(kUpright, kNothing), 0.0);
}

TEST(FallReaction, StaysStiffEnoughForThePostureUntilTheRobotLies) {
  const FallSoftness softness{.lying = 1.0, .posture = 0.3, .wait_s = 0.1};
  FallReaction reaction(softness);
  for (int i = 0; i < 8; ++i) ASSERT_EQ(reaction.update(kFalls, kNothing), 0.3) << "it may still come";
  for (int i = 0; i < 100; ++i) ASSERT_EQ(reaction.update(kFalls, kPosture), 0.3);
  EXPECT_EQ(reaction.update(kLies, kPosture), 1.0);
  EXPECT_EQ(reaction.update(kUpright, kPosture), 0.0);
}

TEST(FallReaction, WaitsForNoPostureInVain) {
  const FallSoftness softness{.lying = 1.0, .posture = 0.3, .wait_s = 0.1};
  FallReaction reaction(softness);
  for (int fall = 0; fall < 2; ++fall) {
    for (int i = 0; i < 10; ++i) ASSERT_EQ(reaction.update(kFalls, kNothing), 0.3);
    ASSERT_EQ(reaction.update(kFalls, kNothing), 1.0);
    ASSERT_EQ(reaction.update(kUpright, kNothing), 0.0);
  }
}

TEST(FallReaction, JointsThatAreToStayStiffStaySo) {
  const FallSoftness softness{.lying = 0.0, .posture = 0.3, .wait_s = 0.1};
  FallReaction reaction(softness);
  EXPECT_EQ(reaction.update(kFalls, kNothing), 0.0);
  EXPECT_EQ(reaction.update(kFalls, kPosture), 0.0);
}

TEST(FallReaction, AMotionThatPlaysDuringTheFallDoesNotStiffen) {
  const FallSoftness softness{.lying = 1.0, .posture = 0.3, .wait_s = 0.0};
  FallReaction reaction(softness);
  EXPECT_EQ(reaction.update(kFalls, kMotionOnGround), 1.0);
}

TEST(FallReaction, AMotionOnTheGroundStiffensUntilTheRobotStands) {
  const FallSoftness softness{.lying = 1.0, .posture = 0.3, .wait_s = 0.0};
  FallReaction reaction(softness);
  reaction.update(kLies, kNothing);
  EXPECT_EQ(reaction.update(kLies, kMotionOnGround), 0.0);
  for (int i = 0; i < 250; ++i) ASSERT_EQ(reaction.update(kLies, kNothing), 0.0) << "it rises on its feet";
  EXPECT_EQ(reaction.update(kUpright, kNothing), 0.0);
  EXPECT_EQ(reaction.update(kFalls, kNothing), 1.0) << "the next fall";
}

TEST(FallReaction, GettingUpThatFailsEndsSoft) {
  const FallSoftness softness{};
  FallReaction reaction(softness);
  reaction.update(kLies, kMotionOnGround);
  for (int i = 0; i < 299; ++i) ASSERT_EQ(reaction.update(kLies, kNothing), 0.0);
  EXPECT_EQ(reaction.update(kLies, kNothing), 1.0);
}

}  // namespace
}  // namespace gaitway::stability
