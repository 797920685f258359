// How the balance feedback's offsets come and go over batches and tails.
#include "gaitway/kinematics/correction_fade.hpp"
#include "gaitway/facts/facts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gaitway::kinematics {
namespace {

constexpr std::uint32_t kBatch = 8, kFadeTail = 100;
const BaseOffset kFirst{{0.008, -0.016}, {0.08, -0.04}};
const BaseOffset kSecond{{-0.008, 0.0}, {0.0, 0.0}};

void expect_offset(const BaseOffset& offset, double share_of_first) {
  EXPECT_TRUE(offset.com_m.isApprox(share_of_first * kFirst.com_m, 1e-12) || share_of_first == 0.0);
  EXPECT_NEAR(offset.com_m.x(), share_of_first * kFirst.com_m.x(), 1e-15);
  EXPECT_NEAR(offset.attitude_rad.x(), share_of_first * kFirst.attitude_rad.x(), 1e-15);
  EXPECT_NEAR(offset.attitude_rad.y(), share_of_first * kFirst.attitude_rad.y(), 1e-15);
}

TEST(CorrectionFade, ComesInLinearlyOverTheBatch) {
  CorrectionFade fade;
  fade.begin(5, kBatch, kFadeTail, kFirst);
  for (unsigned point = 0; point < kBatch; ++point) expect_offset(fade.at(point), (point + 1) / 8.0);
}

TEST(CorrectionFade, StaysForHalfTheTailAndIsGoneAtItsEnd) {
  CorrectionFade fade;
  fade.begin(5, kBatch, kFadeTail, kFirst);
  for (unsigned point = kBatch; point < kBatch + kFadeTail / 2; ++point) expect_offset(fade.at(point), 1.0);
  double last = 1.0;
  for (unsigned point = kBatch + kFadeTail / 2; point < kBatch + kFadeTail; ++point) {
    const double share = fade.at(point).com_m.x() / kFirst.com_m.x();
    EXPECT_LT(share, last);
    EXPECT_GT(share, last - 1.51 / (kFadeTail * 0.5)) << "no faster than one and a half times the mean";
    last = share;
  }
  EXPECT_EQ(fade.at(kBatch + kFadeTail - 1).com_m, Eigen::Vector2d::Zero());
  EXPECT_EQ(fade.at(kBatch + kFadeTail + 1000).attitude_rad, Eigen::Vector2d::Zero());
}

TEST(CorrectionFade, GoesOnFromTheBatchBefore) {
  CorrectionFade fade;
  fade.begin(5, kBatch, kFadeTail, kFirst);
  fade.begin(6, kBatch, kFadeTail, kSecond);
  EXPECT_NEAR(fade.at(0).com_m.x(), 0.008 + (-0.008 - 0.008) / 8.0, 1e-15);
  EXPECT_NEAR(fade.at(7).com_m.x(), -0.008, 1e-15);
}

TEST(CorrectionFade, BeginsTheSameBatchAgainWhereItBegan) {
  CorrectionFade fade;
  fade.begin(5, kBatch, kFadeTail, kFirst);
  fade.begin(6, kBatch, kFadeTail, kFirst);
  fade.begin(6, kBatch, kFadeTail, kSecond);
  EXPECT_NEAR(fade.at(0).com_m.x(), 0.008 + (-0.008 - 0.008) / 8.0, 1e-15);
}

TEST(CorrectionFade, GoesOnFromWhereTheTailIsWhenBatchesWereMissed) {
  CorrectionFade fade;
  fade.begin(5, kBatch, kFadeTail, kFirst);
  const double played = fade.at(10 * kBatch - 1).com_m.x();
  ASSERT_GT(played, 0.0);
  ASSERT_LT(played, 0.008);
  fade.begin(15, kBatch, kFadeTail, BaseOffset{});
  EXPECT_NEAR(fade.at(0).com_m.x(), played * 7.0 / 8.0, 1e-15);
  fade.begin(500, kBatch, kFadeTail, kFirst);
  EXPECT_NEAR(fade.at(0).com_m.x(), 0.001, 1e-15) << "the tail had ended long before";
}

// The tail brakes a bow, keeps it, and takes it back: no point of it is far from the ones beside it.
TEST(CorrectionFade, ABowComesIsBrakedAndGoesWithoutAJump) {
  constexpr double kPoint_s = facts::kSlot_s;
  constexpr std::uint32_t kShortTail = 48;  // of a stand
  CorrectionFade fade;
  fade.begin(5, kBatch, kShortTail, {{}, {}, {{{}, {0.12, 3.0}}}});
  fade.begin(6, kBatch, kShortTail, {{}, {}, {{{}, {0.36, 3.0}}}});
  double last_rad = 0.12, last_rate_rad_per_s = 3.0, highest_rad = 0.0;
  for (unsigned point = 0; point < kBatch + kShortTail + 10; ++point) {
    const double angle_rad = fade.at(point).bow[1].angle_rad;
    const double rate_rad_per_s = (angle_rad - last_rad) / kPoint_s;
    EXPECT_LT(std::abs(rate_rad_per_s), 4.0) << point;
    EXPECT_LT(std::abs(rate_rad_per_s - last_rate_rad_per_s), 0.8) << point;
    EXPECT_EQ(fade.at(point).bow[0].angle_rad, 0.0);
    highest_rad = std::max(highest_rad, angle_rad);
    last_rad = angle_rad;
    last_rate_rad_per_s = rate_rad_per_s;
  }
  EXPECT_NEAR(fade.at(kBatch - 1).bow[1].angle_rad, 0.36, 1e-12);
  EXPECT_NEAR(highest_rad, 0.48, 1e-3);
  EXPECT_EQ(last_rad, 0.0);
}

TEST(CorrectionFade, StartsAfreshWhenSequencesStartAfresh) {
  CorrectionFade fade;
  fade.begin(50, kBatch, kFadeTail, kFirst);
  fade.begin(1, kBatch, kFadeTail, kSecond);
  EXPECT_NEAR(fade.at(0).com_m.x(), -0.001, 1e-15);
}

TEST(CorrectionFade, KeepsTheTargetWithoutATail) {
  CorrectionFade fade;
  fade.begin(1, kBatch, 0, kFirst);
  expect_offset(fade.at(7), 1.0);
  expect_offset(fade.at(8), 1.0);
}

TEST(CorrectionFade, ATargetThatIsTooFarForABatchIsApproachedOverSeveral) {
  constexpr double kMost_rad_per_s = 3.0;
  CorrectionFade fade(kMost_rad_per_s);
  BaseOffset far;
  far.bow[1].angle_rad = 0.6;
  far.attitude_rad.x() = -0.4;
  double bow_rad = 0.0, roll_rad = 0.0;
  for (std::uint32_t sequence = 1; sequence <= 6; ++sequence) {
    fade.begin(sequence, kBatch, kFadeTail, far);
    for (unsigned point = 0; point < kBatch; ++point) {
      const BaseOffset now = fade.at(point);
      EXPECT_LE(std::abs(now.bow[1].angle_rad - bow_rad), kMost_rad_per_s * facts::kSlot_s + 1e-9);
      EXPECT_LE(std::abs(now.attitude_rad.x() - roll_rad), kMost_rad_per_s * facts::kSlot_s + 1e-9);
      bow_rad = now.bow[1].angle_rad;
      roll_rad = now.attitude_rad.x();
    }
  }
  EXPECT_NEAR(bow_rad, 0.6, 1e-9);
  EXPECT_NEAR(roll_rad, -0.4, 1e-9);
}

}  // namespace
}  // namespace gaitway::kinematics
