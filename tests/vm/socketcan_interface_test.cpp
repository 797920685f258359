// Interfaces that are missing, of another kind, down, removed and added again, and what the kernel tells of
// the controller, while the port runs.
#include <gmock/gmock.h>
#include <linux/can/error.h>

#include "allocation_count.hpp"
#include "can_station.hpp"
#include "gaitway/can/socketcan_port.hpp"

namespace gaitway::can {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string refusal(const std::string& interface) {
  try {
    const SocketCanPort port(interface);
  } catch (const BusError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SocketCanRefusal, WhatCannotBeOpenedIsNamedWithWhatToDo) {
  EXPECT_THAT(refusal("nobus7"), AllOf(HasSubstr("'nobus7'"), HasSubstr("no such interface"),
                                       HasSubstr("ip link add nobus7 type vcan")));
  EXPECT_THAT(refusal("lo"), AllOf(HasSubstr("'lo'"), HasSubstr("no CAN interface")));
  EXPECT_THAT(refusal(""), HasSubstr("1 to 15 characters"));
  EXPECT_THAT(refusal("a_name_that_is_too_long"), HasSubstr("1 to 15 characters"));
  const test::Interface interface;
  interface.down();
  EXPECT_THAT(refusal(interface.name), AllOf(HasSubstr("is down"), HasSubstr("ip link set vtest0 up")));
}

class SocketCanInterface : public testing::Test {
 protected:
  bool comes_to(BusState state) {
    return test::work(port, [&] { return port.state() == state; });
  }
  // A frame goes out and another comes in.
  void expect_working() {
    const test::Station other(interface.name);
    const std::uint64_t sent = port.statistics().sent;
    ASSERT_TRUE(port.transmit({.id = 0x77}, test::clock_ns()));
    EXPECT_TRUE(test::work(port, [&] { return !port.transmit_pending(); }));
    EXPECT_EQ(port.statistics().sent, sent + 1);
    EXPECT_THAT(other.receive_ids(1), ElementsAre(0x77));
    EXPECT_TRUE(other.silent()) << "nothing old comes out";
    other.send(0x78);
    const auto frames = test::receive(port, 1);
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].frame.id, 0x78U);
  }
  // An error frame, as a driver sends it.
  void tell(std::uint32_t error_class, const std::vector<std::uint8_t>& data) const {
    const test::Station driver(interface.name);
    driver.send(CAN_ERR_FLAG | error_class, data);
  }

  test::Interface interface;
  SocketCanPort port{interface.name, {.echo_deadline_ns = 3'600'000'000'000, .interface_poll_ns = 1'000'000}};
};

TEST_F(SocketCanInterface, AnInterfaceThatGoesDownDropsWhatWaitsAndWorksAgainWhenItIsUp) {
  expect_working();
  interface.delay("100s");
  for (const std::uint32_t id : {0x10U, 0x11U, 0x12U}) {
    ASSERT_TRUE(port.transmit({.id = id}, test::clock_ns()));
    port.flush(test::clock_ns());
  }
  interface.down();
  EXPECT_TRUE(comes_to(BusState::down));
  EXPECT_EQ(port.statistics().interface_down, 1U);
  EXPECT_EQ(port.statistics().lost, 1U) << "the kernel had one";
  EXPECT_EQ(port.statistics().flushed, 2U);
  EXPECT_FALSE(port.transmit_pending());
  EXPECT_FALSE(port.transmit({.id = 1}, test::clock_ns()));
  EXPECT_EQ(port.statistics().refused_unusable, 1U);
  EXPECT_EQ(port.free_buffers(), 0U);

  interface.delay("0ms");
  interface.up();
  EXPECT_TRUE(comes_to(BusState::error_active));
  EXPECT_EQ(port.statistics().interface_up, 1U);
  EXPECT_EQ(port.statistics().rebound, 0U);
  expect_working();
}

TEST_F(SocketCanInterface, AnInterfaceThatIsRemovedAndAddedAgainIsBoundAgain) {
  expect_working();
  interface.remove();
  EXPECT_TRUE(comes_to(BusState::down));
  for (int i = 0; i < 10; ++i) {
    port.flush(test::clock_ns() + i * 1'000'000);
  }
  EXPECT_EQ(port.state(), BusState::down);
  interface.add();
  EXPECT_TRUE(comes_to(BusState::error_active));
  EXPECT_EQ(port.statistics().rebound, 1U);
  expect_working();
}

TEST_F(SocketCanInterface, ANewInterfaceOfTheOldOnesNumberIsAnotherOne) {
  const unsigned index = if_nametoindex(interface.name.c_str());
  interface.remove();
  EXPECT_TRUE(comes_to(BusState::down));
  interface.add("index " + std::to_string(index));
  EXPECT_TRUE(comes_to(BusState::error_active));
  EXPECT_EQ(port.statistics().rebound, 1U);
  expect_working();
}

TEST_F(SocketCanInterface, ManyChangesInARowAreAllCounted) {
  constexpr std::uint64_t kTimes = 5;
  for (std::uint64_t i = 1; i <= kTimes; ++i) {
    interface.down();
    ASSERT_TRUE(comes_to(BusState::down));
    interface.up();
    ASSERT_TRUE(comes_to(BusState::error_active));
    ASSERT_EQ(port.statistics().interface_down, i);
    ASSERT_EQ(port.statistics().interface_up, i);
  }
  expect_working();
}

TEST_F(SocketCanInterface, StateAndCountersFollowTheErrorFrames) {
  tell(CAN_ERR_CRTL | CAN_ERR_CNT, {0, CAN_ERR_CRTL_TX_PASSIVE, 0, 0, 0, 0, 128, 3});
  EXPECT_TRUE(comes_to(BusState::error_passive));
  EXPECT_EQ(port.error_counters(), (ErrorCounters{128, 3}));
  EXPECT_TRUE(port.transmit({.id = 5}, test::clock_ns())) << "an error-passive station sends";
  tell(CAN_ERR_BUSOFF, {0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_TRUE(comes_to(BusState::bus_off));
  tell(CAN_ERR_RESTARTED, {0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_TRUE(comes_to(BusState::error_active));
  EXPECT_EQ(port.error_counters(), (ErrorCounters{0, 0}));
  tell(CAN_ERR_ACK | CAN_ERR_PROT | CAN_ERR_TRX, {0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_TRUE(test::work(port, [&] { return port.statistics().error_frames == 4; }));
  EXPECT_EQ(port.statistics().error_passive, 1U);
  EXPECT_EQ(port.statistics().bus_off, 1U);
  EXPECT_EQ(port.statistics().recovered, 1U);
  EXPECT_EQ(port.statistics().no_acknowledge, 1U);
  EXPECT_EQ(port.statistics().protocol_violations, 1U);
  EXPECT_EQ(port.statistics().transceiver_faults, 1U);
  EXPECT_EQ(port.statistics().received, 0U) << "error frames are no frames of the bus";
  expect_working();
}

TEST_F(SocketCanInterface, AtBusOffWaitingFramesAreDroppedAndNoneComesOutAfterwards) {
  interface.delay("100s");
  for (const std::uint32_t id : {0x10U, 0x11U, 0x12U}) {
    ASSERT_TRUE(port.transmit({.id = id}, test::clock_ns()));
    port.flush(test::clock_ns());
  }
  interface.delay("0ms");
  tell(CAN_ERR_BUSOFF, {0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_TRUE(comes_to(BusState::bus_off));
  EXPECT_EQ(port.statistics().flushed, 2U);
  EXPECT_EQ(port.statistics().lost, 1U);
  EXPECT_FALSE(port.transmit({.id = 1}, test::clock_ns()));
  tell(CAN_ERR_RESTARTED, {0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_TRUE(comes_to(BusState::error_active));
  expect_working();
}

TEST_F(SocketCanInterface, SupervisionAllocatesNothing) {
  interface.down();
  EXPECT_TRUE(comes_to(BusState::down));
  const std::int64_t now_ns = test::clock_ns();
  const long before = gaitway::test::allocation_count();
  for (int i = 0; i < 20; ++i) {
    port.flush(now_ns + i * 1'000'000);
  }
  EXPECT_EQ(gaitway::test::allocation_count(), before);
  EXPECT_EQ(port.state(), BusState::down);
}

}  // namespace
}  // namespace gaitway::can
