// A station's most urgent frame is the one that takes part in arbitration.
#include "gaitway/can/station_transmitter.hpp"

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
      if (delivery->sender == transmitter.station()) {
        transmitter.on_sent();
        transmitter.offer(bus, queue, delivery->end_ns);
      }
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

}  // namespace
}  // namespace gaitway::can
