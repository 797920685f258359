// Whole frames and bits are two ways to the same course of events: whatever is sent and whatever goes wrong.
#include <gtest/gtest.h>

#include "../reference_wire.hpp"
#include "traffic.hpp"

namespace gaitway::can {
namespace {

constexpr int kStations = 7;
constexpr std::int64_t kPause_ns = 300'000;

// Draws something that goes wrong in the next while.
void disturb(SimulatedBus& bus, std::mt19937& random, std::int64_t now_ns) {
  const std::int64_t at_ns = now_ns + static_cast<std::int64_t>(random() % 300'000);
  const int station = static_cast<int>(random() % kStations);
  switch (random() % 40) {
    case 0:
      bus.jam(JamKind::noise, at_ns, static_cast<std::int64_t>(random() % 100'000));
      break;
    case 1:
      bus.jam(JamKind::stuck_dominant, at_ns, static_cast<std::int64_t>(random() % 60'000));
      break;
    case 2:
      bus.power_off(station, at_ns);
      bus.power_on(station, at_ns + static_cast<std::int64_t>(random() % 2'000'000));
      break;
    case 3:
      bus.force_bus_off(station, at_ns);
      break;
    case 4:
      bus.babble(station, numbered_frame(0x700 + static_cast<std::uint32_t>(station)), at_ns,
                 at_ns + 1'000'000);
      break;
    case 5:
      bus.abort(station);
      break;
    default:
      break;
  }
}

// Random traffic of all formats, offered at random times; `random_faults` and `disturbances` as said.
Trace run(SimulatedBus& bus, std::uint32_t seed, const RandomFaults& faults, bool disturbed) {
  attach(bus, kStations);
  bus.set_random_faults(faults);
  bus.set_clock_drift(2, 150.0);
  bus.set_clock_drift(4, -90.0);
  std::mt19937 random(seed);
  Trace trace;
  for (std::int64_t now_ns = 0; now_ns < 200'000'000; now_ns += kPause_ns) {
    Frame frame;
    std::int64_t since_ns = 0;
    for (int station = 0; station < kStations; ++station) {
      if (station > 0 && random() % 30 == 0) {
        frame.data[0] ^= random() % 2 == 0 ? std::uint8_t{0x10} : std::uint8_t{0};  // collides, or merges
      } else {
        frame = reference::draw_frame(random);
        frame.id = frame.id / kStations * kStations + static_cast<std::uint32_t>(station);
        frame.id = std::min(frame.id, frame.extended ? kLargestExtendedId : kLargestId);
        since_ns = now_ns + static_cast<std::int64_t>(random() % 100'000);
      }
      if (random() % 2 == 0) {
        bus.transmit(station, frame, since_ns);
      }
    }
    if (disturbed) {
      disturb(bus, random, now_ns);
    }
    trace.run(bus, now_ns + kPause_ns);
  }
  trace.run(bus, 300'000'000);  // nothing is left on the way
  return trace;
}

void expect_same(const Trace& a, const Trace& b) {
  ASSERT_EQ(a.deliveries.size(), b.deliveries.size());
  for (std::size_t i = 0; i < a.deliveries.size(); ++i) {
    const auto &one = a.deliveries[i], &other = b.deliveries[i];
    ASSERT_EQ(one.start_ns, other.start_ns) << i;
    ASSERT_EQ(one.end_ns, other.end_ns) << i;
    ASSERT_EQ(one.bits, other.bits) << i;
    ASSERT_EQ(one.sender, other.sender) << i;
    ASSERT_EQ(one.frame, other.frame) << i;
    ASSERT_EQ(one.lost, other.lost) << i;
    ASSERT_EQ(one.receivers, other.receivers) << i;
    ASSERT_EQ(one.senders, other.senders) << i;
  }
  ASSERT_EQ(a.errors.size(), b.errors.size());
  for (std::size_t i = 0; i < a.errors.size(); ++i) {
    ASSERT_EQ(a.errors[i].error_ns, b.errors[i].error_ns) << i;
    ASSERT_EQ(a.errors[i].kind, b.errors[i].kind) << i;
    ASSERT_EQ(a.errors[i].cause, b.errors[i].cause) << i;
    ASSERT_EQ(a.errors[i].sender_counters, b.errors[i].sender_counters) << i;
  }
  ASSERT_EQ(a.changes.size(), b.changes.size());
  for (std::size_t i = 0; i < a.changes.size(); ++i) {
    ASSERT_EQ(a.changes[i].time_ns, b.changes[i].time_ns) << i;
    ASSERT_EQ(a.changes[i].counters, b.changes[i].counters) << i;
  }
}

void expect_same(const BusStatistics& a, const BusStatistics& b) {
  EXPECT_EQ(a.frames, b.frames);
  EXPECT_EQ(a.busy_ns, b.busy_ns);
  EXPECT_EQ(a.retransmissions, b.retransmissions);
  EXPECT_EQ(a.collisions, b.collisions);
  EXPECT_EQ(a.eight_byte_us.count, b.eight_byte_us.count);
  EXPECT_DOUBLE_EQ(a.eight_byte_us.sum, b.eight_byte_us.sum);
  EXPECT_EQ(a.injected, b.injected);
}

class BusDetailTest : public testing::TestWithParam<std::uint32_t> {
 protected:
  Trace compare(const RandomFaults& faults, bool disturbed) {
    Trace trace = run(frames, GetParam(), faults, disturbed);
    expect_same(trace, run(bits, GetParam(), faults, disturbed));
    expect_same(frames.statistics(), bits.statistics());
    return trace;
  }
  SimulatedBus frames{1000, Detail::frames}, bits{1000, Detail::bits};
};

TEST_P(BusDetailTest, UndisturbedTrafficIsTheSame) {
  const Trace trace = compare({}, false);
  EXPECT_GT(trace.deliveries.size(), 1000U);
  EXPECT_GT(frames.statistics().merged + frames.statistics().collisions, 0U);
}

TEST_P(BusDetailTest, RandomFaultsAreTheSame) {
  const Trace trace =
      compare({.seed = GetParam(), .corruption = 0.02, .duplicate = 0.01, .omission = 0.01}, false);
  EXPECT_GT(trace.errors.size(), 30U);
}

TEST_P(BusDetailTest, WhateverHappensIsTheSame) {
  const Trace trace =
      compare({.seed = GetParam(), .corruption = 0.05, .duplicate = 0.02, .omission = 0.02}, true);
  EXPECT_GT(trace.changes.size(), 5U);
  const InjectedFaults& injected = frames.statistics().injected;
  EXPECT_GT(injected.jams * injected.power_offs * injected.babbled_frames * injected.forced_failures, 0U);
  // Times only go forward, and frames never overlap.
  std::int64_t before_ns = -1;
  for (const auto& delivery : trace.deliveries) {
    ASSERT_GT(delivery.start_ns, before_ns);
    before_ns = delivery.end_ns;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, BusDetailTest, testing::Range(1U, 13U));

}  // namespace
}  // namespace gaitway::can
