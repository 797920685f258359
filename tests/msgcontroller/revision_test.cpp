// Revisions of the batch that runs, from slot 4 on: on time on every joint, refused when they come too late
// or to nothing, repaired like batches, with a tail of their own.
#include "message_controller_fixture.hpp"

namespace gaitway::msgcontroller {
namespace {

constexpr int kFrom = 4;

class Revisions : public MessageControllerTest {
 protected:
  Revisions() : MessageControllerTest("full", kFrom) {}

  // The batch, but from slot 4 on two counts a point; the tail goes on from there as the batch's does.
  msgclient::HandOver revised(std::uint32_t sequence, int tail = 20) {
    msgclient::HandOver hand_over = batch(sequence, tail);
    hand_over.first_slot = kFrom;
    for (int point = kFrom; point < kBatchPoints + tail; ++point) {
      const int more = std::min(point, kBatchPoints - 1) - kFrom + 1;
      for (int joint = 0; joint < static_cast<int>(robot_.joints.size()); ++joint) {
        const double count_rad = robot_.joints[static_cast<std::size_t>(joint)].count_rad;
        const double angle = static_cast<double>(hand_over.position_at(point, joint)) + more * count_rad;
        hand_over.set_position(point, joint, static_cast<float>(angle));
      }
    }
    return hand_over;
  }
  // At 24 ms in its cycle, 16 ms before it begins.
  msgclient::Answer revise(std::uint32_t sequence, std::int64_t in_cycle_ns = 24 * kMillisecond_ns,
                           std::uint32_t first_slot = kFrom) {
    run_until(std::int64_t{sequence} * kCycle_ns + in_cycle_ns);
    auto mail = std::make_unique<msgclient::HandOver>(revised(sequence));
    mail->first_slot = first_slot;
    EXPECT_TRUE(adapter_.host().post(*mail, now_ns_));
    run_until(now_ns_ + 3 * kMillisecond_ns);
    const auto answer = adapter_.host().take_answer(now_ns_);
    EXPECT_TRUE(answer.has_value());
    return answer.value_or(msgclient::Answer{.verdict = Verdict::corrupt});
  }
  void run_into_slot(std::uint32_t sequence, int slot) {
    run_until(std::int64_t{sequence} * kCycle_ns + slot * kSlot_ns + 5 * kMillisecond_ns);
  }
  void expect_nothing_repaired() {
    EXPECT_EQ(controller_.state().repaired, 0U);
    EXPECT_EQ(controller_.state().resynchronised, 0U);
    EXPECT_EQ(controller_.health().counts_differed, 0U);
  }
  static bool is_trajectory_to(const can::Frame& frame, can::NodeId node) {
    const auto trajectory = can::decode_trajectory(can::kFullProfile, frame);
    return trajectory && trajectory->node == node;
  }
};

TEST_F(Revisions, EveryJointGoesOnByTheRevisionFromItsSlotOn) {
  hand_over(2);
  EXPECT_EQ(revise(2).verdict, Verdict::accepted);
  run_into_slot(2, 3);
  expect_moved(4);
  run_into_slot(2, 4);
  expect_moved(6);
  run_into_slot(2, 6);
  expect_moved(10);
  expect_nothing_repaired();
  EXPECT_EQ(bus_.sent[can::MessageKind::trajectory], 2 * static_cast<int>(robot_.joints.size()));
}

TEST_F(Revisions, TheNextBatchGoesOnFromWhatWasRevised) {
  hand_over(2);
  revise(2);
  first_sequence_ = 2;
  run_until(3 * kCycle_ns - 16 * kMillisecond_ns);
  auto next = std::make_unique<msgclient::HandOver>(batch(3));
  for (int point = 0; point < static_cast<int>(next->point_count); ++point) {
    for (int joint = 0; joint < static_cast<int>(robot_.joints.size()); ++joint) {
      const double count_rad = robot_.joints[static_cast<std::size_t>(joint)].count_rad;
      next->set_position(
          point, joint,
          static_cast<float>(static_cast<double>(next->position_at(point, joint)) + 4 * count_rad));
    }
  }
  ASSERT_TRUE(adapter_.host().post(*next, now_ns_));
  run_into_slot(3, 0);
  expect_moved(13);
  expect_nothing_repaired();
}

TEST_F(Revisions, ItsTailReplacesTheBatchs) {
  hand_over(2);
  revise(2);
  run_until(7 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  expect_moved(12 + 10);
  expect_nothing_repaired();
}

TEST_F(Revisions, ALostFrameIsSentAgainBeforeItBegins) {
  hand_over(2);
  int lost = 0;
  bus_.drop = [&](const can::Frame& frame) { return is_trajectory_to(frame, 5) && lost++ == 0; };
  revise(2);
  run_into_slot(2, 4);
  expect_moved(6);
  EXPECT_EQ(controller_.state().repaired, 1U);
  EXPECT_EQ(controller_.state().resynchronised, 0U);
}

TEST_F(Revisions, AJointThatNeverGotItPlaysTheBatchAndIsBackTwoSlotsLater) {
  hand_over(2);
  bus_.drop = [](const can::Frame& frame) { return is_trajectory_to(frame, 5); };
  revise(2);
  run_into_slot(2, 4);
  EXPECT_EQ(bus_.count(4) - JointsOnABus::home_count(robot_.joints[4]), 5) << "it does not stand still";
  run_into_slot(2, 5);
  expect_moved(8);
  bus_.drop = [](const can::Frame&) { return false; };
  run_into_slot(2, 7);
  expect_moved(12);
  EXPECT_EQ(controller_.state().resynchronised, 1U);
}

TEST_F(Revisions, ComesTooLateToBeSentInTime) {
  hand_over(2);
  const msgclient::Answer answer = revise(2, kFrom * kSlot_ns - 5 * kMillisecond_ns);
  EXPECT_EQ(answer.verdict, Verdict::late);
  EXPECT_EQ(answer.reason, msgclient::Reason::too_late);
  run_into_slot(2, 7);
  expect_moved(8);
}

TEST_F(Revisions, NeedsABatchThatRuns) {
  run_until(kCycle_ns);
  EXPECT_EQ(revise(1).reason, msgclient::Reason::nothing_to_revise) << "the robot holds";
  hand_over(2);
  EXPECT_EQ(revise(2).verdict, Verdict::accepted);
  run_until(3 * kCycle_ns);
  EXPECT_EQ(revise(3).reason, msgclient::Reason::nothing_to_revise) << "a tail plays";
  expect_nothing_repaired();
}

TEST_F(Revisions, BeginsWhereTheNetworkHasIt) {
  hand_over(2);
  EXPECT_EQ(revise(2, 24 * kMillisecond_ns, 5).reason, msgclient::Reason::nothing_to_revise);
}

TEST_F(Revisions, ThatJumpIsRefusedAndTheJointNamed) {
  hand_over(2);
  run_until(2 * kCycle_ns + 24 * kMillisecond_ns);
  auto mail = std::make_unique<msgclient::HandOver>(revised(2));
  mail->set_position(0, 7, mail->position_at(0, 7) + 0.5F);  // was played, and counts no more
  mail->set_position(kFrom, 7, mail->position_at(kFrom, 7) + 0.5F);
  ASSERT_TRUE(adapter_.host().post(*mail, now_ns_));
  run_until(now_ns_ + 3 * kMillisecond_ns);
  const auto answer = adapter_.host().take_answer(now_ns_);
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->reason, msgclient::Reason::jump);
  EXPECT_EQ(answer->joint, 7);
  EXPECT_EQ(answer->point, kFrom);
}

TEST_F(Revisions, AStopWhileOneIsOnItsWayEndsInItsTail) {
  hand_over(2);
  revise(2);
  command(msgclient::UserCommandKind::stop);
  run_until(7 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  expect_moved(12 + 10);
  expect_nothing_repaired();
}

TEST_F(Revisions, NoJointStaysOnACountThatIsNotKnownWhateverIsLost) {
  lose_some_of_the_motion();
  for (std::uint32_t sequence = 2; sequence < 40; ++sequence) {
    ASSERT_EQ(hand_over(sequence).verdict, Verdict::accepted) << sequence;
    // Back to where the next batch begins: the same points again are a revision, too.
    run_until(std::int64_t{sequence} * kCycle_ns + 24 * kMillisecond_ns);
    auto same = std::make_unique<msgclient::HandOver>(batch(sequence));
    same->first_slot = kFrom;
    for (int joint = 0; joint < static_cast<int>(robot_.joints.size()); ++joint) {
      same->set_position(5, joint, same->position_at(4, joint));
    }
    ASSERT_TRUE(adapter_.host().post(*same, now_ns_));
    run_until(now_ns_ + 3 * kMillisecond_ns);
    const auto answer = adapter_.host().take_answer(now_ns_);
    ASSERT_TRUE(answer.has_value());
    ASSERT_EQ(answer->verdict, Verdict::accepted) << sequence;
  }
  bus_.drop = [](const can::Frame&) { return false; };
  hand_over(40);
  hand_over(41);
  run_until(41 * kCycle_ns + 7 * kSlot_ns + 2 * kMillisecond_ns);
  expect_moved(320);
  EXPECT_GT(controller_.state().resynchronised, 0U);
}

TEST_F(MessageControllerTest, RevisesNothingUnlessTheNetworkFileSaysSo) {
  hand_over(2);
  run_until(2 * kCycle_ns + 24 * kMillisecond_ns);
  auto mail = std::make_unique<msgclient::HandOver>(batch(2));
  mail->first_slot = 4;
  ASSERT_TRUE(adapter_.host().post(*mail, now_ns_));
  run_until(now_ns_ + 3 * kMillisecond_ns);
  const auto answer = adapter_.host().take_answer(now_ns_);
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->reason, msgclient::Reason::nothing_to_revise);
}

}  // namespace
}  // namespace gaitway::msgcontroller
