// When the joints are soft.
#include "gaitway/stability/fall_reaction.hpp"

#include <gtest/gtest.h>

namespace gaitway::stability {
namespace {

constexpr std::uint32_t kUpright = 0, kFalls = 1, kLies = 2;

TEST(FallReaction, IsSoftFromTheRecognitionOnAndWhileTheRobotLies) {
  FallReaction reaction(0.8);
  EXPECT_EQ(reaction.update(kUpright, false), 0.0);
  EXPECT_EQ(reaction.update(kFalls, false), 0.8);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(reaction.update(kLies, false), 0.8);
  EXPECT_EQ(reaction.update(kUpright, false), 0.0);
}

TEST(FallReaction, AMotionThatPlaysDuringTheFallDoesNotStiffen) {
  FallReaction reaction(1.0);
  EXPECT_EQ(reaction.update(kFalls, true), 1.0);
}

TEST(FallReaction, AMotionOnTheGroundStiffensUntilTheRobotStands) {
  FallReaction reaction(1.0);
  reaction.update(kLies, false);
  EXPECT_EQ(reaction.update(kLies, true), 0.0);
  for (int i = 0; i < 250; ++i) ASSERT_EQ(reaction.update(kLies, false), 0.0) << "it rises on its feet";
  EXPECT_EQ(reaction.update(kUpright, false), 0.0);
  EXPECT_EQ(reaction.update(kFalls, false), 1.0) << "the next fall";
}

TEST(FallReaction, GettingUpThatFailsEndsSoft) {
  FallReaction reaction(1.0);
  reaction.update(kLies, true);
  for (int i = 0; i < 299; ++i) ASSERT_EQ(reaction.update(kLies, false), 0.0);
  EXPECT_EQ(reaction.update(kLies, false), 1.0);
}

}  // namespace
}  // namespace gaitway::stability
