// The port on a virtual interface: which frames go, which come, in which order and when.
#include "gaitway/can/socketcan_port.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "allocation_count.hpp"
#include "can_station.hpp"
#include "gaitway/can/frame.hpp"

namespace gaitway::can {
namespace {

using testing::ElementsAre;

// A busy machine may take its time to deliver an echo: only where that is the question, there is a deadline.
constexpr std::int64_t kNever_ns = 3'600'000'000'000;

class SocketCan : public testing::Test {
 protected:
  // Frames go out and nothing comes in.
  static void send(SocketCanPort& port, const std::vector<Frame>& frames) {
    for (const Frame& frame : frames) {
      ASSERT_TRUE(port.transmit(frame, test::clock_ns()));
    }
    port.flush(test::clock_ns());
  }
  static bool idle(const SocketCanPort& port) { return !port.transmit_pending(); }
  // Every accepted frame has ended in exactly one way.
  static void expect_sound(const SocketCanStatistics& s) {
    EXPECT_EQ(s.accepted, s.sent + s.unconfirmed + s.lost + s.flushed + s.failed);
  }

  test::Interface interface;
  test::Station other{interface.name};
};

TEST_F(SocketCan, FramesOfAnotherStationComeInOrderWithTheirBytes) {
  SocketCanPort port(interface.name, {.echo_deadline_ns = kNever_ns});
  EXPECT_EQ(port.state(), BusState::error_active);
  EXPECT_FALSE(port.receive());
  other.send(0x123, {1, 2, 3});
  other.send(0x7FF, {});
  other.send(0x000, {8, 7, 6, 5, 4, 3, 2, 1});
  const auto frames = test::receive(port, 3);
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(frames[0].frame, (Frame{.id = 0x123, .size = 3, .data = {1, 2, 3}}));
  EXPECT_EQ(frames[1].frame, (Frame{.id = 0x7FF}));
  EXPECT_EQ(frames[2].frame, (Frame{.id = 0, .size = 8, .data = {8, 7, 6, 5, 4, 3, 2, 1}}));
  EXPECT_EQ(port.statistics().received, 3U);
}

TEST_F(SocketCan, OwnFramesAreConfirmedAndNotReceived) {
  SocketCanPort port(interface.name, {.echo_deadline_ns = kNever_ns});
  send(port, {{.id = 0x40, .size = 2, .data = {9, 8}}, {.id = 0x41, .size = 0}});
  EXPECT_TRUE(test::work(port, [&] { return idle(port); }));
  EXPECT_EQ(port.statistics().sent, 2U);
  EXPECT_FALSE(port.receive());
  const auto seen = other.receive(2);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[0].can_id, 0x40U);
  EXPECT_THAT(std::vector(seen[0].data, seen[0].data + seen[0].len), ElementsAre(9, 8));
  EXPECT_EQ(seen[1].can_id, 0x41U);
  expect_sound(port.statistics());
}

TEST_F(SocketCan, AFrameWithAnOwnIdentifierFromElsewhereIsReceived) {
  SocketCanPort port(interface.name, {.echo_deadline_ns = kNever_ns});
  SocketCanPort twin(interface.name, {.echo_deadline_ns = kNever_ns});
  const Frame own{.id = 0x40, .size = 1, .data = {1}};
  send(port, {own});
  other.send(0x40, {1});
  send(twin, {own});
  const auto frames = test::receive(port, 2);
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].frame, own);
  EXPECT_EQ(frames[1].frame, own);
  EXPECT_EQ(port.statistics().sent, 1U);
  EXPECT_FALSE(port.receive());
}

TEST_F(SocketCan, FiltersLetNothingElseThrough) {
  SocketCanPort port(interface.name, {.filters = {{0x100, 0x700}, {0x1234567, 0x1FFFFFFF, true}},
                                      .echo_deadline_ns = kNever_ns});
  for (const canid_t id :
       {0x0FFU, 0x100U, 0x1FFU, 0x200U, 0x100U | CAN_EFF_FLAG, 0x1234567U | CAN_EFF_FLAG, 0x199U}) {
    other.send(id);
  }
  const auto frames = test::receive(port, 4);
  ASSERT_EQ(frames.size(), 4U);
  EXPECT_EQ(frames[0].frame.id, 0x100U);
  EXPECT_EQ(frames[1].frame.id, 0x1FFU);
  EXPECT_EQ(frames[2].frame.id, 0x1234567U);
  EXPECT_EQ(frames[3].frame.id, 0x199U);
  send(port, {{.id = 0x100}, {.id = 0x200}});
  EXPECT_TRUE(test::work(port, [&] { return idle(port); }));
  EXPECT_EQ(port.statistics().sent, 1U);
  EXPECT_EQ(port.statistics().unconfirmed, 1U) << "its echo does not pass";
  expect_sound(port.statistics());
}

TEST_F(SocketCan, ExtendedAndRemoteFramesKeepTheirFormat) {
  SocketCanPort port(interface.name, {.echo_deadline_ns = kNever_ns});
  other.send(0x1FFFFFFFU | CAN_EFF_FLAG, {7});
  other.send(0x123U | CAN_RTR_FLAG);
  other.send(0x5U | CAN_EFF_FLAG | CAN_RTR_FLAG);
  const auto frames = test::receive(port, 3);
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(frames[0].frame, (Frame{.id = 0x1FFFFFFF, .size = 1, .data = {7}, .extended = true}));
  EXPECT_EQ(frames[1].frame, (Frame{.id = 0x123, .remote = true}));
  EXPECT_EQ(frames[2].frame, (Frame{.id = 5, .extended = true, .remote = true}));

  send(port, {{.id = 0x12345678, .size = 1, .data = {7}, .extended = true},
              {.id = 0x22, .size = 4, .data = {1, 1, 1, 1}, .remote = true}});
  EXPECT_TRUE(test::work(port, [&] { return idle(port); }));
  const auto seen = other.receive(2);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[0].can_id, 0x22U | CAN_RTR_FLAG);
  EXPECT_EQ(seen[0].len, 4) << "it asks for four bytes";
  EXPECT_EQ(seen[1].can_id, 0x12345678U | CAN_EFF_FLAG);
  EXPECT_EQ(port.statistics().sent, 2U) << "echoes are known in every format";
}

TEST_F(SocketCan, FramesThatCannotBeAreRefused) {
  SocketCanPort port(interface.name, {.echo_deadline_ns = kNever_ns});
  EXPECT_FALSE(port.transmit({.id = 0x800}, 0));
  EXPECT_FALSE(port.transmit({.id = 0x20000000, .extended = true}, 0));
  EXPECT_FALSE(port.transmit({.id = 1, .size = 9}, 0));
  EXPECT_EQ(port.statistics().refused_invalid, 3U);
  EXPECT_FALSE(port.transmit_pending());
}

TEST_F(SocketCan, CanFdFramesAreIgnoredAndCounted) {
  SocketCanPort port(interface.name, {.echo_deadline_ns = kNever_ns});
  other.send_fd(0x10);
  other.send(0x11);
  const auto frames = test::receive(port, 1);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].frame.id, 0x11U);
  EXPECT_EQ(port.statistics().fd_ignored, 1U);
  EXPECT_EQ(port.statistics().received, 1U);
}

// The kernel stamps and the clocks are read at different instants: an interruption between them may cost
// milliseconds, and no more.
TEST_F(SocketCan, TimeStampsAreOfTheRobotsClockAndNeverRunBackwards) {
  constexpr std::int64_t kReading_ns = 10'000'000;
  SocketCanPort port(interface.name, {.echo_deadline_ns = kNever_ns});
  std::int64_t last_ns = 0;
  for (int i = 0; i < 200; ++i) {
    const std::int64_t before_ns = test::clock_ns();
    other.send(0x10, {1, 2, 3, 4, 5, 6, 7, 8});
    const std::int64_t after_ns = test::clock_ns();
    const auto frames = test::receive(port, 1);
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_GE(frames[0].end_ns, before_ns - kReading_ns);
    EXPECT_LE(frames[0].end_ns, after_ns + kReading_ns);
    EXPECT_GE(frames[0].end_ns, last_ns);
    EXPECT_EQ(frames[0].end_ns - frames[0].start_ns, frame_bits(frames[0].frame) * 1000);
    last_ns = frames[0].end_ns;
  }
  EXPECT_EQ(port.statistics().without_stamp, 0U);
}

TEST_F(SocketCan, AFrameThatWasReadLateStillHasTheTimeAtWhichItCame) {
  SocketCanPort port(interface.name, {.echo_deadline_ns = kNever_ns});
  other.send(0x10);
  const std::int64_t sent_ns = test::clock_ns();
  pollfd nothing{-1, 0, 0};
  poll(&nothing, 1, 50);
  const auto frames = test::receive(port, 1);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_LT(frames[0].end_ns, sent_ns + 25'000'000) << "not the time of reading";
}

TEST_F(SocketCan, WaitingFramesGoOutByPriorityAndThoseOfOneIdentifierInTheirOrder) {
  SocketCanPort port(interface.name, {.transmit_buffers = 128, .echo_deadline_ns = kNever_ns});
  std::vector<Frame> frames;
  for (std::uint8_t i = 0; i < 100; ++i) {
    frames.push_back({.id = 0x100U + i / 4U, .size = 1, .data = {static_cast<std::uint8_t>(i % 4)}});
  }
  std::vector<Frame> shuffled = frames;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(5));
  std::stable_sort(shuffled.begin(), shuffled.end(),
                   [](const Frame& a, const Frame& b) { return a.data[0] < b.data[0]; });
  send(port, shuffled);
  EXPECT_TRUE(test::work(port, [&] { return idle(port); }));
  const auto seen = other.receive(frames.size());
  ASSERT_EQ(seen.size(), frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(seen[i].can_id, frames[i].id);
    EXPECT_EQ(seen[i].data[0], frames[i].data[0]);
  }
}

TEST_F(SocketCan, TheKernelHasOneFrameAtATimeSoThatAnUrgentOneOvertakesTheRest) {
  interface.delay("30ms");
  SocketCanPort port(interface.name, {.echo_deadline_ns = kNever_ns});
  for (const std::uint32_t id : {0x700U, 0x600U, 0x601U, 0x100U}) {
    send(port, {{.id = id}});  // each by itself: a queue of the kernel would keep this order
  }
  EXPECT_TRUE(port.transmit_pending());
  EXPECT_TRUE(test::work(port, [&] { return idle(port); }));
  EXPECT_THAT(other.receive_ids(4), ElementsAre(0x700, 0x100, 0x600, 0x601));
  EXPECT_EQ(port.statistics().sent, 4U);
}

TEST_F(SocketCan, AFullPortRefusesAndCounts) {
  SocketCanPort port(interface.name, {.transmit_buffers = 2, .echo_deadline_ns = kNever_ns});
  EXPECT_EQ(port.free_buffers(), 2U);
  EXPECT_TRUE(port.transmit({.id = 2}, 0));
  EXPECT_TRUE(port.transmit({.id = 3}, 0));
  EXPECT_EQ(port.free_buffers(), 0U);
  EXPECT_FALSE(port.transmit({.id = 1}, 0));
  EXPECT_EQ(port.statistics().refused_full, 1U);
  EXPECT_TRUE(test::work(port, [&] { return idle(port); }));
  EXPECT_THAT(other.receive_ids(2), ElementsAre(2, 3));
  EXPECT_TRUE(other.silent());
}

TEST_F(SocketCan, AFullBufferOfTheKernelDelaysAFrameAndIsCounted) {
  interface.delay("30ms", 1);
  SocketCanPort port(interface.name, {.echo_deadline_ns = kNever_ns});
  other.send(0x1);  // occupies the queue
  send(port, {{.id = 0x50}});
  EXPECT_GE(port.statistics().kernel_buffer_full, 1U);
  EXPECT_EQ(port.statistics().sent, 0U);
  EXPECT_TRUE(test::work(port, [&] { return idle(port); }));
  EXPECT_EQ(port.statistics().sent, 1U);
  expect_sound(port.statistics());
}

TEST_F(SocketCan, AFrameWithoutEchoCountsAsLostAtItsDeadlineAndTheNextGoesOut) {
  interface.delay("100s");
  SocketCanPort port(interface.name, {.echo_deadline_ns = 20'000'000});
  const std::int64_t now_ns = test::clock_ns();
  ASSERT_TRUE(port.transmit({.id = 0x10}, now_ns));
  ASSERT_TRUE(port.transmit({.id = 0x11}, now_ns));
  port.flush(now_ns);
  port.flush(now_ns + 19'999'999);
  EXPECT_EQ(port.statistics().lost, 0U);
  interface.delay("0ms");  // a new queue: what lay in the old one is gone
  port.flush(now_ns + 20'000'000);
  EXPECT_EQ(port.statistics().lost, 1U);
  pollfd wake{port.wake_fd(), POLLIN, 0};  // the port's time stands still: it is told nothing
  while (port.transmit_pending() && poll(&wake, 1, test::kPatience_ms) > 0) {
    EXPECT_FALSE(port.receive());
  }
  EXPECT_EQ(port.statistics().sent, 1U);
  EXPECT_THAT(other.receive_ids(1), ElementsAre(0x11));
  expect_sound(port.statistics());
}

TEST_F(SocketCan, AnEchoAfterTheDeadlineIsCountedAsLateAndConfirmsNothingElse) {
  interface.delay("50ms");
  SocketCanPort port(interface.name, {.echo_deadline_ns = 20'000'000});
  const std::int64_t now_ns = test::clock_ns();
  ASSERT_TRUE(port.transmit({.id = 0x10}, now_ns));
  port.flush(now_ns);
  ASSERT_TRUE(port.transmit({.id = 0x11}, now_ns));
  port.flush(now_ns + 20'000'000);  // told, not waited for
  EXPECT_EQ(port.statistics().lost, 1U);
  pollfd wake{port.wake_fd(), POLLIN, 0};
  while (port.statistics().late_echoes + port.statistics().sent < 2 &&
         poll(&wake, 1, test::kPatience_ms) > 0) {
    EXPECT_FALSE(port.receive());
  }
  EXPECT_EQ(port.statistics().late_echoes, 1U);
  EXPECT_EQ(port.statistics().sent, 1U);
  expect_sound(port.statistics());
}

TEST_F(SocketCan, FramesThatTheKernelDroppedAreCounted) {
  SocketCanPort port(interface.name, {.echo_deadline_ns = kNever_ns});
  constexpr std::uint64_t kFrames = 3000;
  for (std::uint64_t i = 0; i < kFrames; ++i) {
    other.send(0x10, {1});  // nobody reads: the socket's buffer runs over
  }
  while (port.receive()) {
  }
  other.send(0x11);  // the count comes with the next frame that has room
  EXPECT_EQ(test::receive(port, 1).size(), 1U);
  EXPECT_GT(port.statistics().dropped_by_kernel, 0U);
  EXPECT_EQ(port.statistics().received + port.statistics().dropped_by_kernel, kFrames + 1);
}

TEST_F(SocketCan, TheSentLogHasWhatWasOnTheBusInItsOrder) {
  const std::string file = testing::TempDir() + "/sent.log";
  {
    CandumpWriter log(file);
    SocketCanPort port(interface.name, {.echo_deadline_ns = kNever_ns, .sent_log = &log});
    send(port, {{.id = 0x30, .size = 2, .data = {1, 2}}, {.id = 0x20, .size = 1, .data = {3}}});
    EXPECT_TRUE(test::work(port, [&] { return idle(port); }));
    log.close();
  }
  const auto logged = read_candump_log(file);
  ASSERT_EQ(logged.size(), 2U);
  EXPECT_EQ(logged[0].frame, (Frame{.id = 0x20, .size = 1, .data = {3}}));
  EXPECT_EQ(logged[1].frame, (Frame{.id = 0x30, .size = 2, .data = {1, 2}}));
}

TEST_F(SocketCan, TheCycleAllocatesNothing) {
  SocketCanPort port(interface.name, {.transmit_buffers = 64, .echo_deadline_ns = kNever_ns});
  const auto cycle = [&] {
    for (std::uint32_t id = 0; id < 40; ++id) {
      static_cast<void>(port.transmit({.id = 0x100 + id, .size = 8}, test::clock_ns()));
    }
    port.flush(test::clock_ns());
    pollfd wake{port.wake_fd(), POLLIN, 0};
    while (port.transmit_pending() && poll(&wake, 1, test::kPatience_ms) > 0) {
      while (port.receive()) {
      }
    }
    while (port.receive()) {
    }
  };
  other.send(0x1);
  cycle();
  for (int i = 0; i < 20; ++i) {
    other.send(0x2, {});
  }
  const long before = gaitway::test::allocation_count();
  cycle();
  EXPECT_EQ(gaitway::test::allocation_count(), before);
  EXPECT_EQ(port.statistics().received, 21U);
  EXPECT_EQ(port.statistics().sent, 80U);
}

}  // namespace
}  // namespace gaitway::can
