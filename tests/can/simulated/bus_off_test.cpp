// Bus-off on the simulated bus: the way there, the way back, and what the station's owner sees of it.
#include <gtest/gtest.h>

#include <algorithm>

#include "traffic.hpp"

namespace gaitway::can {
namespace {

constexpr std::int64_t kRecovery_ns = 128 * 11 * kBit_ns;

class BusOffTest : public testing::Test {
 protected:
  BusOffTest() { attach(bus, 4); }
  std::int64_t time_of(int station, BusState state) const {
    const auto found = std::find_if(trace.changes.begin(), trace.changes.end(), [&](const StateChange& c) {
      return c.station == station && c.state == state;
    });
    return found == trace.changes.end() ? -1 : found->time_ns;
  }
  SimulatedBus bus;
  Trace trace;
};

TEST_F(BusOffTest, ThirtyTwoFailuresOfOwnFramesTakeAtMost5312Microseconds) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SimulatedBus one;
    attach(one, 4);
    one.set_random_faults({.seed = seed});
    one.set_recovery(0, Recovery::on_request);
    const Frame longest{0x7C0, 8, {0x3C, 0x3C, 0x1F, 0x0F, 0x60, 0x83, 0xC3, 0xC3}};
    one.force_bus_off(0, 0);
    one.transmit(0, longest, 0);
    Trace course;
    course.run(one, 20'000'000);
    ASSERT_EQ(course.errors.size(), 32U);
    ASSERT_EQ(one.state(0), BusState::bus_off);
    ASSERT_EQ(one.error_counters(0).transmit, 256);
    ASSERT_EQ(course.changes.front().state, BusState::error_passive);
    ASSERT_EQ(course.changes.back().state, BusState::bus_off);
    ASSERT_LE(course.changes.back().time_ns, 5'312'000);
    ASSERT_GE(course.changes.back().time_ns, 32 * 40'000);
    EXPECT_EQ(one.statistics().injected.forced_failures, 32U);
    EXPECT_EQ(one.statistics().injected.forced_bus_offs, 1U);
    EXPECT_TRUE(one.transmit_pending(0)) << "its owner has to take it back";
    EXPECT_TRUE(one.abort(0));
  }
}

// The line is dominant until long after the station is off: the recessive bits begin with the jam's end.
TEST_F(BusOffTest, ABusOffStationComesBackAfter128Times11RecessiveBits) {
  bus.transmit(0, numbered_frame(0x100), 0);
  bus.jam(JamKind::stuck_dominant, 40'000, 460'000);
  trace.run(bus, 10'000'000);
  EXPECT_GT(time_of(0, BusState::bus_off), 0);
  EXPECT_LT(time_of(0, BusState::bus_off), 500'000);
  EXPECT_EQ(time_of(0, BusState::error_active), 500'000 + kRecovery_ns);
  ASSERT_EQ(trace.deliveries.size(), 1U) << "its owner has not taken it back";
  EXPECT_EQ(trace.deliveries[0].start_ns, 500'000 + kRecovery_ns);
  EXPECT_EQ(bus.error_counters(0), ErrorCounters{});
  EXPECT_EQ(bus.statistics().bus_offs, 1U);
  EXPECT_EQ(bus.statistics().recoveries, 1U);
  EXPECT_EQ(bus.statistics().injected.jammed_frames, 1U);
}

TEST_F(BusOffTest, OnRequestAStationComesBackOnlyWhenAsked) {
  bus.set_recovery(0, Recovery::on_request);
  EXPECT_FALSE(bus.recover(0)) << "it is not bus-off";
  bus.transmit(0, numbered_frame(0x100), 0);
  bus.jam(JamKind::stuck_dominant, 40'000, 460'000);
  trace.run(bus, 50'000'000);
  EXPECT_EQ(bus.state(0), BusState::bus_off);
  EXPECT_TRUE(bus.abort(0));
  EXPECT_TRUE(bus.recover(0));
  EXPECT_FALSE(bus.recover(0)) << "it is already on its way";
  trace.run(bus, 50'000'000 + kRecovery_ns - 1);
  EXPECT_EQ(bus.state(0), BusState::bus_off);
  trace.run(bus, 50'000'000 + kRecovery_ns);
  EXPECT_EQ(bus.state(0), BusState::error_active);
  EXPECT_TRUE(trace.deliveries.empty());
}

// Between two frames that follow each other without a pause there are exactly 11 recessive bits: ACK
// delimiter, end of frame, intermission.
TEST_F(BusOffTest, OnABusWithoutPauseRecoveryTakes128Frames) {
  bus.force_bus_off(0, 0);
  bus.transmit(0, numbered_frame(0x001), 0);
  bus.transmit(1, numbered_frame(0x100), 0);
  trace.run(bus, 60'000'000, [&](const SimulatedBus::Delivery& delivery) {
    bus.transmit(1, numbered_frame(0x100), delivery.end_ns);
  });
  const std::int64_t off_ns = time_of(0, BusState::bus_off);
  const auto back = std::find_if(trace.changes.begin(), trace.changes.end(), [&](const StateChange& c) {
    return c.station == 0 && c.state == BusState::error_active;
  });
  ASSERT_NE(back, trace.changes.end());
  const auto between = std::count_if(trace.deliveries.begin(), trace.deliveries.end(), [&](const auto& d) {
    return d.start_ns > off_ns && d.end_ns < back->time_ns;
  });
  EXPECT_EQ(between, 127) << "the first eleven are those behind the last error flag";
  const auto next = std::find_if(trace.deliveries.begin(), trace.deliveries.end(),
                                 [&](const auto& d) { return d.start_ns >= back->time_ns; });
  ASSERT_NE(next, trace.deliveries.end());
  EXPECT_EQ(next->sender, 0);
  EXPECT_EQ(next->start_ns, back->time_ns);
  for (const auto& delivery : trace.deliveries) {
    const bool off = delivery.start_ns > off_ns && delivery.end_ns < back->time_ns;
    EXPECT_EQ(delivery.received_by(0), !off && delivery.sender != 0) << delivery.start_ns;
  }
}

// SOF to the stuff error is 6 bits, the flag 6 more; then every station finds the next bit dominant (+8), and
// every eighth (+8).
TEST_F(BusOffTest, AStuckLineRaisesReceiveCountersAsTheStandardSays) {
  bus.jam(JamKind::stuck_dominant, 100'000, (6 + 6 + 24) * kBit_ns);
  trace.run(bus, 1'000'000);
  for (int station = 0; station < 4; ++station) {
    EXPECT_EQ(bus.error_counters(station), (ErrorCounters{0, 1 + 8 + 3 * 8}));
  }
  ASSERT_EQ(trace.errors.size(), 1U);
  EXPECT_EQ(trace.errors[0].cause, FaultCause::jam);
  EXPECT_EQ(trace.errors[0].sender, -1);
  EXPECT_EQ(trace.errors[0].error_ns, 106'000);
  EXPECT_EQ(bus.statistics().busy_ns, (36 + 8 + 3) * kBit_ns);
}

TEST_F(BusOffTest, AStuckLineTakesASenderOffTheBusButNeverAReceiver) {
  bus.set_recovery(2, Recovery::on_request);
  bus.transmit(2, numbered_frame(0x2AA), 0);
  bus.jam(JamKind::stuck_dominant, 30'000, 5'000'000);
  trace.run(bus, 10'000'000);
  EXPECT_EQ(bus.state(2), BusState::bus_off);
  for (const int station : {0, 1, 3}) {
    EXPECT_EQ(bus.state(station), BusState::error_passive);
    EXPECT_EQ(bus.error_counters(station).transmit, 0);
  }
  // One received frame makes them active again.
  bus.transmit(3, numbered_frame(0x100), 10'000'000);
  trace.run(bus, 11'000'000);
  EXPECT_EQ(bus.state(0), BusState::error_active);
  EXPECT_EQ(bus.error_counters(0).receive, 127);
}

TEST_F(BusOffTest, AnOwnerLearnsOfEachChangeOnce) {
  bus.force_bus_off(1, 0);
  bus.transmit(1, numbered_frame(0x100), 0);
  trace.run(bus, 20'000'000);
  std::vector<BusState> states;
  for (const StateChange& change : trace.changes) {
    EXPECT_EQ(change.station, 1);
    states.push_back(change.state);
  }
  EXPECT_EQ(states, (std::vector{BusState::error_passive, BusState::bus_off, BusState::error_active}));
}

}  // namespace
}  // namespace gaitway::can
