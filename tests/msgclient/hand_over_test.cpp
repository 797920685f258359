// Packing of hand-overs: what goes in comes out, and no damage goes unseen.
#include "gaitway/msgclient/hand_over.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

namespace gaitway::msgclient {
namespace {

using Random = std::mt19937;

int between(Random& random, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

void fill(HandOver& hand_over, Random& random) {
  std::normal_distribution<float> angle(0.0F, 1.0F);
  hand_over.sequence = static_cast<std::uint32_t>(random());
  hand_over.joint_count = static_cast<std::uint32_t>(between(random, 1, kMaxJoints));
  hand_over.point_count = static_cast<std::uint32_t>(between(random, kBatchPoints, kMaxPoints));
  hand_over.trim = {};
  hand_over.trim.channel_count = static_cast<std::uint32_t>(between(random, 0, kTrimChannels));
  for (float& reference : hand_over.trim.attitude_reference) {
    reference = angle(random);
  }
  for (auto& support : hand_over.trim.gain) {
    for (std::size_t c = 0; c < hand_over.trim.channel_count; ++c) {
      for (float& gain : support[c]) {
        gain = angle(random);
      }
    }
  }
  for (std::size_t i = 0; i < hand_over.point_count; ++i) {
    hand_over.support[i] = static_cast<std::uint8_t>(between(random, 0, 2));
  }
  for (std::size_t i = 0; i < hand_over.point_count * hand_over.joint_count; ++i) {
    hand_over.position[i] = angle(random);
  }
}

class HandOverProperty : public testing::TestWithParam<unsigned> {};

TEST_P(HandOverProperty, ComesOutAsItWentIn) {
  Random random(GetParam());
  const auto sent = std::make_unique<HandOver>();
  const auto received = std::make_unique<HandOver>();
  fill(*sent, random);
  std::vector<std::uint32_t> words(kMaxHandOverWords);
  const std::size_t used = encode(*sent, words);
  ASSERT_EQ(used, hand_over_words(sent->joint_count, sent->point_count, sent->trim.channel_count));
  ASSERT_EQ(decode(std::span(words).first(used), *received), DecodeStatus::whole);
  EXPECT_EQ(received->sequence, sent->sequence);
  EXPECT_EQ(received->joint_count, sent->joint_count);
  EXPECT_EQ(received->point_count, sent->point_count);
  EXPECT_EQ(received->trim, sent->trim);
  for (int point = 0; point < static_cast<int>(sent->point_count); ++point) {
    ASSERT_EQ(received->support[static_cast<std::size_t>(point)],
              sent->support[static_cast<std::size_t>(point)]);
    for (int joint = 0; joint < static_cast<int>(sent->joint_count); ++joint) {
      ASSERT_EQ(received->position_at(point, joint), sent->position_at(point, joint))
          << point << ", " << joint;
    }
  }
}

TEST_P(HandOverProperty, AnyDamageIsSeen) {
  Random random(GetParam() + 1000);
  const auto hand_over = std::make_unique<HandOver>();
  fill(*hand_over, random);
  std::vector<std::uint32_t> words(kMaxHandOverWords);
  words.resize(encode(*hand_over, words));
  const auto word = static_cast<std::size_t>(between(random, 0, static_cast<int>(words.size()) - 1));
  auto damaged = words;
  damaged[word] ^= 1u << between(random, 0, 31);  // one bit
  EXPECT_EQ(decode(damaged, *hand_over), DecodeStatus::corrupt) << "word " << word;
  damaged = words;
  damaged[word] ^= static_cast<std::uint32_t>(random()) | 1u;  // a burst of up to 32 bits
  EXPECT_EQ(decode(damaged, *hand_over), DecodeStatus::corrupt) << "word " << word;
  damaged = words;
  damaged.resize(word);  // cut off
  EXPECT_EQ(decode(damaged, *hand_over), DecodeStatus::corrupt) << "cut to " << word;
}

INSTANTIATE_TEST_SUITE_P(Seeds, HandOverProperty, testing::Range(1u, 41u));

TEST(HandOver, RefusesCountsOutOfRange) {
  const auto hand_over = std::make_unique<HandOver>();
  std::vector<std::uint32_t> words(kMaxHandOverWords);
  const auto with = [&](std::uint32_t joints, std::uint32_t points, std::uint32_t channels,
                        std::uint8_t support) {
    hand_over->joint_count = joints;
    hand_over->point_count = points;
    hand_over->trim.channel_count = channels;
    hand_over->support[3] = support;
    return encode(*hand_over, words);
  };
  EXPECT_GT(with(1, 8, 0, 0), 0u);
  EXPECT_EQ(with(64, 208, 8, 2), kMaxHandOverWords);
  EXPECT_EQ(with(0, 8, 0, 0), 0u);
  EXPECT_EQ(with(65, 8, 0, 0), 0u);
  EXPECT_EQ(with(1, 7, 0, 0), 0u);
  EXPECT_EQ(with(1, 209, 0, 0), 0u);
  EXPECT_EQ(with(1, 8, 9, 0), 0u);
  EXPECT_EQ(with(1, 8, 0, 3), 0u);
  hand_over->support[3] = 0;
  EXPECT_EQ(encode(*hand_over, std::span(words).first(hand_over_words(1, 8, 0) - 1)), 0u) << "no room";
}

TEST(HandOver, AValidChecksumDoesNotExcuseCountsThatDontFit) {
  const auto hand_over = std::make_unique<HandOver>();
  hand_over->joint_count = 2;
  hand_over->point_count = 8;
  std::vector<std::uint32_t> words(kMaxHandOverWords);
  words.resize(encode(*hand_over, words));
  words[2] = 3u | 8u << 16;  // claims three joints
  words.back() = crc32(std::span(words).first(words.size() - 1));
  EXPECT_EQ(decode(words, *hand_over), DecodeStatus::corrupt);
  words[2] = 2u | 4u << 12 | 8u << 16;  // a batch from its slot 4 on: there are none
  words.back() = crc32(std::span(words).first(words.size() - 1));
  EXPECT_EQ(decode(words, *hand_over), DecodeStatus::corrupt);
}

TEST(HandOver, IsMadeOfPlanAndTrim) {
  const auto plan = std::make_unique<JointPlan>();
  const auto hand_over = std::make_unique<HandOver>();
  plan->sequence = 5;
  plan->joint_count = 3;
  plan->tail_count = 2;
  plan->position[9][2] = 0.5F;
  plan->support[9] = 2;
  TrimCommand trim{};
  trim.channel_count = 8;
  trim.gain[2][7][3] = 0.125;
  ASSERT_TRUE(make_hand_over(*plan, trim, *hand_over));
  EXPECT_EQ(hand_over->sequence, 5u);
  EXPECT_EQ(hand_over->point_count, 10u);
  EXPECT_EQ(hand_over->position_at(9, 2), 0.5F);
  EXPECT_EQ(hand_over->support[9], 2);
  EXPECT_EQ(hand_over->trim.gain[2][7][3], 0.125F);
  plan->tail_count = kMaxTailPoints + 1;
  EXPECT_FALSE(make_hand_over(*plan, trim, *hand_over));
}

TEST(Crc32, GivesThePublishedCheckValue) {
  // zlib.crc32(b"12345678")
  const std::uint32_t words[] = {0x34333231u, 0x38373635u};
  EXPECT_EQ(crc32(words), 0x9AE0DAAFu);
  EXPECT_EQ(crc32({}), 0u);
}

TEST(TrimLaw, IsTheGainsTimesTheDeviation) {
  TrimGains gains;
  gains.channel_count = 2;
  gains.attitude_reference = {0.5F, -0.25F};
  gains.gain[1][0] = {1.0F, 2.0F, 4.0F, 8.0F};
  gains.gain[1][1] = {-1.0F, 0.0F, 0.0F, 0.0F};
  gains.gain[1][2] = {1.0F, 1.0F, 1.0F, 1.0F};
  const TrunkMotion motion{.roll = 0.75, .pitch = 0.0, .roll_rate = 0.125, .pitch_rate = -0.0625};
  const auto angles = trim_angles(gains, 1, motion, 10.0);
  EXPECT_DOUBLE_EQ(angles[0], 0.25 + 0.5 + 0.5 - 0.5);
  EXPECT_DOUBLE_EQ(angles[1], -0.25);
  EXPECT_EQ(angles[2], 0.0) << "not in use";
  EXPECT_EQ(trim_angles(gains, 0, motion, 10.0)[0], 0.0) << "each support has its own gains";
}

TEST(TrimLaw, IsLimitedAndNeverNotFinite) {
  TrimGains gains;
  gains.channel_count = 1;
  gains.gain[2][0] = {1.0F, 0.0F, 0.0F, 0.0F};
  EXPECT_EQ(trim_angles(gains, 2, {.roll = 1.0}, 0.1)[0], 0.1);
  EXPECT_EQ(trim_angles(gains, 2, {.roll = -1.0}, 0.1)[0], -0.1);
  EXPECT_EQ(trim_angles(gains, 2, {.roll = std::numeric_limits<double>::quiet_NaN()}, 0.1)[0], 0.0);
  EXPECT_EQ(trim_angles(gains, 3, {.roll = 1.0}, 0.1)[0], 0.0);
  EXPECT_EQ(trim_angles(gains, -1, {.roll = 1.0}, 0.1)[0], 0.0);
}

}  // namespace
}  // namespace gaitway::msgclient
