// When a set of frames is whole, and what it took.
#include "tools/bus/bus_measurement.hpp"

#include <gtest/gtest.h>

namespace gaitway::tools {
namespace {

constexpr std::int64_t kPeriod_ns = 80'000'000;

TEST(FrameSetMeter, ASetTakesTheSumOfItsFrames) {
  FrameSetMeter meter(3, kPeriod_ns);
  meter.take(1, 0, 100'000);
  meter.take(3, 500'000, 120'000);
  EXPECT_EQ(meter.bus_time_ms().count, 0U);
  meter.take(2, 900'000, 130'000);
  EXPECT_EQ(meter.bus_time_ms().count, 1U);
  EXPECT_DOUBLE_EQ(meter.bus_time_ms().mean(), 0.35);
  EXPECT_EQ(meter.back_to_back_ms().count, 0U) << "there were gaps";
  EXPECT_DOUBLE_EQ(meter.span_ms().max, 1.03);
}

TEST(FrameSetMeter, FramesWithoutGapsAreMeasuredFromTheFirstBitToTheLast) {
  FrameSetMeter meter(2, kPeriod_ns);
  meter.take(1, 7'000'000, 100'000);
  meter.take(2, 7'100'000, 120'000);
  EXPECT_EQ(meter.back_to_back_ms().count, 1U);
  EXPECT_DOUBLE_EQ(meter.back_to_back_ms().max, 0.22);
}

TEST(FrameSetMeter, ANodeThatComesAgainBeginsANewSet) {
  FrameSetMeter meter(2, kPeriod_ns);
  meter.take(1, 0, 100'000);
  meter.take(1, 80'000'000, 110'000);  // node 2's frame was lost
  meter.take(2, 80'110'000, 110'000);
  EXPECT_EQ(meter.incomplete(), 1U);
  EXPECT_EQ(meter.bus_time_ms().count, 1U);
  EXPECT_DOUBLE_EQ(meter.bus_time_ms().max, 0.22);
}

TEST(FrameSetMeter, WhoBeginsToListenInTheMiddleOfASetIsInStepWithTheNext) {
  FrameSetMeter meter(2, kPeriod_ns);
  meter.take(2, 0, 100'000);
  meter.take(1, 79'900'000, 100'000);
  meter.take(2, 80'000'000, 110'000);
  EXPECT_EQ(meter.incomplete(), 1U);
  EXPECT_EQ(meter.back_to_back_ms().count, 1U);
  EXPECT_DOUBLE_EQ(meter.span_ms().max, 0.21);
}

}  // namespace
}  // namespace gaitway::tools
