// Arbitration, timing, loss and statistics of the simulated bus.
#include "gaitway/can/simulated/simulated_bus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

#include "gaitway/can/frame.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::can {
namespace {

constexpr std::int64_t kBit_ns = facts::kBitTime_ns;

Frame frame_of(std::uint16_t id, std::uint8_t size = 8, std::uint8_t value = 0x5A) {
  Frame frame{id, size, {}};
  std::fill_n(frame.data.begin(), size, value);
  return frame;
}

class SimulatedBusTest : public testing::Test {
 protected:
  SimulatedBusTest() {
    for (int i = 0; i < 4; ++i) {
      bus.attach();
    }
  }
  std::vector<SimulatedBus::Delivery> run_to(std::int64_t until_ns) {
    std::vector<SimulatedBus::Delivery> all;
    while (const auto delivery = bus.advance(until_ns)) {
      all.push_back(*delivery);
    }
    return all;
  }
  SimulatedBus bus;
};

TEST_F(SimulatedBusTest, AFrameTakesItsExactLengthFromItsOffer) {
  const Frame frame = frame_of(0x123);
  ASSERT_TRUE(bus.transmit(2, frame, 5'000'000));
  EXPECT_TRUE(run_to(5'000'000 + frame_bits(frame) * kBit_ns - 1).empty());
  EXPECT_TRUE(bus.transmit_pending(2));
  const auto all = run_to(5'000'000 + frame_bits(frame) * kBit_ns);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].frame, frame);
  EXPECT_EQ(all[0].sender, 2);
  EXPECT_EQ(all[0].start_ns, 5'000'000);
  EXPECT_EQ(all[0].end_ns, 5'000'000 + frame_bits(frame) * kBit_ns);
  EXPECT_FALSE(bus.transmit_pending(2));
}

TEST_F(SimulatedBusTest, TheLowestIdentifierWinsAndTheOthersFollowAfterTheInterframeSpace) {
  bus.transmit(0, frame_of(0x300), 0);
  bus.transmit(1, frame_of(0x100), 0);
  bus.transmit(2, frame_of(0x200), 0);
  const auto all = run_to(1'000'000);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].frame.id, 0x100);
  EXPECT_EQ(all[1].frame.id, 0x200);
  EXPECT_EQ(all[2].frame.id, 0x300);
  EXPECT_EQ(all[1].start_ns, all[0].end_ns + kInterframeBits * kBit_ns);
  EXPECT_EQ(all[2].start_ns, all[1].end_ns + kInterframeBits * kBit_ns);
}

TEST_F(SimulatedBusTest, AFrameOfferedAfterAStartOfFrameWaitsHoweverUrgent) {
  bus.transmit(0, frame_of(0x700), 0);
  bus.transmit(1, frame_of(0x001, 1), 1);
  bus.transmit(2, frame_of(0x600), 0);
  const auto all = run_to(1'000'000);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].frame.id, 0x600) << "a nanosecond after the start of frame is too late";
  EXPECT_EQ(all[1].frame.id, 0x001);
  EXPECT_EQ(all[2].frame.id, 0x700);
}

TEST_F(SimulatedBusTest, AStationHasOneBufferAndTakesAFrameBackOnlyBeforeItStarts) {
  ASSERT_TRUE(bus.transmit(0, frame_of(0x100), 0));
  EXPECT_FALSE(bus.transmit(0, frame_of(0x050), 0));
  ASSERT_TRUE(bus.transmit(1, frame_of(0x200), 0));
  EXPECT_TRUE(run_to(50'000).empty());
  EXPECT_FALSE(bus.abort(0)) << "on the wire";
  EXPECT_TRUE(bus.abort(1));
  EXPECT_FALSE(bus.abort(1));
  const auto all = run_to(1'000'000);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].frame.id, 0x100);
}

TEST_F(SimulatedBusTest, ALostFrameLooksSentToItsSender) {
  bus.set_loss([](const Frame& frame, std::int64_t) { return frame.id == 0x100; });
  bus.transmit(0, frame_of(0x100), 0);
  bus.transmit(1, frame_of(0x200), 0);
  const auto all = run_to(1'000'000);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_TRUE(all[0].lost);
  EXPECT_FALSE(all[1].lost);
  EXPECT_FALSE(bus.transmit_pending(0));
  EXPECT_EQ(bus.statistics().lost, 1U);
  EXPECT_TRUE(all[0].sent_by(0));
  for (int station = 0; station < 4; ++station) {
    EXPECT_FALSE(all[0].received_by(station));
    EXPECT_EQ(all[1].received_by(station), station != 1);
  }
}

TEST_F(SimulatedBusTest, StatisticsCountEightByteFramesWithTheirInterframeSpace) {
  bus.transmit(0, frame_of(0x100), 0);
  bus.transmit(1, frame_of(0x2AA, 8, 0x00), 0);
  bus.transmit(2, frame_of(0x300, 1), 0);
  const auto all = run_to(1'000'000);
  ASSERT_EQ(all.size(), 3U);
  const BusStatistics& statistics = bus.statistics();
  EXPECT_EQ(statistics.frames, 3U);
  EXPECT_EQ(statistics.busy_ns, (all[0].bits + all[1].bits + all[2].bits + 9) * kBit_ns);
  EXPECT_EQ(statistics.eight_byte_us.count, 2U);
  EXPECT_DOUBLE_EQ(statistics.eight_byte_us.mean(), (all[0].bits + all[1].bits) / 2.0 + 3.0);
  EXPECT_DOUBLE_EQ(statistics.eight_byte_us.min, std::min(all[0].bits, all[1].bits) + 3.0);
  EXPECT_DOUBLE_EQ(statistics.eight_byte_us.max, std::max(all[0].bits, all[1].bits) + 3.0);
  EXPECT_DOUBLE_EQ(statistics.load(1'000'000), static_cast<double>(statistics.busy_ns) / 1e6);
}

// 22 joints and the message controller, each with a new frame as soon as its last one is out.
std::vector<SimulatedBus::Delivery> saturate(int frames_each) {
  constexpr int kSaturating = 23;
  SimulatedBus bus;
  std::mt19937 random(5);
  std::vector<int> left(kSaturating, frames_each);
  const auto offer = [&](int station, std::int64_t now_ns) {
    int& rest = left[static_cast<std::size_t>(station)];
    if (rest > 0) {
      --rest;
      const auto id = static_cast<std::uint16_t>(random() % 64 * 32 + static_cast<unsigned>(station));
      const auto size = static_cast<std::uint8_t>(random() % 9);
      EXPECT_TRUE(bus.transmit(station, frame_of(id, size, static_cast<std::uint8_t>(rest)), now_ns));
    }
  };
  for (int station = 0; station < kSaturating; ++station) {
    offer(bus.attach(), 0);
  }
  std::vector<SimulatedBus::Delivery> all;
  while (const auto delivery = bus.advance(std::numeric_limits<std::int64_t>::max() / 2)) {
    all.push_back(*delivery);
    offer(delivery->sender, delivery->end_ns);
  }
  const std::int64_t end_ns = all.back().end_ns + kInterframeBits * kBit_ns;
  EXPECT_DOUBLE_EQ(bus.statistics().load(end_ns), 1.0) << "never idle";
  return all;
}

TEST_F(SimulatedBusTest, ASaturatedBusLosesNothingAndKeepsEachStationsOrder) {
  constexpr int kFramesEach = 255;
  const auto all = saturate(kFramesEach);
  ASSERT_EQ(all.size(), 23U * kFramesEach);
  std::vector<int> last(23, kFramesEach);
  for (const auto& delivery : all) {
    int& before = last[static_cast<std::size_t>(delivery.sender)];
    if (delivery.frame.size > 0) {
      ASSERT_LT(delivery.frame.data[0], before);
      before = delivery.frame.data[0];
    }
  }
}

TEST_F(SimulatedBusTest, TheSameTrafficTakesTheSameCourse) {
  const auto once = saturate(50), again = saturate(50);
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    ASSERT_EQ(once[i].frame, again[i].frame);
    ASSERT_EQ(once[i].start_ns, again[i].start_ns);
    ASSERT_EQ(once[i].sender, again[i].sender);
  }
}

TEST_F(SimulatedBusTest, BitsStartOnTheBussOwnRaster) {
  bus.transmit(0, frame_of(0x100), 5'001);
  bus.transmit(1, frame_of(0x050), 6'000);
  const auto all = run_to(1'000'000);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].frame.id, 0x050) << "offered before the next bit begins";
  EXPECT_EQ(all[0].start_ns, 6'000);
}

// Random traffic, looked at afterwards: whenever a frame started, no waiting one was more urgent, and the bus
// was never idle while one waited.
TEST_F(SimulatedBusTest, RandomTrafficNeverBreaksTheRulesOfArbitration) {
  struct Offer {
    Frame frame;
    std::int64_t since_ns = 0;
    std::int64_t start_ns = -1;
  };
  std::mt19937 random(11);
  std::vector<Offer> offers;
  std::map<int, std::size_t> waiting;
  std::int64_t free_from_ns = 0;
  for (std::int64_t now_ns = 0; now_ns < 400'000'000; now_ns += 137'000) {
    for (int station = 0; station < 4; ++station) {
      if (!bus.transmit_pending(station) && random() % 3 == 0) {
        const Offer offer{
            frame_of(static_cast<std::uint16_t>(random() % 64 * 4 + static_cast<unsigned>(station)),
                     static_cast<std::uint8_t>(random() % 9)),
            now_ns};
        bus.transmit(station, offer.frame, now_ns);
        waiting[station] = offers.size();
        offers.push_back(offer);
      }
    }
    for (const auto& delivery : run_to(now_ns + 137'000)) {
      const std::size_t sent = waiting.at(delivery.sender);
      offers[sent].start_ns = delivery.start_ns;
      ASSERT_EQ(offers[sent].frame, delivery.frame);
      ASSERT_GE(delivery.start_ns, free_from_ns);
      free_from_ns = delivery.end_ns + kInterframeBits * kBit_ns;
    }
  }
  ASSERT_GT(offers.size(), 2000U);
  std::vector<Offer> started;
  std::copy_if(offers.begin(), offers.end(), std::back_inserter(started),
               [](const Offer& o) { return o.start_ns >= 0; });
  for (const Offer& winner : started) {
    for (const Offer& other : started) {
      const bool waited = other.since_ns <= winner.start_ns && other.start_ns > winner.start_ns;
      ASSERT_FALSE(waited && other.frame.id < winner.frame.id) << "at " << winner.start_ns;
    }
  }
}

}  // namespace
}  // namespace gaitway::can
