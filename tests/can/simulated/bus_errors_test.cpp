// Error frames on the simulated bus: what they cost, to the bit, and what becomes of the frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../reference_wire.hpp"
#include "traffic.hpp"

namespace gaitway::can {
namespace {

void run_to_first_error(SimulatedBus& bus, Trace& trace) {
  for (std::int64_t now_ns = 0; trace.errors.empty() && now_ns < 200'000; now_ns += 5 * kBit_ns) {
    trace.run(bus, now_ns);
  }
}

class BusErrorsTest : public testing::Test {
 protected:
  BusErrorsTest() { attach(bus, 4); }
  void run_to(std::int64_t until_ns) { trace.run(bus, until_ns); }

  SimulatedBus bus;
  Trace trace;
};

TEST_F(BusErrorsTest, ACorruptedFrameIsRepeatedAndCountedByEverybody) {
  bus.set_random_faults({.seed = 3, .corruption = 1.0});
  bus.transmit(0, numbered_frame(0x100), 0);
  run_to_first_error(bus, trace);
  bus.set_random_faults({});
  run_to(1'000'000);
  ASSERT_EQ(trace.errors.size(), 1U);
  ASSERT_EQ(trace.deliveries.size(), 1U);
  const ErrorFrame& error = trace.errors[0];
  EXPECT_EQ(error.cause, FaultCause::corruption);
  EXPECT_EQ(error.sender, 0);
  EXPECT_EQ(error.frame, numbered_frame(0x100));
  EXPECT_EQ(error.start_ns, 0);
  EXPECT_EQ(error.error_ns, (error.bit + 1) * kBit_ns);
  EXPECT_EQ(error.sender_counters.transmit, 8);
  EXPECT_EQ(trace.deliveries[0].receivers.size(), 3);
  EXPECT_EQ(bus.error_counters(0).transmit, 7) << "8 for the error, 1 less for the success";
  EXPECT_EQ(bus.error_counters(1).receive, 0) << "1 for the error, 1 less for the frame";
  EXPECT_EQ(bus.statistics().retransmissions, 1U);
  EXPECT_EQ(bus.statistics().injected.corruptions, 1U);
  // Flag, perhaps those of others behind it, delimiter, intermission.
  const std::int64_t cost_ns = trace.deliveries[0].start_ns - error.error_ns;
  EXPECT_GE(cost_ns, (6 + 8 + 3) * kBit_ns);
  EXPECT_LE(cost_ns, (12 + 8 + 3) * kBit_ns);
  EXPECT_EQ(bus.statistics().busy_ns, trace.deliveries[0].end_ns + 3 * kBit_ns);
}

TEST_F(BusErrorsTest, WhereverTheBitIsNoErrorCostsMoreThan31BitsAndTheRepeatedFrame) {
  std::set<int> bits;
  std::set<ErrorKind> kinds;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    SimulatedBus one;
    attach(one, 3);
    one.set_random_faults({.seed = seed, .corruption = 1.0});
    const Frame frame{0x0F8, 8, {0x3C, 0x01, 0xE1, 0xF0, 0x78, 0xFF, 0xF8, 0x3C}};
    one.transmit(1, frame, 0);
    Trace course;
    run_to_first_error(one, course);
    one.set_random_faults({});
    course.run(one, 1'000'000);
    ASSERT_EQ(course.errors.size(), 1U);
    ASSERT_EQ(course.deliveries.size(), 1U);
    bits.insert(course.errors[0].bit);
    kinds.insert(course.errors[0].kind);
    const std::int64_t damage_ns = course.deliveries[0].start_ns;
    ASSERT_LE(damage_ns, (worst_case_bits(8) + 31) * kBit_ns) << "bit " << course.errors[0].bit;
  }
  EXPECT_GT(bits.size(), 100U);
  EXPECT_TRUE(kinds.contains(ErrorKind::bit));
  EXPECT_TRUE(kinds.contains(ErrorKind::stuff)) << "its sender gave way to a bit of the arbitration field";
  EXPECT_TRUE(kinds.contains(ErrorKind::acknowledge));
}

// The receivers that see an error in the last but one bit send their flag from the last bit on; it is an
// overload condition to the others and an error to the sender, so the next flag is over 6 bits behind the
// frame. Delimiter and intermission follow.
TEST_F(BusErrorsTest, ADuplicateCostsSixBitsOfFlagBehindTheFrame) {
  bus.set_random_faults({.seed = 5, .duplicate = 1.0});
  bus.transmit(0, numbered_frame(0x100), 0);
  run_to(130'000);
  bus.set_random_faults({});
  run_to(1'000'000);
  ASSERT_EQ(trace.deliveries.size(), 2U);
  const auto& once = trace.deliveries[0];
  const auto& again = trace.deliveries[1];
  EXPECT_FALSE(once.sent_by(0));
  EXPECT_TRUE(again.sent_by(0));
  EXPECT_GE(once.receivers.size(), 1);
  EXPECT_LE(once.receivers.size(), 2);
  EXPECT_EQ(again.receivers.size(), 3);
  EXPECT_EQ(again.start_ns, (once.bits + 6 + 8 + 3) * kBit_ns);
  EXPECT_EQ(bus.error_counters(0).transmit, 7);
  for (int station = 1; station < 4; ++station) {
    const int expected = once.received_by(station) ? 0 : 8;  // 1 + 8, since it was the first to see it, - 1
    EXPECT_EQ(bus.error_counters(station).receive, expected) << station;
  }
  EXPECT_EQ(bus.statistics().injected.duplicates, 1U);
  EXPECT_EQ(bus.statistics().frames, 1U);
}

TEST_F(BusErrorsTest, AnOmissionIsSeenByNobody) {
  StationSet victims;
  victims.insert(2);
  bus.set_random_faults({.seed = 1, .omission = 1.0, .victims = victims});
  bus.transmit(0, numbered_frame(0x100), 0);
  bus.transmit(2, numbered_frame(0x200), 0);
  run_to(1'000'000);
  ASSERT_EQ(trace.deliveries.size(), 2U);
  EXPECT_FALSE(trace.deliveries[0].received_by(2));
  EXPECT_TRUE(trace.deliveries[0].received_by(1));
  EXPECT_TRUE(trace.deliveries[0].sent_by(0));
  EXPECT_FALSE(trace.deliveries[0].lost);
  EXPECT_TRUE(trace.errors.empty());
  EXPECT_EQ(bus.statistics().injected.omissions, 1U) << "the victim's own frame reaches everybody";
  EXPECT_EQ(bus.statistics().injected.omitted_receptions, 1U);
}

TEST_F(BusErrorsTest, EqualFramesSentAtOnceMerge) {
  bus.transmit(3, numbered_frame(0x100), 0);
  bus.transmit(1, numbered_frame(0x100), 0);
  run_to(1'000'000);
  ASSERT_EQ(trace.deliveries.size(), 1U);
  const auto& both = trace.deliveries[0];
  EXPECT_EQ(both.sender, 1);
  EXPECT_TRUE(both.sent_by(1) && both.sent_by(3));
  EXPECT_TRUE(both.received_by(0) && both.received_by(2));
  EXPECT_FALSE(both.received_by(1) || both.received_by(3));
  EXPECT_EQ(both.end_ns, both.bits * kBit_ns);
  EXPECT_EQ(bus.statistics().merged, 1U);
  EXPECT_FALSE(bus.transmit_pending(1) || bus.transmit_pending(3));
}

TEST_F(BusErrorsTest, DifferentFramesOfOneIdentifierDestroyEachOtherUntilPassive) {
  const Frame high = numbered_frame(0x100, 0xF0), low = numbered_frame(0x100, 0x00);
  const reference::Bits a = reference::wire(high), b = reference::wire(low);
  const auto differs = std::mismatch(a.begin(), a.end(), b.begin()).first - a.begin();
  bus.transmit(1, high, 0);
  bus.transmit(3, low, 0);
  run_to(10'000'000);
  // Sixteen times both get 8; then they are passive, the recessive one's flag does no harm, and the dominant
  // one comes through; the other follows.
  ASSERT_EQ(trace.errors.size(), 17U);
  for (const ErrorFrame& error : trace.errors) {
    EXPECT_EQ(error.cause, FaultCause::collision);
    EXPECT_EQ(error.bit, differs);
    EXPECT_EQ(error.detected_by, 1);
    EXPECT_EQ(error.kind, ErrorKind::bit);
  }
  ASSERT_EQ(trace.deliveries.size(), 2U);
  EXPECT_EQ(trace.deliveries[0].frame, low);
  EXPECT_EQ(trace.deliveries[0].sender, 3);
  EXPECT_FALSE(trace.deliveries[0].received_by(1));
  EXPECT_EQ(trace.deliveries[1].frame, high);
  EXPECT_EQ(bus.error_counters(3).transmit, 127);
  EXPECT_EQ(bus.error_counters(1).transmit, 135);
  EXPECT_EQ(bus.statistics().collisions, 17U);
  EXPECT_EQ(bus.state(1), BusState::error_passive);
  // The last to change: station 3 is active again.
  EXPECT_EQ(trace.changes.back().station, 3);
  EXPECT_EQ(trace.changes.back().state, BusState::error_active);
}

TEST_F(BusErrorsTest, APassiveSenderWaitsEightBitsMoreAndLetsOthersGoFirst) {
  bus.transmit(1, numbered_frame(0x100, 0xF0), 0);
  bus.transmit(3, numbered_frame(0x100, 0x00), 0);
  run_to(10'000'000);
  ASSERT_EQ(bus.state(1), BusState::error_passive);
  trace.deliveries.clear();
  const auto again = [&](const SimulatedBus::Delivery& delivery) {
    if (delivery.sender == 1 && trace.deliveries.size() < 3) {
      bus.transmit(1, numbered_frame(0x010, 1), delivery.end_ns);
    }
    if (trace.deliveries.size() == 2) {
      bus.transmit(2, numbered_frame(0x700, 2), delivery.end_ns);
    }
  };
  bus.transmit(1, numbered_frame(0x010), 10'000'000);
  trace.run(bus, 20'000'000, again);
  ASSERT_EQ(trace.deliveries.size(), 4U);
  const auto& sent = trace.deliveries;
  EXPECT_EQ(sent[1].start_ns, sent[0].end_ns + (3 + 8) * kBit_ns);
  EXPECT_EQ(sent[2].frame.id, 0x700U) << "it starts while the passive one is suspended";
  EXPECT_EQ(sent[2].start_ns, sent[1].end_ns + 3 * kBit_ns);
  EXPECT_EQ(sent[3].frame.id, 0x010U);
  EXPECT_EQ(sent[3].start_ns, sent[2].end_ns + 3 * kBit_ns) << "not suspended after another's frame";
}

TEST(LoneStation, IsNeverAcknowledgedAndGoesPassiveButNeverBusOff) {
  SimulatedBus bus;
  bus.attach();
  const Frame frame = numbered_frame(0x123);
  const int bits = frame_bits(frame);
  bus.transmit(0, frame, 0);
  Trace trace;
  for (int i = 1; i <= 100; ++i) {
    trace.run(bus, i * 1'000'000);
  }
  EXPECT_TRUE(trace.deliveries.empty());
  EXPECT_EQ(bus.error_counters(0), (ErrorCounters{128, 0}));
  EXPECT_EQ(bus.state(0), BusState::error_passive);
  ASSERT_GT(trace.errors.size(), 600U);
  ASSERT_EQ(trace.changes.size(), 1U);
  EXPECT_EQ(trace.changes[0].time_ns, trace.errors[15].error_ns);
  for (std::size_t i = 1; i < trace.errors.size(); ++i) {
    // The flag begins behind the ACK slot, which is ten bits before the end of an undisturbed frame.
    const int cost = bits - 8 + 6 + 8 + 3 + (i >= 16 ? 8 : 0);
    ASSERT_EQ(trace.errors[i].kind, ErrorKind::acknowledge);
    ASSERT_EQ(trace.errors[i].cause, FaultCause::no_acknowledge);
    ASSERT_EQ(trace.errors[i].start_ns - trace.errors[i - 1].start_ns, cost * kBit_ns) << i;
  }
  EXPECT_EQ(bus.statistics().unacknowledged, trace.errors.size());
  EXPECT_EQ(bus.statistics().retransmissions, trace.errors.size());
  bus.attach();  // somebody comes
  trace.run(bus, 101'000'000);
  EXPECT_EQ(trace.deliveries.size(), 1U);
}

TEST(Arbitration, RandomFramesOfAllFormatsGoInTheOrderOfWiredAnd) {
  std::mt19937 random(21);
  for (int round = 0; round < 3000; ++round) {
    SimulatedBus bus;
    std::vector<Frame> waiting;
    std::set<std::uint32_t> keys;
    while (waiting.size() < 6) {
      Frame frame = reference::draw_frame(random);
      if (random() % 2 == 0 && !waiting.empty()) {
        // Close to another: base and extended, data and remote of one identifier.
        frame.id = waiting[0].extended == frame.extended ? waiting[0].id
                   : frame.extended                      ? waiting[0].id << 18U
                                                         : waiting[0].id >> 18U;
      }
      if (keys.insert(arbitration_key(frame)).second) {
        bus.transmit(bus.attach(), frame, 0);
        waiting.push_back(frame);
      }
    }
    std::int64_t free_ns = 0;
    while (const auto delivery = bus.advance(10'000'000)) {
      const std::size_t winner = reference::arbitrate(waiting);
      ASSERT_EQ(delivery->frame, waiting[winner]);
      ASSERT_EQ(delivery->start_ns, free_ns);
      free_ns = delivery->end_ns + 3 * kBit_ns;
      waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(winner));
    }
    ASSERT_TRUE(waiting.empty());
  }
}

}  // namespace
}  // namespace gaitway::can
