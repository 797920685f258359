// What a listener concludes from frames on the bus.
#include "tools/bus/bus_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "gaitway/can/frame.hpp"
#include "gaitway/facts/facts.hpp"
#include "tools/bus/bus_watch_text.hpp"

namespace gaitway::tools {
namespace {

using can::MessageKind;

constexpr std::array<can::NodeId, 2> kNodes{1, 2};
constexpr std::int64_t kSlot_ns = facts::kSlot_ns;

can::TimedFrame at(const can::Frame& frame, std::int64_t start_ns) {
  return {
      .frame = frame, .start_ns = start_ns, .end_ns = start_ns + can::frame_bits(frame) * facts::kBitTime_ns};
}

class Watching : public ::testing::Test {
 protected:
  // Returns the end of the frame.
  std::int64_t send(const can::Frame& frame, std::int64_t start_ns) {
    const can::TimedFrame timed = at(frame, start_ns);
    watch_.take(timed);
    return timed.end_ns;
  }
  std::int64_t send_sync(int slot) {
    return send(can::encode(can::kFullProfile, can::Sync{.slot = static_cast<std::uint8_t>(slot % 8)}),
                slot * kSlot_ns);
  }
  std::int64_t send_feedback(can::NodeId node, std::int64_t start_ns) {
    return send(can::encode(can::kFullProfile, can::Feedback{.node = node, .position = 123}), start_ns);
  }
  BusWatch watch_{can::kFullProfile, kNodes, BusClock::robot};
};

TEST_F(Watching, TheLoadIsWhatTheFramesTakeWithTheirInterframeSpaces) {
  const can::Frame sync = can::encode(can::kFullProfile, can::Sync{});
  send(sync, 0);
  const std::int64_t busy_ns = (can::frame_bits(sync) + can::kInterframeBits) * facts::kBitTime_ns;
  EXPECT_DOUBLE_EQ(watch_.close_window(1'000'000).load, static_cast<double>(busy_ns) * 1e-6);
  EXPECT_DOUBLE_EQ(watch_.close_window(2'000'000).load, 0.0);
}

TEST_F(Watching, RatesAreThoseOfTheWindow) {
  for (int slot = 0; slot < 10; ++slot) {
    send_sync(slot);
  }
  const BusWindow first = watch_.close_window(10 * kSlot_ns);
  EXPECT_DOUBLE_EQ(first.rate_per_s[static_cast<std::size_t>(MessageKind::sync)], 100.0);
  send_sync(10);
  const BusWindow second = watch_.close_window(20 * kSlot_ns);
  EXPECT_DOUBLE_EQ(second.rate_per_s[static_cast<std::size_t>(MessageKind::sync)], 10.0);
  EXPECT_EQ(watch_.message(MessageKind::sync).frames, 11U);
}

TEST_F(Watching, AFeedbackRespondsToTheSyncBeforeIt) {
  const std::int64_t sync_end_ns = send_sync(0);
  const std::int64_t first_end_ns = send_feedback(1, sync_end_ns + 3000);
  const std::int64_t second_end_ns = send_feedback(2, first_end_ns + 1'000'000);
  const Spread& response_ms = watch_.message(MessageKind::feedback).response_ms;
  EXPECT_EQ(response_ms.count, 2U);
  EXPECT_DOUBLE_EQ(response_ms.min, static_cast<double>(first_end_ns - sync_end_ns) * 1e-6);
  EXPECT_DOUBLE_EQ(response_ms.max, static_cast<double>(second_end_ns - sync_end_ns) * 1e-6);
}

TEST_F(Watching, ASecondFeedbackAnswersNothing) {
  const std::int64_t sync_end_ns = send_sync(0);
  const std::int64_t end_ns = send_feedback(1, sync_end_ns + 3000);
  send_feedback(1, end_ns + 3000);
  EXPECT_EQ(watch_.message(MessageKind::feedback).frames, 2U);
  EXPECT_EQ(watch_.message(MessageKind::feedback).response_ms.count, 1U);
}

TEST_F(Watching, ASyncIsMeasuredFromTheSlotsEdgeOnTheRobotsClockAlone) {
  const std::int64_t end_ns = send(can::encode(can::kFullProfile, can::Sync{}), 3 * kSlot_ns + 50'000);
  EXPECT_DOUBLE_EQ(watch_.message(MessageKind::sync).response_ms.max,
                   static_cast<double>(end_ns - 3 * kSlot_ns) * 1e-6);
  BusWatch dated(can::kFullProfile, kNodes, BusClock::other);
  dated.take(at(can::encode(can::kFullProfile, can::Sync{}), 3 * kSlot_ns + 50'000));
  EXPECT_EQ(dated.message(MessageKind::sync).response_ms.count, 0U);
}

TEST_F(Watching, ABatchIsMeasuredFromItsFirstFrame) {
  const auto trajectory = [](can::NodeId node, bool toggle) {
    return can::encode(can::kFullProfile, can::Trajectory{.node = node, .toggle = toggle});
  };
  send(trajectory(1, false), 1'000'000);
  const std::int64_t end_ns = send(trajectory(2, false), 3'000'000);
  const double whole_ms = static_cast<double>(end_ns - 1'000'000) * 1e-6;
  EXPECT_DOUBLE_EQ(watch_.message(MessageKind::trajectory).response_ms.max, whole_ms);
  send(trajectory(1, true), 81'000'000);  // the next batch
  EXPECT_DOUBLE_EQ(watch_.message(MessageKind::trajectory).response_ms.max, whole_ms);
}

TEST_F(Watching, InThePapersProfileAFeedbackRespondsToItsTrajectory) {
  BusWatch watch(can::kPaperProfile, kNodes, BusClock::robot);
  const can::TimedFrame batch = at(can::encode(can::kPaperProfile, can::Trajectory{.node = 1}), 80'000'000);
  const can::TimedFrame answer =
      at(can::encode(can::kPaperProfile, can::Feedback{.node = 1}), batch.end_ns + 400'000);
  watch.take(batch);
  watch.take(answer);
  watch.take(at(answer.frame, answer.start_ns + kSlot_ns));  // of the joint's own clock
  const MessageFigures& feedback = watch.message(MessageKind::feedback);
  EXPECT_EQ(feedback.response_ms.count, 1U);
  EXPECT_DOUBLE_EQ(feedback.response_ms.max, static_cast<double>(answer.end_ns - batch.end_ns) * 1e-6);
  EXPECT_DOUBLE_EQ(watch.message(MessageKind::trajectory).response_ms.max,
                   static_cast<double>(batch.end_ns - 80'000'000) * 1e-6);
}

TEST_F(Watching, FramesOfNoMessageAreCountedUnderTheirCause) {
  send({.id = 0x7FF}, 0);
  send({.id = 0x008, .size = 8}, 1'000'000);
  send({.id = 0x008, .size = 3, .extended = true}, 2'000'000);
  send({.id = 0x008, .size = 3, .remote = true}, 3'000'000);
  for (const Stranger cause :
       {Stranger::unknown_identifier, Stranger::wrong_size, Stranger::extended, Stranger::remote}) {
    EXPECT_EQ(watch_.strangers(cause), 1U) << static_cast<int>(cause);
  }
  EXPECT_EQ(watch_.strangers(), 4U);
  EXPECT_EQ(watch_.message(MessageKind::sync).frames, 0U);
  ASSERT_TRUE(watch_.last_stranger());
  EXPECT_TRUE(watch_.last_stranger()->remote);
}

TEST_F(Watching, ANodeIsSilentAfterTwoSlotsWithoutFeedback) {
  send_feedback(1, 0);
  send_feedback(2, 1'000'000);
  EXPECT_TRUE(watch_.silent_nodes().empty());
  send_sync(1);
  send_sync(2);
  send_feedback(2, 2 * kSlot_ns + 200'000);
  EXPECT_THAT(watch_.silent_nodes(), testing::ElementsAre(1));
}

TEST_F(Watching, AResponseBeyondItsBoundIsNamed) {
  const can::Proof proof = can::prove(can::kFullProfile, kNodes);
  const std::int64_t bound_ns = proof.worst_response_ns(MessageKind::feedback).value();
  const std::int64_t sync_end_ns = send_sync(0);
  const std::int64_t length_ns =
      at(can::encode(can::kFullProfile, can::Feedback{.node = 1, .position = 123}), 0).end_ns;
  send_feedback(1, sync_end_ns + bound_ns - length_ns - can::kInterframeBits * facts::kBitTime_ns);
  EXPECT_TRUE(beyond_bound(watch_, proof).empty()) << "exactly at the bound";
  send_feedback(2, sync_end_ns + bound_ns);
  EXPECT_THAT(beyond_bound(watch_, proof), testing::ElementsAre(MessageKind::feedback));
}

}  // namespace
}  // namespace gaitway::tools
