// A station's most urgent frame is the one that takes part in arbitration.
#include "gaitway/can/simulated/station_transmitter.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

namespace gaitway::can {
namespace {

// A queue by identifier, frames of one identifier in their order.
class Queue {
 public:
  void push(const Frame& frame) { frames_[frame.id].push_back(frame); }
  [[nodiscard]] std::uint32_t next_id() const { return frames_.empty() ? 0xFFFF : frames_.begin()->first; }
  bool take_frame(Frame& frame) {
    if (frames_.empty()) {
      return false;
    }
    auto& same_id = frames_.begin()->second;
    frame = same_id.front();
    same_id.erase(same_id.begin());
    if (same_id.empty()) {
      frames_.erase(frames_.begin());
    }
    return true;
  }
  void put_back(const Frame& frame) {
    auto& same_id = frames_[frame.id];
    same_id.insert(same_id.begin(), frame);
  }

 private:
  std::map<std::uint32_t, std::vector<Frame>> frames_;
};

class StationTransmitterTest : public testing::Test {
 protected:
  // Offers and delivers until nothing comes up to `until_ns`; what was sent, in its order.
  std::vector<Frame> run_to(std::int64_t until_ns) {
    std::vector<Frame> sent;
    while (const auto delivery = bus.advance(until_ns)) {
      transmitter.on_delivery(*delivery);
      transmitter.offer(bus, queue, delivery->end_ns);
      sent.push_back(delivery->frame);
    }
    return sent;
  }
  static std::vector<std::uint32_t> ids(const std::vector<Frame>& frames) {
    std::vector<std::uint32_t> ids;
    for (const Frame& frame : frames) {
      ids.push_back(frame.id);
    }
    return ids;
  }

  SimulatedBus bus;
  int other = bus.attach();
  StationTransmitter transmitter{bus.attach()};
  Queue queue;
};

TEST_F(StationTransmitterTest, AWaitingFrameGivesWayToAMoreUrgentOne) {
  bus.transmit(other, {0x010, 8, {}}, 0);
  queue.push({0x300, 8, {}});
  transmitter.offer(bus, queue, 0);
  EXPECT_TRUE(run_to(50'000).empty());  // the other station's frame is on the wire
  queue.push({0x100, 8, {}});
  transmitter.offer(bus, queue, 50'000);
  bus.transmit(other, {0x200, 8, {}}, 50'000);
  EXPECT_EQ(ids(run_to(1'000'000)), (std::vector<std::uint32_t>{0x010, 0x100, 0x300}));
  EXPECT_FALSE(transmitter.pending());
}

TEST_F(StationTransmitterTest, AFrameOnTheWireIsNotTakenBack) {
  queue.push({0x300, 8, {}});
  transmitter.offer(bus, queue, 0);
  EXPECT_TRUE(run_to(50'000).empty());
  queue.push({0x100, 8, {}});
  transmitter.offer(bus, queue, 50'000);
  EXPECT_EQ(ids(run_to(1'000'000)), (std::vector<std::uint32_t>{0x300, 0x100}));
}

TEST_F(StationTransmitterTest, FramesOfOneIdentifierKeepTheirOrderAndNoneIsLost) {
  std::mt19937 random(8);
  std::map<std::uint32_t, std::vector<std::uint8_t>> pushed, sent;
  std::uint8_t serial = 0;
  std::int64_t now_ns = 0;
  const auto take = [&](std::int64_t until_ns) {
    for (const Frame& frame : run_to(until_ns)) {
      if (frame.id != 0x051) {
        sent[frame.id].push_back(frame.data[0]);
      }
    }
  };
  for (int i = 0; i < 2000; ++i, now_ns += 90'000) {
    bus.transmit(other, {0x051, 4, {}}, now_ns);
    if (random() % 3 == 0) {
      const Frame frame{static_cast<std::uint32_t>(0x040 + random() % 4 * 8), 1, {serial++}};
      queue.push(frame);
      pushed[frame.id].push_back(frame.data[0]);
    }
    transmitter.offer(bus, queue, now_ns);
    take(now_ns + 90'000);
  }
  take(now_ns + 1'000'000'000);
  EXPECT_EQ(sent, pushed);
}

TEST_F(StationTransmitterTest, AFrameThatIsRepeatedThoughOthersHaveItStillWaits) {
  bus.attach();
  bus.set_random_faults({.seed = 2, .duplicate = 1.0});
  queue.push({0x100, 8, {}});
  queue.push({0x200, 8, {}});
  transmitter.offer(bus, queue, 0);
  const auto first = bus.advance(1'000'000);
  ASSERT_TRUE(first && !first->sent_by(transmitter.station()));
  bus.set_random_faults({});
  transmitter.on_delivery(*first);
  EXPECT_TRUE(transmitter.pending());
  transmitter.offer(bus, queue, first->end_ns);
  const auto second = bus.advance(1'000'000);
  ASSERT_TRUE(second && second->sent_by(transmitter.station()));
  EXPECT_EQ(second->frame.id, 0x100U);
  transmitter.on_delivery(*second);
  EXPECT_FALSE(transmitter.pending());
}

TEST_F(StationTransmitterTest, WhatWaitsAtBusOffIsTakenBackIntoItsQueue) {
  bus.set_recovery(transmitter.station(), Recovery::on_request);
  bus.force_bus_off(transmitter.station(), 0);
  queue.push({0x100, 8, {}});
  transmitter.offer(bus, queue, 0);
  EXPECT_TRUE(run_to(20'000'000).empty());
  ASSERT_EQ(bus.state(transmitter.station()), BusState::bus_off);
  EXPECT_TRUE(transmitter.withdraw(bus, queue));
  EXPECT_FALSE(transmitter.pending());
  EXPECT_FALSE(transmitter.withdraw(bus, queue));
  EXPECT_EQ(queue.next_id(), 0x100U);
  EXPECT_TRUE(bus.recover(transmitter.station()));
  EXPECT_TRUE(run_to(30'000'000).empty()) << "nothing stale goes out";
}

TEST_F(StationTransmitterTest, AfterItsPowerWasOffItGoesOnWithWhatWaits) {
  queue.push({0x100, 8, {}});
  queue.push({0x200, 8, {}});
  transmitter.offer(bus, queue, 0);
  bus.power_off(transmitter.station(), 0);
  transmitter.offer(bus, queue, 0);
  EXPECT_EQ(queue.next_id(), 0x200U) << "without power it takes nothing";
  bus.power_on(transmitter.station(), 1'000'000);
  EXPECT_TRUE(run_to(1'000'000).empty());
  transmitter.offer(bus, queue, 1'000'000);
  EXPECT_EQ(ids(run_to(2'000'000)), (std::vector<std::uint32_t>{0x200}));
}

// Tells arbitration keys, so that frames of all formats have their place.
class KeyedQueue {
 public:
  void push(const Frame& frame) { frames_.emplace(arbitration_key(frame), frame); }
  [[nodiscard]] std::uint32_t next_id() const { return frames_.begin()->second.id; }
  [[nodiscard]] std::uint32_t next_key() const {
    return frames_.empty() ? kNoFrameKey : frames_.begin()->first;
  }
  bool take_frame(Frame& frame) {
    if (frames_.empty()) {
      return false;
    }
    frame = frames_.begin()->second;
    frames_.erase(frames_.begin());
    return true;
  }
  void put_back(const Frame& frame) { push(frame); }

 private:
  std::multimap<std::uint32_t, Frame> frames_;
};

TEST_F(StationTransmitterTest, AnExtendedFrameGivesWayToABaseFrameWithTheLargerNumber) {
  KeyedQueue keyed;
  bus.transmit(other, {0x001, 8, {}}, 0);
  keyed.push({.id = 0x40, .size = 0, .data = {}, .extended = true});  // its first eleven bits are zero
  keyed.push({.id = 0x300 << 18U, .size = 0, .data = {}, .extended = true});
  Frame most_urgent;
  ASSERT_TRUE(keyed.take_frame(most_urgent));  // leaves 0x300...
  transmitter.offer(bus, keyed, 0);
  keyed.push({0x2FF, 0, {}});
  transmitter.offer(bus, keyed, 0);
  while (const auto delivery = bus.advance(10'000'000)) {
    transmitter.on_delivery(*delivery);
    transmitter.offer(bus, keyed, delivery->end_ns);
    if (delivery->sender == transmitter.station()) {
      EXPECT_EQ(delivery->frame.id, 0x2FFU);
      return;
    }
  }
  FAIL() << "nothing was sent";
}

}  // namespace
}  // namespace gaitway::can
