// Law, limit and fading of the trims.
#include "gaitway/stability/trim_feedback.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "test_robot.hpp"

namespace gaitway::stability {
namespace {

using test::kDefaults;

using msgclient::TrunkMotion;
using test::channel_of;
using test::humanoid;
using test::kLeftAnklePitch;

const std::size_t kLeftHipPitch = channel_of(humanoid(), 0, 2);

TrimFeedback in_full(std::size_t support, TrimCommand& command) {
  TrimFeedback feedback(humanoid(), kDefaults);
  for (int i = 0; i < 100; ++i) feedback.update(TrunkMotion{}, support, command);
  return feedback;
}

TEST(TrimFeedback, AnglesAreWhatThePublishedGainsGive) {
  std::mt19937 random(43);
  std::normal_distribution<double> angle(0.0, 0.05), rate(0.0, 0.3);
  for (std::size_t support = 0; support < 3; ++support) {
    TrimCommand command{};
    TrimFeedback feedback = in_full(support, command);
    for (int i = 0; i < 200; ++i) {
      const TrunkMotion motion{angle(random), angle(random), rate(random), rate(random)};
      feedback.update(motion, support, command);
      const auto direct = msgclient::trim_angles(msgclient::trim_gains(command), static_cast<int>(support),
                                                 motion, feedback.limit_rad());
      for (std::size_t c = 0; c < kTrimChannels; ++c) EXPECT_EQ(command.angle[c], direct[c]);
    }
  }
}

TEST(TrimFeedback, StanceAnkleFollowsTheWrittenLaw) {
  TrimCommand command{};
  TrimFeedback feedback = in_full(kLeftFoot, command);
  feedback.update(TrunkMotion{0.02, 0.04, -0.1, 0.2}, kLeftFoot, command);
  EXPECT_NEAR(command.angle[kLeftAnklePitch], 0.25 * 0.04 + 0.03 * 0.2, 1e-8);
  EXPECT_NEAR(command.angle[channel_of(humanoid(), 0, 5)], 0.25 * 0.02 - 0.06 * 0.1, 1e-8);
  EXPECT_EQ(command.angle[channel_of(humanoid(), 1, 4)], 0.0);
}

TEST(TrimFeedback, IsLimited) {
  TrimCommand command{};
  TrimFeedback feedback = in_full(kBothFeet, command);
  EXPECT_LE(feedback.limit_rad(), humanoid().trim.limit_rad);
  feedback.update(TrunkMotion{0.7, -0.7, 3.0, -3.0}, kBothFeet, command);
  EXPECT_DOUBLE_EQ(command.angle[kLeftAnklePitch], -feedback.limit_rad());
  for (const double angle : command.angle) EXPECT_LE(std::abs(angle), feedback.limit_rad());
}

TEST(TrimFeedback, FadesToZeroWithoutAStepAndComesBack) {
  TrimCommand command{};
  TrimFeedback feedback = in_full(kLeftFoot, command);
  const TrunkMotion motion{0.0, 0.08, 0.0, 0.0};
  feedback.update(motion, kLeftFoot, command);
  const double full = command.angle[kLeftAnklePitch];
  ASSERT_NEAR(full, 0.02, 1e-6);
  double last = full;
  for (int i = 0; i < 10; ++i) {
    feedback.update(std::nullopt, kBothFeet, command);
    EXPECT_LT(command.angle[kLeftAnklePitch], last);
    EXPECT_NEAR(last - command.angle[kLeftAnklePitch], full / 10.0, 1e-9);
    last = command.angle[kLeftAnklePitch];
  }
  EXPECT_NEAR(last, 0.0, 1e-12);
  feedback.update(std::nullopt, kBothFeet, command);
  EXPECT_EQ(command.angle[kLeftAnklePitch], 0.0);
  feedback.update(motion, kLeftFoot, command);
  EXPECT_NEAR(command.angle[kLeftAnklePitch], full / 10.0, 1e-9);
  for (int i = 0; i < 10; ++i) feedback.update(motion, kLeftFoot, command);
  EXPECT_NEAR(command.angle[kLeftAnklePitch], full, 1e-12);
}

TEST(TrimFeedback, HipsHelpInAStandButNotInTheDoubleSupportOfAStep) {
  TrimCommand command{};
  TrimFeedback feedback = in_full(kLeftFoot, command);
  const TrunkMotion motion{0.0, 0.08, 0.0, 0.0};
  for (int i = 0; i < 6; ++i) feedback.update(motion, kBothFeet, command);  // 60 ms
  EXPECT_EQ(command.angle[kLeftHipPitch], 0.0);
  EXPECT_NEAR(command.angle[kLeftAnklePitch], 0.02, 1e-6);
  for (int i = 0; i < 40; ++i) feedback.update(motion, kBothFeet, command);
  EXPECT_NEAR(command.angle[kLeftHipPitch], 0.012, 1e-6);
}

TEST(TrimFeedback, PublishesTheReferenceThatTheLawUses) {
  BalanceParameters parameters;
  parameters.attitude_reference_rad = {0.01, 0.03};
  TrimFeedback feedback(humanoid(), parameters);
  TrimCommand command{};
  for (int i = 0; i < 50; ++i) feedback.update(TrunkMotion{0.01, 0.03, 0.0, 0.0}, kBothFeet, command);
  EXPECT_NEAR(command.attitude_reference[1], 0.03, 1e-7);
  for (const double angle : command.angle) EXPECT_NEAR(angle, 0.0, 1e-8);
}

}  // namespace
}  // namespace gaitway::stability
