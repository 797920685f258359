// Stamps of a controller's drifting clock, brought into the robot's.
#include "gaitway/can/hardware_clock.hpp"

#include <gtest/gtest.h>

#include <random>

namespace gaitway::can {
namespace {

constexpr std::int64_t kShortestLatency_ns = 12'000;

// Frames every 400 us for two seconds: the kernel stamps each after a latency of 12 us and more.
struct Deviation {
  std::int64_t earliest_ns = 0, latest_ns = 0;
};
Deviation deviation(double drift_ppm, std::int64_t offset_ns) {
  std::mt19937 random(7);
  std::exponential_distribution<double> latency_ns(1.0 / 60'000.0);
  HardwareClock clock;
  Deviation worst;
  for (std::int64_t true_ns = 0; true_ns < 2'000'000'000; true_ns += 400'000) {
    const std::int64_t hardware_ns =
        offset_ns + true_ns + static_cast<std::int64_t>(static_cast<double>(true_ns) * drift_ppm * 1e-6);
    const std::int64_t kernel_ns =
        true_ns + kShortestLatency_ns + static_cast<std::int64_t>(latency_ns(random));
    const std::int64_t result_ns = clock.convert(hardware_ns, kernel_ns);
    EXPECT_LE(result_ns, kernel_ns);
    if (true_ns > 500'000'000) {
      worst.earliest_ns = std::min(worst.earliest_ns, result_ns - true_ns);
      worst.latest_ns = std::max(worst.latest_ns, result_ns - true_ns);
    }
  }
  return worst;
}

TEST(HardwareClock, TheKernelsLatencyIsTakenOut) {
  for (const double drift_ppm : {-50.0, 0.0, 50.0}) {
    const Deviation worst = deviation(drift_ppm, 5'000'000'000'000);
    EXPECT_GE(worst.earliest_ns, -26'000) << "half a second of drift at most " << drift_ppm;
    EXPECT_LE(worst.latest_ns, kShortestLatency_ns + 20'000) << drift_ppm;
  }
}

TEST(HardwareClock, AClockThatWasSetIsFollowedAtOnce) {
  HardwareClock clock;
  EXPECT_EQ(clock.convert(1'000, 50'000'000'000), 50'000'000'000);
  EXPECT_EQ(clock.convert(101'000, 50'000'300'000), 50'000'100'000);
  EXPECT_EQ(clock.convert(7'000'000'000'000, 50'100'000'000), 50'100'000'000) << "forwards";
  EXPECT_EQ(clock.convert(20, 50'200'000'000), 50'200'000'000) << "backwards";
  EXPECT_EQ(clock.convert(100'020, 50'200'900'000), 50'200'100'000);
}

}  // namespace
}  // namespace gaitway::can
