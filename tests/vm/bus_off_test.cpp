// Error-passive, bus-off and recovery as the kernel's own driver for serial adapters reports them.
#include <gmock/gmock.h>

#include "gaitway/can/socketcan_port.hpp"
#include "slcan_adapter.hpp"

namespace gaitway::can {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::int64_t kRestartDelay_ns = 5'000'000;

class BusOff : public testing::Test {
 protected:
  bool comes_to(BusState state) {
    return test::work(port, [&] { return port.state() == state; });
  }
  void go_bus_off() {
    adapter.report_state('b', 255, 0);
    EXPECT_TRUE(comes_to(BusState::bus_off));
  }
  // Sends one frame and returns what the adapter was told to put on the bus.
  std::string sent_to_the_bus(std::uint32_t id) {
    EXPECT_TRUE(port.transmit({.id = id, .size = 1, .data = {0xAB}}, test::clock_ns()));
    EXPECT_TRUE(test::work(port, [&] { return !port.transmit_pending(); }));
    return adapter.heard_until("1AB\r");
  }

  test::SlcanAdapter adapter;
  SocketCanPort port{adapter.name,
                     {.echo_deadline_ns = 3'600'000'000'000,
                      .restart_delay_ns = kRestartDelay_ns,
                      .interface_poll_ns = 1'000'000}};
};

TEST_F(BusOff, FramesGoToTheAdapterAndComeFromIt) {
  EXPECT_EQ(port.state(), BusState::error_active);
  EXPECT_EQ(sent_to_the_bus(0x123), "t1231AB\r");
  EXPECT_EQ(port.statistics().sent, 1U);
  adapter.report("t1242CAFE\rT18DAF1101FF\r");
  const auto frames = test::receive(port, 2);
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].frame, (Frame{.id = 0x124, .size = 2, .data = {0xCA, 0xFE}}));
  EXPECT_EQ(frames[1].frame, (Frame{.id = 0x18DAF110, .size = 1, .data = {0xFF}, .extended = true}));
}

TEST_F(BusOff, StateAndErrorCountersFollowTheController) {
  adapter.report_state('w', 96, 5);
  EXPECT_TRUE(test::work(port, [&] { return port.statistics().error_frames == 1; }));
  EXPECT_EQ(port.state(), BusState::error_active) << "a warning limits nothing";
  EXPECT_EQ(port.error_counters(), (ErrorCounters{96, 5}));
  adapter.report_state('p', 128, 7);
  EXPECT_TRUE(comes_to(BusState::error_passive));
  EXPECT_EQ(port.error_counters(), (ErrorCounters{128, 7}));
  EXPECT_EQ(sent_to_the_bus(0x10), "t0101AB\r") << "an error-passive station sends";
  adapter.report_state('a', 90, 0);
  EXPECT_TRUE(comes_to(BusState::error_active));
  EXPECT_EQ(port.error_counters(), (ErrorCounters{90, 0}));
  go_bus_off();
  EXPECT_EQ(port.statistics().error_passive, 1U);
  EXPECT_EQ(port.statistics().bus_off, 1U);
}

TEST_F(BusOff, APortThatOpensLateKnowsTheState) {
  adapter.report_state('p', 130, 4);
  EXPECT_TRUE(comes_to(BusState::error_passive));
  const SocketCanPort second(adapter.name);
  EXPECT_EQ(second.state(), BusState::error_passive);
}

TEST_F(BusOff, ErrorsOnTheBusAreCountedByCause) {
  adapter.report("e1a\r");   // no acknowledge
  adapter.report("e2bf\r");  // bit and form error
  adapter.report("e1o\r");   // receive buffer overrun
  EXPECT_TRUE(test::work(port, [&] { return port.statistics().error_frames == 3; }));
  EXPECT_EQ(port.statistics().no_acknowledge, 1U);
  EXPECT_GE(port.statistics().protocol_violations, 1U);
  EXPECT_EQ(port.statistics().controller_overflows, 1U);
  EXPECT_EQ(port.state(), BusState::error_active);
}

TEST_F(BusOff, WhatWaitedAtBusOffNeverComesOutAfterTheRestart) {
  EXPECT_EQ(sent_to_the_bus(0x100), "t1001AB\r");
  for (std::uint32_t id = 0x200; id < 0x205; ++id) {
    ASSERT_TRUE(port.transmit({.id = id, .size = 1, .data = {0xAB}}, test::clock_ns()));
  }
  adapter.report_state('b', 255, 0);
  while (port.state() != BusState::bus_off) {
    pollfd wake{port.wake_fd(), POLLIN, 0};
    ASSERT_EQ(poll(&wake, 1, test::kPatience_ms), 1);
    EXPECT_FALSE(port.receive());
  }
  EXPECT_EQ(port.statistics().flushed, 5U);
  EXPECT_FALSE(port.transmit_pending());
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(port.transmit({.id = 0x300}, test::clock_ns()));
    port.flush(test::clock_ns());
  }
  EXPECT_EQ(port.statistics().refused_unusable, 10U);
  EXPECT_TRUE(adapter.silent());

  EXPECT_EQ(adapter.down(), "C\r");
  EXPECT_TRUE(comes_to(BusState::down));
  EXPECT_EQ(adapter.up(), "C\rS8\rO\r");
  EXPECT_TRUE(comes_to(BusState::error_active));
  EXPECT_EQ(sent_to_the_bus(0x400), "t4001AB\r") << "and nothing before it";
  const SocketCanStatistics& s = port.statistics();
  EXPECT_EQ(s.accepted, s.sent + s.flushed + s.lost);
  EXPECT_EQ(s.sent, 2U);
}

// This driver has no restart of its own: the kernel says so, and the port passes it on.
TEST_F(BusOff, ARestartThatTheDriverCannotDoIsReportedWithWhatToDo) {
  go_bus_off();
  EXPECT_EQ(port.restart_problem(), "");
  EXPECT_TRUE(test::work(port, [&] { return port.statistics().restarts_refused > 0; }));
  EXPECT_THAT(port.restart_problem(), AllOf(HasSubstr("'" + adapter.name + "'"), HasSubstr("not supported"),
                                            HasSubstr("ip link set " + adapter.name +
                                                      " down && ip link set " + adapter.name + " up")));
  EXPECT_EQ(port.statistics().restarts_requested, 0U);
  EXPECT_EQ(port.state(), BusState::bus_off);
}

TEST_F(BusOff, WithoutTheRightToRestartThePortSaysWhichRightItNeeds) {
  ASSERT_EQ(seteuid(65534), 0);
  go_bus_off();
  EXPECT_TRUE(test::work(port, [&] { return port.statistics().restarts_refused > 0; }));
  ASSERT_EQ(seteuid(0), 0);
  EXPECT_THAT(port.restart_problem(), AllOf(HasSubstr("CAP_NET_ADMIN"), HasSubstr("restart-ms")));
}

TEST_F(BusOff, TheRestartIsAskedForAfterItsDelayAndNotMoreOftenThanThat) {
  adapter.report_state('b', 255, 0);
  const std::int64_t start_ns = test::clock_ns();
  while (port.state() != BusState::bus_off) {
    port.flush(start_ns);
    EXPECT_FALSE(port.receive());
  }
  for (std::int64_t now_ns = start_ns; now_ns < start_ns + kRestartDelay_ns; now_ns += 1'000'000) {
    port.flush(now_ns);
    EXPECT_EQ(port.statistics().restarts_refused, 0U);
  }
  for (std::int64_t i = 1; i <= 3; ++i) {
    port.flush(start_ns + i * kRestartDelay_ns);
    port.flush(start_ns + i * kRestartDelay_ns + 1'000'000);
    EXPECT_EQ(port.statistics().restarts_refused, static_cast<std::uint64_t>(i));
  }
}

TEST_F(BusOff, AFrameFromTheWireShowsThatTheControllerIsBack) {
  go_bus_off();
  test::Station(adapter.name).send(0x55);
  EXPECT_EQ(test::receive(port, 1).size(), 1U);
  EXPECT_EQ(port.state(), BusState::bus_off) << "another program's frame has not been on the wire";
  adapter.report("t1240\r");
  EXPECT_EQ(test::receive(port, 1).size(), 1U);
  EXPECT_EQ(port.state(), BusState::error_active);
}

// The adapter does not read, so the driver stops its queue, and that fills up.
TEST(FullAdapter, NoFrameIsLostWhileTheTransmitQueueIsFull) {
  test::SlcanAdapter adapter(2);
  SocketCanPort port(adapter.name, {.transmit_buffers = 256, .echo_deadline_ns = 3'600'000'000'000});
  std::uint32_t accepted = 0;
  while (port.statistics().kernel_buffer_full == 0 && accepted < 100'000) {
    if (port.transmit({.id = accepted % 0x800, .size = 1, .data = {0xAB}}, test::clock_ns())) {
      ++accepted;
    }
    port.flush(test::clock_ns());
    while (port.receive()) {
    }
  }
  EXPECT_GT(port.statistics().kernel_buffer_full, 0U);
  EXPECT_TRUE(port.transmit_pending());
  std::uint32_t heard = 0;
  const auto listen = [&] {
    while (!adapter.silent()) {
      char id[8];
      std::snprintf(id, sizeof id, "t%03X", heard++ % 0x800);
      EXPECT_EQ(adapter.heard_until("\r"), id + std::string("1AB\r"));
    }
    return heard == accepted;
  };
  EXPECT_TRUE(test::work(port, listen)) << heard << " of " << accepted;
}

}  // namespace
}  // namespace gaitway::can
