// Dead reckoning that drifts, measurements that are late, noisy or wrong.
#include "gaitway/navigation/pose_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace gaitway::navigation {
namespace {

using planning::Pose;
constexpr std::int64_t kSlot_ns = 10'000'000;

// The base on a circle: 0.2 m/s, 0.3 rad/s, as somebody outside sees it.
Pose on_circle(std::int64_t now_ns) {
  const double t_s = static_cast<double>(now_ns) * 1e-9, radius_m = 0.2 / 0.3;
  return {radius_m * std::sin(0.3 * t_s), radius_m * (1.0 - std::cos(0.3 * t_s)), 0.3 * t_s};
}

// Where the frame `odometry` lies in these tests.
const Pose kOdometry{1.5, -0.7, 2.0};

double off_m(const PoseFilter& filter, const Pose& odometry, const Pose& base) {
  return planning::way_m(filter.odometry().compose(base), odometry.compose(base));
}

TEST(PoseFilter, WithoutMeasurementsItBelievesItsStartAndEverLess) {
  PoseFilter filter(kOdometry, {});
  const double at_start_m = filter.deviation_m();
  for (std::int64_t now = 0; now < 5'000'000'000; now += kSlot_ns) filter.predict(now, on_circle(now));
  EXPECT_EQ(filter.odometry().x_m, kOdometry.x_m);
  EXPECT_EQ(filter.odometry().yaw_rad, kOdometry.yaw_rad);
  EXPECT_GT(filter.deviation_m(), 2.0 * at_start_m);
  EXPECT_NEAR(std::pow(filter.deviation_m(), 2), 0.005 * 0.005 + 0.02 * 0.02 * 1.0, 2e-5)
      << "after one metre";
}

// Ten a second, a tenth of a second old: each is held against where the base was then, 20 mm from where it
// is.
TEST(PoseFilter, FindsTheFrameFromLateAndNoisyMeasurements) {
  PoseFilter filter({1.45, -0.6, 1.9}, {.start_deviation_m = 0.1, .start_deviation_rad = 0.1});
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise;
  constexpr std::int64_t kDelay_ns = 100'000'000;
  for (std::int64_t now = 0; now < 8'000'000'000; now += kSlot_ns) {
    filter.predict(now, on_circle(now));
    if (now % 100'000'000 == 0 && now >= kDelay_ns) {
      Pose seen = kOdometry.compose(on_circle(now - kDelay_ns));
      seen = {seen.x_m + 0.005 * noise(random), seen.y_m + 0.005 * noise(random),
              seen.yaw_rad + 0.01 * noise(random)};
      EXPECT_TRUE(filter.correct(now - kDelay_ns, seen, 0.005, 0.01));
    }
  }
  EXPECT_LT(off_m(filter, kOdometry, on_circle(7'990'000'000)), 0.006);
  EXPECT_NEAR(planning::wrapped(filter.odometry().yaw_rad - kOdometry.yaw_rad), 0.0, 0.012);
  EXPECT_LT(filter.deviation_m(), 0.005);
}

TEST(PoseFilter, WhatIsOfNoUseChangesNothing) {
  PoseFilter filter(kOdometry, {});
  for (std::int64_t now = 0; now <= 3'000'000'000; now += kSlot_ns) filter.predict(now, on_circle(now));
  const Pose here = kOdometry.compose(on_circle(3'000'000'000));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(filter.correct(3'000'000'000, {kNan, 0.0, 0.0}, 0.01, 0.01));
  EXPECT_FALSE(filter.correct(3'000'000'000, here, 0.0, 0.01)) << "nothing is exact";
  EXPECT_FALSE(filter.correct(3'000'000'000, here, 0.01, kNan));
  EXPECT_FALSE(filter.correct(1'000'000'000, here, 0.01, 0.01)) << "older than what is remembered";
  EXPECT_EQ(filter.odometry().x_m, kOdometry.x_m);
}

// A reflection once is not believed; a robot that was carried elsewhere is, after a second.
TEST(PoseFilter, BelievesWhatIsFarOffOnlyWhenItInsists) {
  PoseFilter filter(kOdometry, {});
  const Pose away{kOdometry.x_m + 1.0, kOdometry.y_m, kOdometry.yaw_rad};
  filter.predict(0, {});
  for (int i = 1; i <= 12; ++i) {
    const std::int64_t now = i * 100'000'000;
    filter.predict(now, {});
    EXPECT_FALSE(filter.correct(now, i == 6 ? kOdometry : away, 0.01, 0.01) && i != 6) << i;
  }
  EXPECT_NEAR(filter.odometry().x_m, kOdometry.x_m, 0.01) << "the sixth was near, so the count began anew";
  for (int i = 13; i <= 17; ++i) {
    filter.predict(i * 100'000'000, {});
    filter.correct(i * 100'000'000, away, 0.01, 0.01);
  }
  EXPECT_NEAR(filter.odometry().x_m, away.x_m, 0.01);
}

}  // namespace
}  // namespace gaitway::navigation
