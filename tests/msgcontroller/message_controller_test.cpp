// The message controller against a small bus of joints that answer: schedule, repair, resynchronisation, safe
// tail.
#include "message_controller_fixture.hpp"

#include <limits>

namespace gaitway::msgcontroller {
namespace {

TEST_F(MessageControllerTest, HoldsAndSendsSyncEverySlotUntilABatchComes) {
  run_until(2 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  EXPECT_EQ(bus_.sent[can::MessageKind::sync], 16);
  EXPECT_EQ(bus_.sent[can::MessageKind::trajectory], 0);
  expect_moved(0);
}

TEST_F(MessageControllerTest, ABatchMovesEveryJointByItsCounts) {
  EXPECT_EQ(hand_over(2).verdict, Verdict::accepted);
  EXPECT_EQ(bus_.sent[can::MessageKind::trajectory], static_cast<int>(robot_.joints.size()));
  run_until(2 * kCycle_ns + 3 * kSlot_ns + 5 * kMillisecond_ns);
  expect_moved(4);
  EXPECT_EQ(controller_.mode(), Mode::batches);
}

TEST_F(MessageControllerTest, ConsecutiveBatchesJoinWithoutAJump) {
  for (std::uint32_t sequence = 2; sequence < 8; ++sequence) {
    ASSERT_EQ(hand_over(sequence).verdict, Verdict::accepted) << sequence;
  }
  run_until(7 * kCycle_ns + 7 * kSlot_ns + 2 * kMillisecond_ns);
  expect_moved(48);
  EXPECT_EQ(controller_.state().tail_played, 0U);
  EXPECT_EQ(controller_.state().resynchronised, 0U);
}

TEST_F(MessageControllerTest, WithoutANewBatchTheSafeTailPlaysToItsEndAndTheJointsHold) {
  hand_over(2, 20);
  run_until(3 * kCycle_ns + kSlot_ns);
  EXPECT_EQ(controller_.mode(), Mode::safe_tail);
  run_until(7 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  EXPECT_EQ(controller_.state().tail_played, 3U);
  expect_moved(8 + 10);
}

TEST_F(MessageControllerTest, ALostTrajectoryFrameIsSentAgainBeforeTheBatchStarts) {
  int lost = 0;
  bus_.drop = [&](const can::Frame& frame) {
    const auto trajectory = can::decode_trajectory(can::kFullProfile, frame);
    return trajectory && trajectory->node == 5 && lost++ == 0;
  };
  hand_over(2);
  run_until(2 * kCycle_ns + 7 * kSlot_ns + 5 * kMillisecond_ns);
  EXPECT_EQ(controller_.state().repaired, 1U);
  EXPECT_EQ(controller_.state().resynchronised, 0U);
  expect_moved(8);
}

TEST_F(MessageControllerTest, AJointThatNeverGotItsFrameIsBackWithinOneSlotOfItsFirstFeedback) {
  bus_.drop = [](const can::Frame& frame) {
    const auto trajectory = can::decode_trajectory(can::kFullProfile, frame);
    return trajectory && trajectory->node == 5;
  };
  hand_over(2);
  run_until(2 * kCycle_ns + 1 * kSlot_ns + 5 * kMillisecond_ns);
  expect_moved(2);
  run_until(2 * kCycle_ns + 7 * kSlot_ns + 5 * kMillisecond_ns);
  expect_moved(8);
  EXPECT_EQ(controller_.state().resynchronised, 2U) << "one frame has no room for all eight points";
  EXPECT_EQ(controller_.health().trajectories_lost, 2U) << "the frame and its repetition";
}

TEST_F(MessageControllerTest, NoJointStaysOnACountThatIsNotKnownWhateverIsLost) {
  lose_some_of_the_motion();
  for (std::uint32_t sequence = 2; sequence < 40; ++sequence) {
    ASSERT_EQ(hand_over(sequence).verdict, Verdict::accepted) << sequence;
  }
  bus_.drop = [](const can::Frame&) { return false; };
  hand_over(40);
  hand_over(41);
  run_until(41 * kCycle_ns + 7 * kSlot_ns + 2 * kMillisecond_ns);
  expect_moved(320);
  EXPECT_GT(controller_.state().resynchronised, 0U);
}

TEST_F(MessageControllerTest, RefusesALateBatchAndSaysSo) {
  hand_over(2);
  run_until(3 * kCycle_ns - 5 * kMillisecond_ns);
  const auto mail = std::make_unique<msgclient::HandOver>(batch(3));
  adapter_.host().post(*mail, now_ns_);
  run_until(now_ns_ + 2 * kMillisecond_ns);
  const auto answer = adapter_.host().take_answer(now_ns_);
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->verdict, Verdict::late);
  EXPECT_EQ(controller_.state().late, 1U);
}

TEST_F(MessageControllerTest, RefusesABatchThatJumpsAndNamesTheJoint) {
  run_until(2 * kCycle_ns - 16 * kMillisecond_ns);
  auto mail = std::make_unique<msgclient::HandOver>(batch(2));
  mail->set_position(0, 7, mail->position_at(0, 7) + 0.5F);
  adapter_.host().post(*mail, now_ns_);
  run_until(now_ns_ + 2 * kMillisecond_ns);
  const auto answer = adapter_.host().take_answer(now_ns_);
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->verdict, Verdict::refused);
  EXPECT_EQ(answer->reason, msgclient::Reason::jump);
  EXPECT_EQ(answer->joint, 7);
  run_until(3 * kCycle_ns);
  expect_moved(0);
}

TEST_F(MessageControllerTest, ADamagedHandOverIsRefusedAndTheTailPlays) {
  hand_over(2);
  adapter_.host().faults().flip_next = msgclient::EmiFaults::Flip{msgclient::MailKind::hand_over, 100, 0x10};
  EXPECT_EQ(hand_over(3).verdict, Verdict::corrupt);
  run_until(3 * kCycle_ns + kSlot_ns);
  EXPECT_EQ(controller_.mode(), Mode::safe_tail);
}

TEST_F(MessageControllerTest, AStopPlaysTheTailAndRefusesBatchesUntilTheRobotStands) {
  hand_over(2);
  const msgclient::UserCommandMail stop{.sequence = 1, .kind = msgclient::UserCommandKind::stop};
  adapter_.host().post(stop, now_ns_);
  run_until(now_ns_ + 2 * kMillisecond_ns);
  adapter_.host().take_answer(now_ns_);
  EXPECT_EQ(hand_over(3).reason, msgclient::Reason::stopping);
  run_until(7 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  first_sequence_ = 8;
  expect_moved(18);
}

TEST_F(MessageControllerTest, EmergencyStopReachesTheBusAtOnceAndEndsBatches) {
  hand_over(2);
  run_until(2 * kCycle_ns + 2 * kSlot_ns);
  const msgclient::UserCommandMail stop{.sequence = 1,
                                        .kind = msgclient::UserCommandKind::emergency_stop_hold};
  adapter_.host().post(stop, now_ns_);
  run_until(now_ns_ + 2 * kMillisecond_ns);
  EXPECT_EQ(adapter_.host().take_answer(now_ns_)->verdict, Verdict::accepted);
  EXPECT_EQ(bus_.sent[can::MessageKind::emergency_stop], 1);
  EXPECT_EQ(controller_.mode(), Mode::emergency_stop);
  const std::int32_t there = bus_.count(0);
  run_until(6 * kCycle_ns);
  EXPECT_EQ(bus_.count(0), there);
  EXPECT_EQ(hand_over(7).reason, msgclient::Reason::emergency_stopped);
}

TEST_F(MessageControllerTest, AManualJointCommandMovesOneJointWhileStanding) {
  run_until(kCycle_ns);
  const double target = robot_.joints[3].home_rad + 20 * robot_.joints[3].count_rad;
  const msgclient::UserCommandMail move{.sequence = 1,
                                        .kind = msgclient::UserCommandKind::manual_joint,
                                        .joint = 3,
                                        .position = static_cast<float>(target),
                                        .duration_slots = 10};
  adapter_.host().post(move, now_ns_);
  run_until(3 * kCycle_ns);
  EXPECT_EQ(adapter_.host().take_answer(now_ns_)->verdict, Verdict::accepted);
  EXPECT_EQ(bus_.count(3) - JointsOnABus::home_count(robot_.joints[3]), 20);
  EXPECT_EQ(bus_.count(4), JointsOnABus::home_count(robot_.joints[4]));
  EXPECT_EQ(controller_.state().resynchronised, 0U) << "the joint's own movement is no error";
}

TEST_F(MessageControllerTest, UserCommandsKeepTheirPeriod) {
  run_until(kCycle_ns);
  std::vector<Verdict> verdicts;
  for (std::uint32_t sequence = 1; sequence <= 20; ++sequence) {  // one every two milliseconds
    const msgclient::UserCommandMail move{
        .sequence = sequence,
        .kind = msgclient::UserCommandKind::manual_joint,
        .joint = sequence % 22,
        .position = static_cast<float>(robot_.joints[sequence % 22].home_rad),
        .duration_slots = 1};
    ASSERT_TRUE(adapter_.host().post(move, now_ns_));
    run_until(now_ns_ + 2 * kMillisecond_ns);
    while (const auto answer = adapter_.host().take_answer(now_ns_)) {
      verdicts.push_back(answer->verdict);
    }
  }
  EXPECT_EQ(verdicts.size(), 20U) << "each is answered";
  EXPECT_EQ(std::count(verdicts.begin(), verdicts.end(), Verdict::accepted), 4);
  EXPECT_EQ(bus_.sent[can::MessageKind::user_command], 4);
}

TEST_F(MessageControllerTest, RefusesABatchThatWouldBeginDuringAManualMovement) {
  run_until(kCycle_ns);
  const msgclient::UserCommandMail move{.sequence = 1,
                                        .kind = msgclient::UserCommandKind::manual_joint,
                                        .joint = 3,
                                        .position = static_cast<float>(robot_.joints[3].home_rad),
                                        .duration_slots = 30};
  adapter_.host().post(move, now_ns_);
  run_until(now_ns_ + 2 * kMillisecond_ns);
  adapter_.host().take_answer(now_ns_);
  EXPECT_EQ(hand_over(2).reason, msgclient::Reason::moving_by_hand);
  first_sequence_ = 6;
  EXPECT_EQ(hand_over(6).verdict, Verdict::accepted) << "the joint has arrived by then";
}

TEST_F(MessageControllerTest, WritesTrimsOfItsOwnWhenTheMainControllerIsSilent) {
  run_until(2 * kCycle_ns - 16 * kMillisecond_ns);
  auto mail = std::make_unique<msgclient::HandOver>(batch(2));
  mail->trim.channel_count = 8;
  mail->trim.gain[2][0][0] = 0.25F;
  adapter_.host().post(*mail, now_ns_);
  run_until(4 * kCycle_ns);
  EXPECT_GE(bus_.sent[can::MessageKind::trim], 16);
}

TEST_F(MessageControllerTest, EverySyncSaysHowSoftTheJointsAre) {
  std::vector<int> softness;
  bus_.drop = [&](const can::Frame& frame) {
    if (const auto sync = can::decode_sync(controller_.profile(), frame)) softness.push_back(sync->softness);
    return false;
  };
  const auto heard_after = [&](float asked) {
    adapter_.host().post(msgclient::TrimUpdate{.channel_count = 8, .softness = asked}, now_ns_);
    softness.clear();
    run_until(now_ns_ + 3 * kSlot_ns);
    return softness.empty() ? -1 : softness.back();
  };
  run_until(kCycle_ns);
  EXPECT_EQ(heard_after(0.0F), 0);
  EXPECT_EQ(heard_after(1.0F), can::kMostSoftness);
  EXPECT_EQ(heard_after(std::numeric_limits<float>::quiet_NaN()), can::kMostSoftness)
      << "as if nothing had come";
  run_until(now_ns_ + kCycle_ns);
  EXPECT_EQ(softness.back(), can::kMostSoftness) << "a main controller that falls silent leaves them soft";
  EXPECT_EQ(heard_after(-3.0F), 0);
  EXPECT_EQ(heard_after(7.0F), can::kMostSoftness);
  EXPECT_EQ(heard_after(0.43F), 3);
}

}  // namespace
}  // namespace gaitway::msgcontroller
