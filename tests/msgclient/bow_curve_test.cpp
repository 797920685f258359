// The curve of a bow: it begins and ends as asked, and goes on smoothly.
#include "gaitway/msgclient/bow_curve.hpp"
#include "gaitway/facts/facts.hpp"

#include <gtest/gtest.h>

#include <random>

namespace gaitway::msgclient {
namespace {

constexpr double kBatch_s = facts::kCycle_s;
constexpr double kMoment_s = 1e-6;

TEST(BowCurve, BeginsAndEndsAsAskedAndIsSmoothThroughoutForAnyBow) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> angle(-0.7, 0.7), rate(-6.0, 6.0);
  for (int round = 0; round < 200; ++round) {
    const Bow from{angle(random), rate(random)}, to{angle(random), rate(random)};
    EXPECT_NEAR(bow_at(from, to, 0.0, kBatch_s).angle_rad, from.angle_rad, 1e-12);
    EXPECT_NEAR(bow_at(from, to, 0.0, kBatch_s).rate_rad_per_s, from.rate_rad_per_s, 1e-12);
    EXPECT_NEAR(bow_at(from, to, kBatch_s, kBatch_s).angle_rad, to.angle_rad, 1e-12);
    EXPECT_NEAR(bow_at(from, to, kBatch_s, kBatch_s).rate_rad_per_s, to.rate_rad_per_s, 1e-12);
    for (double time_s = 0.0; time_s < 3.0 * kBatch_s; time_s += 0.0031) {
      const Bow before = bow_at(from, to, time_s, kBatch_s);
      const Bow after = bow_at(from, to, time_s + kMoment_s, kBatch_s);
      EXPECT_NEAR((after.angle_rad - before.angle_rad) / kMoment_s, before.rate_rad_per_s, 1e-2)
          << "the rate is the angle's, " << time_s << " s after the start";
      EXPECT_NEAR(after.rate_rad_per_s, before.rate_rad_per_s, 1e-2) << time_s;
    }
  }
}

TEST(BowCurve, ComesToRestWithinAnotherBatch) {
  const Bow end = bow_at({}, {0.1, 2.5}, 2.0 * kBatch_s, kBatch_s);
  EXPECT_NEAR(end.angle_rad, 0.1 + 0.5 * 2.5 * kBatch_s, 1e-12);
  EXPECT_EQ(end.rate_rad_per_s, 0.0);
  EXPECT_EQ(bow_at({}, {0.1, 2.5}, 10.0, kBatch_s).angle_rad, end.angle_rad);
}

}  // namespace
}  // namespace gaitway::msgclient
