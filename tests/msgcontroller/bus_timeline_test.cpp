// However late the process wakes, the message controller lives through its milliseconds in order.
#include "gaitway/msgcontroller/bus_timeline.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <filesystem>
#include <limits>
#include <vector>

#include "gaitway/can/profile.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::msgcontroller {
namespace {

using facts::kMillisecond_ns;
using facts::kSlot_ns;

constexpr std::int64_t kStart_ns = 1000 * facts::kCycle_ns - 500'000;

// Keeps what is sent, with its time, and hands out what a test puts in.
class RecordingPort final : public can::BusPort {
 public:
  struct Sent {
    can::Frame frame;
    std::int64_t at_ns;
  };
  bool transmit(const can::Frame& frame, std::int64_t now_ns) override {
    if (occupied || held == buffers) {
      return false;
    }
    ++held;
    sent.push_back({frame, now_ns});
    return true;
  }
  [[nodiscard]] bool transmit_pending() const override { return false; }
  std::optional<can::TimedFrame> receive() override {
    if (arriving.empty()) {
      return std::nullopt;
    }
    const can::TimedFrame frame = arriving.front();
    arriving.pop_front();
    return frame;
  }
  std::optional<can::BusNotice> next_notice() noexcept override {
    if (notices.empty()) {
      return std::nullopt;
    }
    const can::BusNotice notice = notices.front();
    notices.pop_front();
    return notice;
  }
  void flush(std::int64_t now_ns) override {
    flushed.push_back(now_ns);
    held = 0;  // everything is on the bus at once
  }
  [[nodiscard]] can::BusState state() const noexcept override { return bus_state; }
  [[nodiscard]] bool caught_up(std::int64_t time_ns) const noexcept override {
    return bus_time_ns >= time_ns;
  }
  [[nodiscard]] bool takes_back() const noexcept override { return revocable; }
  [[nodiscard]] std::int64_t longest_wait_ns() const noexcept override { return longest_ns; }
  [[nodiscard]] int wake_fd() const noexcept override { return -1; }

  [[nodiscard]] std::vector<std::int64_t> times_of(can::MessageKind kind) const {
    std::vector<std::int64_t> times;
    for (const Sent& item : sent) {
      const auto message = can::kFullProfile.identify(item.frame.id);
      if (message && message->kind == kind) {
        times.push_back(item.at_ns);
      }
    }
    return times;
  }

  // Times of the SYNCs that were sent.
  [[nodiscard]] std::vector<std::int64_t> syncs() const {
    std::vector<std::int64_t> times;
    for (const Sent& item : sent) {
      if (item.frame.id == can::kFullProfile.id_of(can::MessageKind::sync)) {
        times.push_back(item.at_ns);
      }
    }
    return times;
  }
  bool occupied = false;
  bool revocable = true;
  std::int64_t longest_ns = can::kLongestWait_ns;
  std::size_t buffers = std::numeric_limits<std::size_t>::max();
  std::size_t held = 0;
  can::BusState bus_state = can::BusState::error_active;
  std::int64_t bus_time_ns = std::numeric_limits<std::int64_t>::max();
  std::vector<Sent> sent;
  std::vector<std::int64_t> flushed;
  std::deque<can::TimedFrame> arriving;
  std::deque<can::BusNotice> notices;
};

class BusTimelineTest : public testing::Test {
 protected:
  // One feedback of every joint of the slot that begins at `slot_ns`, a microsecond apart.
  void answer(std::int64_t slot_ns) {
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      can::Feedback feedback;
      feedback.node = robot.joints[joint].node;
      const auto home = std::lround(robot.joints[joint].home_rad / robot.joints[joint].count_rad);
      feedback.reference_low = static_cast<std::uint8_t>(static_cast<std::uint64_t>(home) & 0xFU);
      const std::int64_t end_ns = slot_ns + 2 * kMillisecond_ns + static_cast<std::int64_t>(joint) * 1000;
      port.arriving.push_back({can::encode(can::kFullProfile, feedback), end_ns - 1000, end_ns});
    }
  }

  urdf::RobotModel robot =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  msgclient::MemoryBlock block;
  msgclient::Client client = block.local_client("message_controller");
  msgclient::EmiMessage adapter{client};
  MessageController controller{robot, client, adapter};
  RecordingPort port;
  BusTimeline timeline{controller, port, kStart_ns};
};

TEST_F(BusTimelineTest, BeginsWithTheNextMillisecondAndMarksEachOne) {
  timeline.advance_to(kStart_ns + 100'000);
  EXPECT_TRUE(port.flushed.empty());
  timeline.advance_to(kStart_ns + 3 * kMillisecond_ns);
  const std::int64_t first_ns = kStart_ns + 500'000;
  EXPECT_EQ(port.flushed,
            (std::vector{first_ns, first_ns + kMillisecond_ns, first_ns + 2 * kMillisecond_ns}));
  EXPECT_EQ(timeline.next_ns(), first_ns + 3 * kMillisecond_ns);
}

TEST_F(BusTimelineTest, ALateWakeUpSendsEachSyncWithTheTimeOfItsSlot) {
  timeline.advance_to(kStart_ns + 35 * kMillisecond_ns);
  const std::int64_t first_ns = kStart_ns + 500'000;
  EXPECT_EQ(port.syncs(),
            (std::vector{first_ns, first_ns + kSlot_ns, first_ns + 2 * kSlot_ns, first_ns + 3 * kSlot_ns}));
  EXPECT_EQ(timeline.missed(), 34U);
  EXPECT_EQ(timeline.stale(), 0U);
}

TEST_F(BusTimelineTest, WhatIsTooOldForTheBusIsDroppedAndCounted) {
  const std::int64_t now_ns = kStart_ns + 500'000 + 20 * kSlot_ns;
  timeline.advance_to(now_ns);
  ASSERT_FALSE(port.syncs().empty());
  EXPECT_GE(port.syncs().front(), now_ns - can::kLongestWait_ns);
  EXPECT_EQ(port.syncs().size(), 6U);  // 50 ms ago, and since then
  EXPECT_GE(controller.health().flushed, 15U);
  EXPECT_EQ(controller.state().cycle, 1002U) << "it knows the time all the same";
}

// A frame cannot be put onto a real bus with a time of its own.
TEST_F(BusTimelineTest, ABusThatWaitsForNobodyGetsNoSyncOfASlotThatIsOver) {
  port.longest_ns = 0;
  const std::int64_t now_ns = kStart_ns + 500'000 + 3 * kSlot_ns + 4 * kMillisecond_ns;
  timeline.advance_to(now_ns);
  EXPECT_EQ(port.syncs(), std::vector{kStart_ns + 500'000 + 3 * kSlot_ns});
  EXPECT_EQ(timeline.absences(), 0U);
  EXPECT_GE(timeline.stale(), 3U);
}

// As a process that was stopped (SIGSTOP) for five seconds and goes on.
TEST_F(BusTimelineTest, WhoWasAwayBeginsAnewWithTheSlotThatIsNow) {
  port.longest_ns = 0;
  const std::int64_t first_ns = kStart_ns + 500'000;
  timeline.advance_to(first_ns + 20 * kMillisecond_ns);
  port.sent.clear();
  port.flushed.clear();
  const std::int64_t now_ns = first_ns + 5 * facts::kSecond_ns + 3 * kMillisecond_ns;
  timeline.advance_to(now_ns);
  EXPECT_EQ(port.syncs(), std::vector{first_ns + 5 * facts::kSecond_ns}) << "nothing of before";
  EXPECT_LE(port.sent.size(), 3U);
  EXPECT_LE(port.flushed.size(), 12U) << "the bus hears of the last milliseconds alone";
  EXPECT_EQ(controller.state().cycle, static_cast<std::uint32_t>(now_ns / facts::kCycle_ns));
  EXPECT_EQ(controller.state().slot, static_cast<std::uint32_t>(now_ns / kSlot_ns % 8));
  EXPECT_EQ(controller.health().bus_offs, 1U) << "for the joints it was as if it had been off the bus";
  EXPECT_EQ(controller.health().bus_state, static_cast<std::uint32_t>(can::BusState::error_active));
  EXPECT_EQ(timeline.next_ns(), first_ns + 5 * facts::kSecond_ns + 4 * kMillisecond_ns);
  EXPECT_EQ(timeline.absences(), 1U);
}

// What waited in the mailbox meanwhile is judged by the clock, not by what the controller has just lived
// through.
TEST_F(BusTimelineTest, ABatchOfBeforeAnAbsenceIsLate) {
  msgclient::Client main = block.local_client("main_controller");
  msgclient::EmiHost host{main};
  const std::int64_t first_ns = kStart_ns + 500'000;
  timeline.advance_to(first_ns + 20 * kMillisecond_ns);
  msgclient::HandOver batch{};
  batch.sequence = 1001;
  batch.joint_count = static_cast<std::uint32_t>(robot.joints.size());
  batch.point_count = kBatchPoints;
  for (int point = 0; point < kBatchPoints; ++point) {
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      batch.position[static_cast<std::size_t>(point) * robot.joints.size() + joint] =
          static_cast<float>(robot.joints[joint].home_rad);
    }
  }
  ASSERT_TRUE(host.post(batch, first_ns + 30 * kMillisecond_ns));
  timeline.advance_to(first_ns + 2 * facts::kSecond_ns);
  EXPECT_EQ(controller.state().handed_over, 1U);
  EXPECT_EQ(controller.state().late, 1U);
  EXPECT_EQ(controller.state().accepted_sequence, 0U);
  EXPECT_EQ(controller.mode(), Mode::holding);
}

// A computer may sleep, too.
TEST_F(BusTimelineTest, AnHourIsCaughtUpWithAsQuicklyAsASecond) {
  timeline.advance_to(kStart_ns + kMillisecond_ns);
  const std::int64_t now_ns = kStart_ns + 3600 * facts::kSecond_ns;
  const std::uint64_t published_before = controller.health().flushed;
  timeline.advance_to(now_ns);
  EXPECT_EQ(controller.state().cycle, static_cast<std::uint32_t>(now_ns / facts::kCycle_ns));
  EXPECT_LT(controller.health().flushed - published_before, 1000U) << "slots that it lived through";
  EXPECT_EQ(timeline.next_ns(), (now_ns / kMillisecond_ns + 1) * kMillisecond_ns);
}

TEST_F(BusTimelineTest, AFrameComesBeforeTheMillisecondsThatFollowIt) {
  timeline.advance_to(kStart_ns + kMillisecond_ns);
  answer(kStart_ns + 500'000);
  answer(kStart_ns + 500'000 + kSlot_ns);
  timeline.advance_to(kStart_ns + 500'000 +
                      2 * kSlot_ns);  // wakes two slots later, with both slots' feedback
  JointStates states{};
  ASSERT_TRUE(client.read<JointStates>("joint_states").read(states));
  EXPECT_EQ(states.missing, 0U) << "each feedback fell into its own slot";
  EXPECT_EQ(controller.state().resynchronised, 0U);
}

TEST_F(BusTimelineTest, WaitsABoundedTimeForABusThatLags) {
  const std::int64_t first_ns = kStart_ns + 500'000;
  port.bus_time_ns = first_ns + 2 * kMillisecond_ns;
  timeline.advance_to(first_ns + 10 * kMillisecond_ns);
  EXPECT_TRUE(timeline.waits());
  EXPECT_EQ(timeline.next_ns(), first_ns + 4 * kMillisecond_ns) << "a millisecond beyond the bus";
  port.bus_time_ns = first_ns + 10 * kMillisecond_ns;
  timeline.advance_to(first_ns + 10 * kMillisecond_ns);
  EXPECT_FALSE(timeline.waits());
  EXPECT_EQ(timeline.next_ns(), first_ns + 11 * kMillisecond_ns);
  const std::int64_t now_ns = first_ns + 100 * kMillisecond_ns;
  timeline.advance_to(now_ns);
  EXPECT_EQ(timeline.next_ns(), now_ns - can::kLongestWait_ns + kMillisecond_ns) << "then it goes on without";
}

TEST_F(BusTimelineTest, WhatTheBusDoesNotTakeYetStaysInOrder) {
  port.occupied = true;
  timeline.advance_to(kStart_ns + kMillisecond_ns);
  EXPECT_TRUE(port.sent.empty());
  port.occupied = false;
  timeline.advance_to(kStart_ns + kMillisecond_ns + 300'000);
  ASSERT_EQ(port.sent.size(), 2U);  // SYNC and heartbeat
  EXPECT_LT(port.sent[0].frame.id, port.sent[1].frame.id);
  EXPECT_EQ(port.sent[0].at_ns, kStart_ns + kMillisecond_ns + 300'000);
}

TEST_F(BusTimelineTest, APortWithOneBufferGetsOneFrameAfterTheOtherWithinTheMillisecond) {
  port.buffers = 1;
  timeline.advance_to(kStart_ns + kMillisecond_ns);
  ASSERT_EQ(port.sent.size(), 2U);  // SYNC and heartbeat
  EXPECT_LT(port.sent[0].frame.id, port.sent[1].frame.id);
  EXPECT_EQ(port.sent[1].at_ns, port.sent[0].at_ns);
}

// A frame that is in the kernel's hands loses arbitration to all feedback, and everything more urgent that
// comes meanwhile waits behind it.
TEST_F(BusTimelineTest, APortThatTakesNothingBackGetsLessUrgentFramesOnlyOnAQuietBus) {
  port.revocable = false;
  const std::int64_t first_ns = kStart_ns + 500'000;
  timeline.advance_to(first_ns);
  EXPECT_EQ(port.times_of(can::MessageKind::sync), std::vector{first_ns});
  EXPECT_TRUE(port.times_of(can::MessageKind::heartbeat).empty()) << "feedback is on its way";
  answer(first_ns);  // ends a few microseconds after the second millisecond
  timeline.advance_to(first_ns + 2 * kMillisecond_ns + 100'000);
  EXPECT_TRUE(port.times_of(can::MessageKind::heartbeat).empty())
      << "someone may still have something to say";
  timeline.advance_to(first_ns + 3 * kMillisecond_ns);
  EXPECT_EQ(port.times_of(can::MessageKind::heartbeat), std::vector{first_ns + 3 * kMillisecond_ns});
}

TEST_F(BusTimelineTest, FramesDoNotWaitForFeedbackThatWillNotCome) {
  port.revocable = false;
  const std::int64_t first_ns = kStart_ns + 500'000;
  timeline.advance_to(first_ns + 6 * kMillisecond_ns);
  EXPECT_TRUE(port.times_of(can::MessageKind::heartbeat).empty());
  timeline.advance_to(first_ns + 7 * kMillisecond_ns);
  EXPECT_EQ(port.times_of(can::MessageKind::heartbeat), std::vector{first_ns + 7 * kMillisecond_ns})
      << "after feedback's deadline";
}

TEST_F(BusTimelineTest, AJointThatIsMissingIsNotWaitedFor) {
  port.revocable = false;
  const std::int64_t first_ns = kStart_ns + 500'000;
  timeline.advance_to(first_ns);
  std::int64_t slot_ns = first_ns;
  for (int slot = 0; slot < 9; ++slot, slot_ns += kSlot_ns) {
    answer(slot_ns);
    port.arriving.pop_back();  // of the last joint
    timeline.advance_to(slot_ns + kSlot_ns);
  }
  const auto beats = port.times_of(can::MessageKind::heartbeat);
  ASSERT_EQ(beats.size(), 2U);
  EXPECT_EQ(beats.front(), first_ns + 7 * kMillisecond_ns) << "not known to be missing yet";
  EXPECT_EQ(beats.back(), first_ns + 8 * kSlot_ns + 3 * kMillisecond_ns);
}

TEST_F(BusTimelineTest, NoticesBelongToTheirOwnSlotHoweverLateTheProcessWakes) {
  const std::int64_t edge_ns =
      (kStart_ns / kSlot_ns / kSlotsBetweenRecords + 1) * kSlotsBetweenRecords * kSlot_ns;
  const can::Frame trim = can::encode(can::kFullProfile, can::Trim{});
  for (const std::int64_t end_ns : {edge_ns - 200'000, edge_ns + 200'000, edge_ns + kSlot_ns + 200'000}) {
    port.notices.push_back({can::BusNotice::Kind::sent, {trim, end_ns - 100'000, end_ns}});
  }
  port.notices.insert(port.notices.begin() + 2,
                      {can::BusNotice::Kind::error, {{}, edge_ns + 300'000, edge_ns + 300'000}});
  timeline.advance_to(edge_ns + kSlot_ns + 5 * kMillisecond_ns);
  BusSlot slot;
  ASSERT_TRUE(client.read<BusSlot>("bus_slot").read(slot));
  EXPECT_EQ(slot.stamp_ns, edge_ns);
  ASSERT_EQ(slot.frame_count, 2U);
  EXPECT_EQ(slot.id[0], trim.id);
  EXPECT_EQ(slot.end_us[0], 200);
  EXPECT_EQ(slot.id[1], kErrorOnTheBus);
  EXPECT_EQ(slot.end_us[1], 300);
}

TEST_F(BusTimelineTest, TheControllerLearnsThatItsStationIsOffTheBusAndBackOnIt) {
  timeline.advance_to(kStart_ns + kMillisecond_ns);
  const std::size_t before = port.sent.size();
  port.bus_state = can::BusState::bus_off;
  port.occupied = true;
  timeline.advance_to(kStart_ns + 15 * kMillisecond_ns);
  EXPECT_EQ(controller.health().bus_state, static_cast<std::uint32_t>(can::BusState::bus_off));
  EXPECT_TRUE(controller.queue().empty()) << "it would be stale afterwards";
  port.bus_state = can::BusState::error_active;
  port.occupied = false;
  timeline.advance_to(kStart_ns + 25 * kMillisecond_ns);
  EXPECT_EQ(controller.health().bus_state, static_cast<std::uint32_t>(can::BusState::error_active));
  ASSERT_GT(port.sent.size(), before);
  EXPECT_GT(port.sent[before].at_ns, kStart_ns + 15 * kMillisecond_ns);
}

}  // namespace
}  // namespace gaitway::msgcontroller
