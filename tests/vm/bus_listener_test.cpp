// The listener of `gaitway bus monitor` and `gaitway bus measure` on a virtual interface.
#include "tools/bus/bus_listener.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "can_station.hpp"
#include "gaitway/can/profile.hpp"
#include "tools/bus/bus_watch.hpp"

namespace gaitway::tools {
namespace {

using can::MessageKind;

constexpr std::array<can::NodeId, 2> kNodes{1, 2};

void send(can::test::Station& station, const can::Frame& frame) {
  station.send(frame.id, std::vector<std::uint8_t>(frame.payload().begin(), frame.payload().end()));
}

TEST(BusListener, HearsWhatAnotherStationSendsOnAnInterface) {
  const can::test::Interface interface;
  can::test::Station other{interface.name};
  BusListener listener({.socket = {}, .interface = interface.name});
  BusWatch watch(can::kPaperProfile, kNodes, BusClock::robot);
  constexpr std::uint64_t kRounds = 20;
  for (std::uint64_t round = 0; round < kRounds; ++round) {
    for (const can::NodeId node : kNodes) {
      send(other, can::encode(can::kPaperProfile, can::Trajectory{.node = node}));
      send(other, can::encode(can::kPaperProfile, can::Feedback{.node = node, .position = 77}));
    }
  }
  send(other, {.id = 0x7FF});
  const std::uint64_t all = 4 * kRounds + 1;
  const std::int64_t patience_ns = can::test::clock_ns() + can::test::kPatience_ms * std::int64_t{1'000'000};
  while (watch.frames() < all && can::test::clock_ns() < patience_ns) {
    listener.listen_until(can::test::clock_ns() + 1'000'000,
                          [&](const can::TimedFrame& frame) { watch.take(frame); });
  }
  EXPECT_EQ(watch.frames(), all);
  EXPECT_EQ(watch.message(MessageKind::trajectory).frames, 2 * kRounds);
  EXPECT_EQ(watch.message(MessageKind::feedback).frames, 2 * kRounds);
  EXPECT_EQ(watch.strangers(Stranger::unknown_identifier), 1U);
  // An empty batch is known to the bit: node 1 has one stuff bit more than node 2, or as many.
  EXPECT_GE(watch.message(MessageKind::trajectory).length_us.min, 111.0);
  EXPECT_LE(watch.message(MessageKind::trajectory).length_us.max, 135.0);
  EXPECT_TRUE(listener.open());
  EXPECT_EQ(listener.state().state, can::BusState::error_active);
}

TEST(BusListener, AnInterfaceThatGoesDownIsSeen) {
  const can::test::Interface interface;
  BusListener listener({.socket = {}, .interface = interface.name});
  interface.down();
  const std::int64_t patience_ns = can::test::clock_ns() + can::test::kPatience_ms * std::int64_t{1'000'000};
  while (listener.state().state != can::BusState::down && can::test::clock_ns() < patience_ns) {
    listener.listen_until(can::test::clock_ns() + 1'000'000, [](const can::TimedFrame&) {});
  }
  EXPECT_EQ(listener.state().state, can::BusState::down);
}

}  // namespace
}  // namespace gaitway::tools
