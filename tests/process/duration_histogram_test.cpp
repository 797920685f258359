// Percentiles against sorted durations.
#include "gaitway/process/duration_histogram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace gaitway::process {
namespace {

TEST(DurationHistogram, IsEmptyAtFirst) {
  const DurationHistogram histogram;
  EXPECT_EQ(histogram.percentile_ns(0.5), 0.0);
  EXPECT_EQ(histogram.summary().max, 0.0);
}

TEST(DurationHistogram, PercentilesAreWithinThreePercent) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(1.0, 9.0);
  DurationHistogram histogram;
  std::vector<std::int64_t> durations;
  for (int i = 0; i < 20000; ++i) {
    durations.push_back(static_cast<std::int64_t>(std::pow(10.0, exponent(random))));
    histogram.add(durations.back());
  }
  std::sort(durations.begin(), durations.end());
  for (const double share : {0.01, 0.25, 0.5, 0.9, 0.99}) {
    const auto exact = static_cast<double>(durations[static_cast<std::size_t>(share * 20000.0)]);
    EXPECT_NEAR(histogram.percentile_ns(share), exact, exact / 32.0 + 1.0) << share;
  }
  EXPECT_EQ(histogram.max_ns(), durations.back());
  EXPECT_EQ(histogram.percentile_ns(1.0), static_cast<double>(durations.back()));
}

TEST(DurationHistogram, TakesAnyDuration) {
  DurationHistogram histogram;
  for (const std::int64_t duration : {std::int64_t{-5}, std::int64_t{0}, std::int64_t{31}, std::int64_t{32},
                                      std::int64_t{63}, std::int64_t{64}, INT64_MAX}) {
    histogram.add(duration);
  }
  EXPECT_EQ(histogram.count(), 7U);
  EXPECT_EQ(histogram.percentile_ns(0.5), 32.0);
  EXPECT_EQ(histogram.max_ns(), INT64_MAX);
}

}  // namespace
}  // namespace gaitway::process
