// Bit timings for the clocks that microcontrollers have, and the table of them in docs/hardware.md.
#include "gaitway/firmware/bit_timing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace gaitway::firmware {
namespace {

TEST(BitTiming, EveryUsualClockGivesExactlyOneMegabit) {
  for (const std::uint32_t clock_MHz :
       {8U, 12U, 16U, 20U, 24U, 32U, 36U, 40U, 42U, 45U, 48U, 60U, 64U, 80U}) {
    const auto timing = bit_timing(clock_MHz * 1'000'000U);
    ASSERT_TRUE(timing) << clock_MHz;
    EXPECT_EQ(timing->prescaler * timing->quanta(), static_cast<int>(clock_MHz)) << clock_MHz;
    EXPECT_NEAR(timing->sample_point(), kSamplePoint, 0.02) << clock_MHz;
    EXPECT_GE(timing->segment_2, timing->jump_width) << clock_MHz;
    EXPECT_LE(timing->segment_1, 16) << clock_MHz;
    EXPECT_GT(timing->clock_tolerance(), 0.009) << clock_MHz;
  }
}

TEST(BitTiming, WhatIsNoMultipleOrTooSlowIsRefused) {
  EXPECT_FALSE(bit_timing(8'500'000));
  EXPECT_FALSE(bit_timing(7'000'000)) << "seven quanta";
  EXPECT_FALSE(bit_timing(29'000'000)) << "a prime: 29 quanta are too many for the registers";
  EXPECT_FALSE(bit_timing(16'000'000, 0));
  ASSERT_TRUE(bit_timing(16'000'000, 500'000));
  EXPECT_EQ(bit_timing(16'000'000, 500'000)->prescaler, 2);
}

// (1 + 11 + 4) quanta of 62.5 ns: 4 / (20 * 16) = 1.25 % and 4 / (2 * (13 * 16 - 4)) = 0.98 %.
TEST(BitTiming, ToleranceIsTheSmallerOfTheTwoConditions) {
  const BitTiming timing = *bit_timing(16'000'000);
  EXPECT_EQ(timing, (BitTiming{1, 11, 4, 4}));
  EXPECT_NEAR(timing.clock_tolerance(), 0.0098, 0.00005);
  EXPECT_NEAR((BitTiming{1, 11, 4, 1}).clock_tolerance(), 0.003125, 1e-9);
}

TEST(BitTiming, TheHardwarePagesTableIsTheirs) {
  std::ifstream file(GAITWAY_SOURCE_DIR "/docs/hardware.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const std::uint32_t clock_MHz : {8U, 16U, 24U, 36U, 40U, 42U, 45U, 48U, 80U}) {
    const BitTiming timing = *bit_timing(clock_MHz * 1'000'000U);
    std::ostringstream row;
    row.setf(std::ios::fixed);
    row.precision(1);
    row << "| " << clock_MHz << " | " << timing.prescaler << " | " << timing.segment_1 << " | "
        << timing.segment_2 << " | " << timing.jump_width << " | " << 100.0 * timing.sample_point() << " | "
        << std::lround(timing.propagation_ns(clock_MHz * 1e6)) << " |";
    EXPECT_NE(page.find(row.str()), std::string::npos) << row.str();
  }
}

}  // namespace
}  // namespace gaitway::firmware
