// Faults injected into the simulated bus: each does what it says, and the counters tell what was really done.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "traffic.hpp"

namespace gaitway::can {
namespace {

constexpr int kInjectedStations = 6;

class BusInjectionTest : public testing::Test {
 protected:
  BusInjectionTest() { attach(bus, kInjectedStations); }
  SimulatedBus bus;
  Trace trace;
};

TEST_F(BusInjectionTest, NoiseDestroysTheFrameOnTheWireAndElevenBitsOfSilenceFollow) {
  bus.transmit(0, numbered_frame(0x100), 0);
  bus.transmit(1, numbered_frame(0x200), 0);
  bus.jam(JamKind::noise, 50'000, 2'000'000);
  trace.run(bus, 10'000'000);
  ASSERT_EQ(trace.errors.size(), 1U);
  EXPECT_EQ(trace.errors[0].cause, FaultCause::jam);
  EXPECT_EQ(trace.errors[0].sender, 0);
  ASSERT_EQ(trace.deliveries.size(), 2U);
  EXPECT_EQ(trace.deliveries[0].start_ns, 2'050'000 + 11 * kBit_ns);
  EXPECT_EQ(trace.deliveries[0].frame.id, 0x100U);
  EXPECT_EQ(bus.error_counters(0).transmit, 7) << "one error, however long the noise";
  EXPECT_EQ(bus.statistics().injected.jams, 1U);
  EXPECT_EQ(bus.statistics().injected.jammed_frames, 1U);
  EXPECT_EQ(bus.statistics().retransmissions, 1U);
}

TEST_F(BusInjectionTest, NoiseOnAnIdleBusOnlyDelays) {
  bus.jam(JamKind::noise, 50'000, 100'000);
  trace.run(bus, 100'000);
  bus.transmit(0, numbered_frame(0x100), 100'000);
  trace.run(bus, 1'000'000);
  EXPECT_TRUE(trace.errors.empty());
  ASSERT_EQ(trace.deliveries.size(), 1U);
  EXPECT_EQ(trace.deliveries[0].start_ns, 161'000);
  EXPECT_EQ(bus.error_counters(0), ErrorCounters{});
  EXPECT_EQ(bus.statistics().injected.jammed_frames, 0U);
}

TEST_F(BusInjectionTest, ABabblingStationStarvesLowerPrioritiesForItsTime) {
  const auto refill = [&](const SimulatedBus::Delivery& delivery) {
    if (delivery.sent_by(1)) {
      bus.transmit(1, numbered_frame(0x100), delivery.end_ns);
    }
  };
  bus.transmit(1, numbered_frame(0x100), 0);
  bus.babble(3, numbered_frame(0x00F), 1'000'000, 3'000'000);
  trace.run(bus, 5'000'000, refill);
  std::uint64_t babbled = 0;
  for (const auto& delivery : trace.deliveries) {
    if (delivery.sender == 3) {
      ++babbled;
      EXPECT_FALSE(delivery.sent_by(3)) << "its owner has offered nothing";
      EXPECT_EQ(delivery.receivers.size(), kInjectedStations - 1);
      EXPECT_GE(delivery.start_ns, 1'000'000);
      EXPECT_LT(delivery.start_ns, 3'000'000);
    } else {
      const bool meanwhile = delivery.start_ns > 1'000'000 && delivery.start_ns < 3'000'000;
      EXPECT_FALSE(meanwhile) << delivery.start_ns;
    }
  }
  EXPECT_GT(babbled, 15U);
  EXPECT_EQ(bus.statistics().injected.babbled_frames, babbled);
  EXPECT_TRUE(trace.errors.empty());
}

TEST_F(BusInjectionTest, ABabblersOwnFrameWaitsAndComesAfterwards) {
  bus.babble(3, numbered_frame(0x00F), 0, 1'000'000);
  bus.transmit(3, numbered_frame(0x010, 77), 0);
  trace.run(bus, 5'000'000);
  ASSERT_FALSE(trace.deliveries.empty());
  EXPECT_EQ(trace.deliveries.back().frame, numbered_frame(0x010, 77));
  EXPECT_TRUE(trace.deliveries.back().sent_by(3));
  EXPECT_GE(trace.deliveries.back().start_ns, 1'000'000);
}

TEST_F(BusInjectionTest, AFrameLastsByItsSendersClock) {
  const Frame frame = numbered_frame(0x100);
  const int bits = frame_bits(frame);
  bus.set_clock_drift(0, 2000.0);
  bus.set_clock_drift(1, -2000.0);
  bus.transmit(0, frame, 0);
  bus.transmit(1, numbered_frame(0x200), 0);
  bus.transmit(2, numbered_frame(0x300), 0);
  trace.run(bus, 1'000'000);
  ASSERT_EQ(trace.deliveries.size(), 3U);
  EXPECT_EQ(trace.deliveries[0].end_ns, bits * 1002);
  EXPECT_EQ(trace.deliveries[1].start_ns, (bits + 3) * 1002);
  EXPECT_EQ(trace.deliveries[1].end_ns - trace.deliveries[1].start_ns, trace.deliveries[1].bits * 998);
  EXPECT_EQ(trace.deliveries[2].end_ns - trace.deliveries[2].start_ns, trace.deliveries[2].bits * 1000);
}

TEST_F(BusInjectionTest, AStationWithoutPowerNeitherSendsNorReceives) {
  bus.transmit(2, numbered_frame(0x200), 0);
  bus.power_off(2, 0);
  EXPECT_EQ(bus.state(2), BusState::down);
  EXPECT_FALSE(bus.transmit_pending(2)) << "its transmit buffer is gone";
  EXPECT_FALSE(bus.transmit(2, numbered_frame(0x200), 0));
  bus.transmit(0, numbered_frame(0x100), 20'000);
  trace.run(bus, 1'000'000);
  ASSERT_EQ(trace.deliveries.size(), 1U);
  EXPECT_FALSE(trace.deliveries[0].received_by(2));
  EXPECT_EQ(trace.deliveries[0].receivers.size(), kInjectedStations - 2);
}

TEST_F(BusInjectionTest, AStationThatComesTakesPartAfterElevenRecessiveBits) {
  bus.power_off(2, 0);
  trace.run(bus, 1'000'000);
  bus.transmit(0, numbered_frame(0x100), 1'000'000);
  bus.power_on(2, 1'020'000);
  trace.run(bus, 1'050'000);
  ASSERT_TRUE(bus.transmit(2, numbered_frame(0x001), 1'050'000));
  bus.transmit(1, numbered_frame(0x300), 1'050'000);
  trace.run(bus, 2'000'000);
  ASSERT_EQ(trace.deliveries.size(), 3U);
  EXPECT_FALSE(trace.deliveries[0].received_by(2)) << "it came in the middle";
  EXPECT_EQ(trace.deliveries[1].sender, 2)
      << "the frame's end and the intermission are eleven recessive bits";
  EXPECT_TRUE(trace.deliveries[2].received_by(2));
  EXPECT_EQ(bus.state(2), BusState::error_active);
  trace.deliveries.clear();
  bus.power_off(2, 2'000'000);
  bus.power_on(2, 3'000'000);
  trace.run(bus, 3'000'000);
  bus.transmit(2, numbered_frame(0x001), 3'000'000);
  trace.run(bus, 4'000'000);
  ASSERT_EQ(trace.deliveries.size(), 1U);
  EXPECT_EQ(trace.deliveries[0].start_ns, 3'000'000 + 11 * kBit_ns);
}

TEST_F(BusInjectionTest, ASenderThatLosesItsPowerLeavesAStuffErrorToTheOthers) {
  bus.transmit(2, numbered_frame(0x2AA), 0);
  bus.transmit(0, numbered_frame(0x300), 0);
  bus.power_off(2, 40'000);
  trace.run(bus, 1'000'000);
  ASSERT_EQ(trace.errors.size(), 1U);
  EXPECT_EQ(trace.errors[0].kind, ErrorKind::stuff);
  EXPECT_EQ(trace.errors[0].cause, FaultCause::consequence);
  EXPECT_GT(trace.errors[0].error_ns, 40'000);
  EXPECT_LE(trace.errors[0].error_ns, 46'000);
  ASSERT_EQ(trace.deliveries.size(), 1U);
  EXPECT_EQ(trace.deliveries[0].sender, 0);
  EXPECT_EQ(trace.deliveries[0].start_ns, trace.errors[0].error_ns + (6 + 8 + 3) * kBit_ns);
}

TEST_F(BusInjectionTest, ADetachedStationsNumberIsTakenAgain) {
  bus.force_bus_off(5, 0);
  bus.transmit(5, numbered_frame(0x100), 0);
  bus.set_recovery(5, Recovery::on_request);
  trace.run(bus, 10'000'000);
  bus.detach(5);
  EXPECT_EQ(bus.state(5), BusState::down);
  EXPECT_EQ(bus.attach(), 5);
  EXPECT_EQ(bus.state(5), BusState::error_active);
  EXPECT_FALSE(bus.transmit_pending(5));
  EXPECT_EQ(bus.attach(), kInjectedStations);
}

TEST_F(BusInjectionTest, RecordsThatNobodyFetchesGiveWayAndAreCounted) {
  for (int station = 1; station < kInjectedStations; ++station) {
    bus.power_off(station, 0);
  }
  bus.transmit(0, numbered_frame(0x100), 0);
  while (bus.advance(100'000'000)) {
  }
  std::uint64_t fetched = 0;
  std::int64_t last_ns = -1;
  while (const auto error = bus.next_error_frame()) {
    EXPECT_GT(error->error_ns, last_ns);
    last_ns = error->error_ns;
    ++fetched;
  }
  EXPECT_GT(last_ns, 99'000'000);
  EXPECT_EQ(fetched + bus.statistics().error_frames_dropped, bus.statistics().error_frames);
}

// Six stations with numbered frames of their own identifiers, as fast as the bus takes them.
Trace run_random(SimulatedBus& bus, std::uint32_t seed, const RandomFaults& faults, std::int64_t until_ns) {
  std::mt19937 random(seed);
  std::array<std::uint8_t, kInjectedStations> number{};
  const auto offer = [&](int station, std::int64_t now_ns) {
    const auto place = static_cast<std::size_t>(station);
    bus.transmit(
        station,
        numbered_frame(static_cast<std::uint32_t>(random() % 32 * 16) + static_cast<std::uint32_t>(station),
                       number[place]++, static_cast<std::uint8_t>(1 + random() % 8)),
        now_ns);
  };
  bus.set_random_faults(faults);
  for (int station = 0; station < kInjectedStations; ++station) {
    offer(station, 0);
  }
  Trace trace;
  trace.run(bus, until_ns, [&](const SimulatedBus::Delivery& delivery) {
    if (delivery.sent_by(delivery.sender)) {
      offer(delivery.sender, delivery.end_ns + static_cast<std::int64_t>(random() % 200'000));
    }
  });
  return trace;
}

class RandomFaultsTest : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomFaultsTest, AFrameArrivesOnceUnlessTheCountersSayOtherwise) {
  SimulatedBus bus;
  attach(bus, kInjectedStations);
  const RandomFaults faults{.seed = GetParam(), .corruption = 0.02, .duplicate = 0.02, .omission = 0.02};
  const Trace trace = run_random(bus, GetParam(), faults, 1'000'000'000);
  const BusStatistics& statistics = bus.statistics();
  std::array<std::uint8_t, kInjectedStations> expected_number{};
  std::uint64_t sent = 0, duplicates = 0, omissions = 0, omitted = 0;
  for (const auto& delivery : trace.deliveries) {
    std::uint8_t& number = expected_number[static_cast<std::size_t>(delivery.sender)];
    ASSERT_EQ(delivery.frame.data[0], number) << "in order, none left out";
    ASSERT_FALSE(delivery.received_by(delivery.sender));
    const int receivers = delivery.receivers.size();
    ASSERT_GE(receivers, 1);
    if (!delivery.sent_by(delivery.sender)) {
      ASSERT_LT(receivers, kInjectedStations - 1) << "who rejects it makes the sender repeat it";
      ++duplicates;
      continue;
    }
    ++sent;
    ++number;
    omissions += receivers < kInjectedStations - 1 ? 1U : 0U;
    omitted += static_cast<std::uint64_t>(kInjectedStations - 1 - receivers);
  }
  std::map<FaultCause, std::uint64_t> causes;
  for (const ErrorFrame& error : trace.errors) {
    ++causes[error.cause];
  }
  EXPECT_GT(duplicates, 20U);
  EXPECT_GT(omissions, 20U);
  EXPECT_EQ(statistics.injected.duplicates, duplicates);
  EXPECT_EQ(causes[FaultCause::duplicate], duplicates);
  EXPECT_EQ(statistics.injected.omissions, omissions);
  EXPECT_EQ(statistics.injected.omitted_receptions, omitted);
  EXPECT_GT(statistics.injected.corruptions, 20U);
  EXPECT_EQ(causes[FaultCause::corruption], statistics.injected.corruptions);
  EXPECT_EQ(causes.size(), 2U) << "nothing but what was asked for";
  EXPECT_EQ(statistics.error_frames, trace.errors.size());
  EXPECT_EQ(statistics.frames, sent);
  EXPECT_EQ(statistics.lost, 0U);
}

// Duplicates alone: each costs its sender 8, each frame sent gives 1 back.
TEST_P(RandomFaultsTest, TransmitCountersFollowFromTheTrace) {
  SimulatedBus bus;
  attach(bus, kInjectedStations);
  const Trace trace =
      run_random(bus, GetParam(), {.seed = GetParam(), .corruption = 0.0, .duplicate = 0.1, .omission = 0.0},
                 300'000'000);
  std::array<int, kInjectedStations> counter{};
  for (const auto& delivery : trace.deliveries) {
    int& one = counter[static_cast<std::size_t>(delivery.sender)];
    one = delivery.sent_by(delivery.sender) ? std::max(0, one - 1) : one + 8;
  }
  for (int station = 0; station < kInjectedStations; ++station) {
    EXPECT_EQ(bus.error_counters(station).transmit, counter[static_cast<std::size_t>(station)]);
  }
}

using Course = std::vector<std::tuple<std::int64_t, int, std::uint32_t, bool>>;
Course course(std::uint32_t traffic_seed, std::uint64_t fault_seed) {
  SimulatedBus bus;
  attach(bus, kInjectedStations);
  const Trace trace =
      run_random(bus, traffic_seed,
                 {.seed = fault_seed, .corruption = 0.05, .duplicate = 0.01, .omission = 0.01}, 50'000'000);
  Course course;
  for (const auto& delivery : trace.deliveries) {
    course.emplace_back(delivery.end_ns, delivery.sender, delivery.frame.id, delivery.received_by(0));
  }
  return course;
}

TEST_P(RandomFaultsTest, TheSameSeedsTakeTheSameCourseAndOthersDoNot) {
  EXPECT_EQ(course(GetParam(), 1), course(GetParam(), 1));
  EXPECT_NE(course(GetParam(), 1), course(GetParam(), 2));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomFaultsTest, testing::Values(1U, 2U, 3U, 4U));

}  // namespace
}  // namespace gaitway::can
