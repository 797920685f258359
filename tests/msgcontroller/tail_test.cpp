// The points that the joints get for the time after their batch: when they are sent, when they may be used,
// and what the message controller makes of it when the joints had to use them.
#include "message_controller_fixture.hpp"

namespace gaitway::msgcontroller {
namespace {

constexpr int kTailSent = 11;  // points until both feet are down
constexpr std::uint8_t kBothFeet = 2;

class TailTest : public MessageControllerTest {
 protected:
  void SetUp() override { run_until(2 * kSlot_ns); }

  // As batch(), on one foot until `single` points of the tail have been played.
  msgclient::Answer hand_over_on_one_foot(std::uint32_t sequence, int single = kTailSent) {
    run_until(std::int64_t{sequence} * kCycle_ns - 16 * kMillisecond_ns);
    const auto mail = std::make_unique<msgclient::HandOver>(batch(sequence));
    for (std::uint32_t point = 0; point < mail->point_count; ++point) {
      mail->support[point] = static_cast<int>(point) < kBatchPoints + single - 1 ? 0 : kBothFeet;
    }
    EXPECT_TRUE(adapter_.host().post(*mail, now_ns_));
    run_until(now_ns_ + 3 * kMillisecond_ns);
    const auto answer = adapter_.host().take_answer(now_ns_);
    EXPECT_TRUE(answer.has_value());
    return answer.value_or(msgclient::Answer{.verdict = Verdict::corrupt});
  }
  // The message controller does nothing and hears nothing.
  void silent_until(std::int64_t time_ns) {
    for (; now_ns_ < time_ns; now_ns_ += kMillisecond_ns) {
      for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
        bus_.joint(joint).step(now_ns_, bus_.sensors[joint]);
        can::Frame frame;
        while (bus_.joint(joint).take_frame(frame)) {
        }
      }
    }
  }
  static std::int64_t start_ns(std::uint32_t sequence) { return std::int64_t{sequence} * kCycle_ns; }
  static std::int32_t moved_after(int tail_points) { return 8 + tail_points / 2; }
};

TEST_F(TailTest, TheJointsHoldItBeforeTheBatchStartsAndSyncNamesIt) {
  ASSERT_EQ(hand_over_on_one_foot(2).verdict, Verdict::accepted);
  run_until(start_ns(2) + kMillisecond_ns);
  EXPECT_EQ(controller_.state().tail_points, static_cast<std::uint32_t>(kTailSent));
  EXPECT_EQ(bus_.sent[can::MessageKind::tail], 2 * static_cast<int>(bus_.size()))
      << "two parts of each joint";
}

TEST_F(TailTest, JointsWhoseMessageControllerIsGoneEndTheStepAndHold) {
  ASSERT_EQ(hand_over_on_one_foot(2).verdict, Verdict::accepted);
  run_until(start_ns(2) + 3 * kSlot_ns);
  silent_until(start_ns(2) + 8 * kSlot_ns + 30 * kSlot_ns);
  expect_moved(moved_after(kTailSent));
}

TEST_F(TailTest, NoneIsSentWhereBothFeetAreDownAtTheBatchsEnd) {
  ASSERT_EQ(hand_over_on_one_foot(2, -8).verdict, Verdict::accepted);
  run_until(start_ns(2) + kMillisecond_ns);
  EXPECT_EQ(bus_.sent[can::MessageKind::tail], 0);
  EXPECT_EQ(controller_.state().tail_points, 0U);
}

TEST_F(TailTest, NoneIsSentThatWouldEndOnOneFoot) {
  ASSERT_EQ(hand_over_on_one_foot(2, 100).verdict, Verdict::accepted);
  run_until(start_ns(2) + kMillisecond_ns);
  EXPECT_EQ(bus_.sent[can::MessageKind::tail], 0);
}

// A part of the robbed joint's tail is lost once.
TEST_F(TailTest, AJointThatLacksAPartGetsItAgainAndTheTailIsUsed) {
  constexpr can::NodeId kRobbed = 7;
  int lost = 0;
  bus_.drop = [&](const can::Frame& frame) {
    const auto is = controller_.profile().identify(frame.id);
    return is->kind == can::MessageKind::tail && is->node == kRobbed && is->part == 1 && lost++ == 0;
  };
  ASSERT_EQ(hand_over_on_one_foot(2).verdict, Verdict::accepted);
  run_until(start_ns(2) + 2 * kSlot_ns + kMillisecond_ns);
  EXPECT_EQ(lost, 2) << "lost once, and sent again";
  EXPECT_EQ(controller_.state().tail_points, static_cast<std::uint32_t>(kTailSent));
  silent_until(start_ns(3) + 30 * kSlot_ns);
  expect_moved(moved_after(kTailSent));
}

// Else no outage would be survived any more, long after a disturbance.
TEST_F(TailTest, ALostReportThatItIsHeldAgainKeepsNoTailFromBeingUsed) {
  constexpr can::NodeId kRobbed = 7;
  bus_.drop = [&](const can::Frame& frame) {
    const auto is = controller_.profile().identify(frame.id);
    return is->kind == can::MessageKind::tail && is->node == kRobbed && now_ns_ < start_ns(3);
  };
  int reports = 0;
  bus_.drop_from_joint = [&](const can::Frame& frame) {
    const auto is = controller_.profile().identify(frame.id);
    return is->kind == can::MessageKind::fault_report && is->node == kRobbed && ++reports > 1;
  };
  for (std::uint32_t sequence = 2; sequence < 20; ++sequence) {
    ASSERT_EQ(hand_over_on_one_foot(sequence).verdict, Verdict::accepted);
  }
  run_until(start_ns(19) + kMillisecond_ns);
  ASSERT_GE(reports, 2) << "that it lacks one, and that it does not";
  EXPECT_EQ(controller_.state().tail_points, static_cast<std::uint32_t>(kTailSent));
  silent_until(start_ns(20) + 30 * kSlot_ns);
  expect_moved(8 * 17 + moved_after(kTailSent));
}

TEST_F(TailTest, AJointThatHasRestartedGetsTheTailThatSyncNames) {
  constexpr std::size_t kRestarted = 6;
  ASSERT_EQ(hand_over_on_one_foot(2).verdict, Verdict::accepted);
  run_until(start_ns(2) + kSlot_ns);
  bus_.restart(kRestarted);
  run_until(start_ns(2) + 6 * kSlot_ns);
  EXPECT_EQ(controller_.state().tail_points, static_cast<std::uint32_t>(kTailSent));
  silent_until(start_ns(3) + 30 * kSlot_ns);
  expect_moved(moved_after(kTailSent));
}

// Of a report that comes more than once, or of a joint that never stops telling.
TEST_F(TailTest, AFloodOfReportsCostsNeitherTheTailNorTheQueuesRoom) {
  for (const can::Fault told : {can::Fault::tail_missing, can::Fault::restarted}) {
    const std::uint32_t sequence = told == can::Fault::restarted ? 4 : 2;
    ASSERT_EQ(hand_over_on_one_foot(sequence).verdict, Verdict::accepted);
    run_until(start_ns(sequence) + kSlot_ns);
    for (int report = 0; report < 300; ++report) {
      controller_.on_frame(
          can::encode(controller_.profile(), can::FaultReport{7, static_cast<std::uint8_t>(told)}), now_ns_);
    }
    EXPECT_LT(controller_.queue().size(), 20U);
    run_until(start_ns(sequence) + 3 * kSlot_ns);
    EXPECT_EQ(controller_.state().tail_points, static_cast<std::uint32_t>(kTailSent));
    EXPECT_EQ(controller_.health().queue_full, 0U);
    run_until(start_ns(sequence + 1) - 16 * kMillisecond_ns);
  }
}

TEST_F(TailTest, NoneIsUsedForASecondOnceAJointGetsNoneWhateverIsSent) {
  constexpr can::NodeId kRobbed = 7;
  bool robbed = true;
  bus_.drop = [&](const can::Frame& frame) {
    const auto is = controller_.profile().identify(frame.id);
    return robbed && is->kind == can::MessageKind::tail && is->node == kRobbed;
  };
  std::uint32_t sequence = 2;
  const auto tail_points_of_next_batch = [&] {
    EXPECT_EQ(hand_over_on_one_foot(sequence).verdict, Verdict::accepted);
    run_until(start_ns(sequence) + 4 * kSlot_ns + kMillisecond_ns);
    ++sequence;
    return controller_.state().tail_points;
  };
  for (int tried = 0; tried < 2; ++tried) {
    EXPECT_EQ(tail_points_of_next_batch(), static_cast<std::uint32_t>(kTailSent))
        << "it may have been chance";
  }
  for (int distrusted = 0; distrusted < 12; ++distrusted) {
    EXPECT_EQ(tail_points_of_next_batch(), 0U) << sequence;
  }
  robbed = false;
  for (int cycle = 0; cycle < 4; ++cycle) {
    static_cast<void>(tail_points_of_next_batch());
  }
  EXPECT_EQ(tail_points_of_next_batch(), static_cast<std::uint32_t>(kTailSent));
}

TEST_F(TailTest, ABatchWithoutATailIsNotExpectedToHaveOne) {
  ASSERT_EQ(hand_over_on_one_foot(2, 100).verdict, Verdict::accepted);  // none of its own
  run_until(start_ns(2) + 4 * kSlot_ns + kMillisecond_ns);
  silent_until(start_ns(3) + 3 * kSlot_ns + kMillisecond_ns);
  const std::uint64_t differed = controller_.health().counts_differed;
  run_until(start_ns(3) + 6 * kSlot_ns);
  EXPECT_EQ(controller_.health().counts_differed, differed);
  expect_moved(8);
}

TEST_F(TailTest, AJointThatAnswersLateIsNotPulledToWhereItWasAssumed) {
  constexpr std::size_t kLate = 6;
  const urdf::Joint& description = robot_.joints[kLate];
  const std::int32_t elsewhere = JointsOnABus::home_count(description) + 200;
  msgclient::MemoryBlock block;
  msgclient::EmiAdapter adapter(block);
  msgclient::Client client = block.local_client("message_controller");
  MessageController fresh(robot_, client, adapter.message());
  JointsOnABus bus(robot_);
  bus.joint(kLate).on_frame(can::encode(fresh.profile(), can::Sync{.cycle = 1, .slot = 1}), now_ns_);
  bus.joint(kLate).on_frame(
      can::encode(fresh.profile(),
                  can::Resynchronisation{
                      .node = description.node, .slot = 2, .count = static_cast<std::int16_t>(elsewhere)}),
      now_ns_);
  bus.joint(kLate).on_frame(can::encode(fresh.profile(), can::Sync{.cycle = 1, .slot = 2}), now_ns_);
  ASSERT_EQ(bus.count(kLate), elsewhere);
  bus.sensors[kLate].encoder_count = static_cast<std::int32_t>(
      std::lround(elsewhere * description.count_rad / description.encoder_count_rad));
  std::int64_t now_ns = 100 * kCycle_ns;
  const auto run = [&](std::int64_t until_ns) {
    for (; now_ns < until_ns; now_ns += kMillisecond_ns) {
      bus.millisecond(fresh, now_ns);
    }
  };
  bus.drop_from_joint = [&](const can::Frame& frame) {
    return fresh.profile().identify(frame.id)->node == description.node;
  };
  run(101 * kCycle_ns);
  EXPECT_TRUE(fresh.joints_known());
  bus.drop_from_joint = [](const can::Frame&) { return false; };
  run(103 * kCycle_ns);
  EXPECT_EQ(bus.count(kLate), elsewhere);
  EXPECT_EQ(fresh.expected_count(static_cast<int>(kLate)), elsewhere);
  EXPECT_EQ(fresh.state().resynchronised, 0U);
}

TEST_F(TailTest, EachBatchBringsItsOwn) {
  for (std::uint32_t sequence = 2; sequence < 12; ++sequence) {
    ASSERT_EQ(hand_over_on_one_foot(sequence, 3 + static_cast<int>(sequence)).verdict, Verdict::accepted);
    run_until(start_ns(sequence) + kMillisecond_ns);
    EXPECT_EQ(controller_.state().tail_points, 3 + sequence);
  }
  silent_until(start_ns(12) + 30 * kSlot_ns);
  expect_moved(8 * 9 + moved_after(14));
}

// As a process that was stopped and goes on: within the tail, after it, or long after.
TEST_F(TailTest, AMessageControllerThatWasAwayFindsTheJointsWhereItExpectsThem) {
  for (const int away_slots : {1, 3, 7, 9, 12, 18, 21, 30, 500}) {
    SCOPED_TRACE(away_slots);
    const std::uint32_t sequence = controller_.state().cycle + 2;
    first_sequence_ = static_cast<int>(sequence);
    const std::int32_t from = bus_.count(0) - JointsOnABus::home_count(robot_.joints[0]);
    const auto mail = std::make_unique<msgclient::HandOver>(batch(sequence));
    run_until(start_ns(sequence) - 16 * kMillisecond_ns);
    for (std::uint32_t point = 0; point < mail->point_count; ++point) {
      mail->support[point] = static_cast<int>(point) < kBatchPoints + kTailSent - 1 ? 0 : kBothFeet;
      for (int joint = 0; joint < static_cast<int>(robot_.joints.size()); ++joint) {
        const auto& description = robot_.joints[static_cast<std::size_t>(joint)];
        mail->set_position(static_cast<int>(point), joint,
                           static_cast<float>(mail->position_at(static_cast<int>(point), joint) +
                                              from * description.count_rad));
      }
    }
    ASSERT_TRUE(adapter_.host().post(*mail, now_ns_));
    run_until(start_ns(sequence) + 4 * kSlot_ns + kMillisecond_ns);
    ASSERT_EQ(adapter_.host().take_answer(now_ns_)->verdict, Verdict::accepted);
    const std::uint64_t differed = controller_.health().counts_differed;
    silent_until(now_ns_ + away_slots * kSlot_ns);
    run_until(now_ns_ + 60 * kSlot_ns);
    EXPECT_EQ(controller_.health().counts_differed, differed) << "nobody was where it did not expect him";
    expect_moved(from + moved_after(20));  // the rest of the safe tail has been played
    EXPECT_EQ(controller_.mode(), Mode::holding);
  }
}

TEST_F(TailTest, ABusThatIsGoneForAWhileIsAnAbsenceToo) {
  ASSERT_EQ(hand_over_on_one_foot(2).verdict, Verdict::accepted);
  run_until(start_ns(2) + 2 * kSlot_ns);
  controller_.on_bus_state(can::BusState::bus_off, {}, now_ns_);
  const auto lost = [](const can::Frame&) { return true; };
  bus_.drop = bus_.drop_from_joint = lost;
  run_until(start_ns(3) + 5 * kSlot_ns);
  EXPECT_EQ(controller_.state().left_to_joints, 1U);
  bus_.drop = bus_.drop_from_joint = [](const can::Frame&) { return false; };
  controller_.on_bus_state(can::BusState::error_active, {}, now_ns_);
  const std::uint64_t differed = controller_.health().counts_differed;
  run_until(start_ns(12));
  EXPECT_EQ(controller_.health().counts_differed, differed);
  expect_moved(moved_after(20));
  EXPECT_EQ(controller_.mode(), Mode::holding);
}

// Sixteen counts do not show in its feedback.
TEST_F(TailTest, AfterAnOutageEachJointIsToldItsCountBeforeAnythingMoves) {
  ASSERT_EQ(hand_over_on_one_foot(2).verdict, Verdict::accepted);
  run_until(start_ns(2) + 4 * kSlot_ns + kMillisecond_ns);
  silent_until(start_ns(2) + 30 * kSlot_ns + kMillisecond_ns);
  constexpr std::size_t kAstray = 5;
  const urdf::Joint& description = robot_.joints[kAstray];
  const std::int32_t right = bus_.count(kAstray);
  bus_.joint(kAstray).on_frame(
      can::encode(controller_.profile(),
                  can::Resynchronisation{
                      .node = description.node, .slot = 7, .count = static_cast<std::int16_t>(right + 16)}),
      now_ns_);
  bus_.joint(kAstray).on_frame(can::encode(controller_.profile(), can::Sync{.cycle = 900, .slot = 7}),
                               now_ns_);
  ASSERT_EQ(bus_.count(kAstray), right + 16);
  run_until(now_ns_ + 60 * kSlot_ns);
  expect_moved(moved_after(20));
}

// A fresh one, as after a kill, knows of nothing.
TEST_F(TailTest, AFreshMessageControllerStartsFromWhereTheJointsAre) {
  ASSERT_EQ(hand_over_on_one_foot(2).verdict, Verdict::accepted);
  run_until(start_ns(2) + 3 * kSlot_ns);
  silent_until(start_ns(2) + 9 * kSlot_ns);
  msgclient::MemoryBlock block;
  msgclient::EmiAdapter adapter(block);
  msgclient::Client client = block.local_client("message_controller");
  MessageController fresh(robot_, client, adapter.message());
  const auto run = [&](std::int64_t time_ns) {
    for (; now_ns_ < time_ns; now_ns_ += kMillisecond_ns) {
      for (std::size_t joint = 0; joint < bus_.size(); ++joint) {  // they stand where they were told
        const urdf::Joint& description = robot_.joints[joint];
        bus_.sensors[joint].encoder_count = static_cast<std::int32_t>(
            std::lround(bus_.count(joint) * description.count_rad / description.encoder_count_rad));
      }
      bus_.millisecond(fresh, now_ns_);
    }
  };
  run(now_ns_ + 2 * kSlot_ns);
  EXPECT_FALSE(fresh.joints_known()) << "they are still on their way";
  run(start_ns(2) + 30 * kSlot_ns);
  expect_moved(moved_after(kTailSent));
  EXPECT_TRUE(fresh.joints_known());
  EXPECT_EQ(fresh.state().resynchronised, 0U);
  for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
    EXPECT_EQ(fresh.expected_count(static_cast<int>(joint)), bus_.count(joint)) << joint;
  }
}

TEST_F(TailTest, AnEmergencyStopEndsItOnTheJointsToo) {
  ASSERT_EQ(hand_over_on_one_foot(2).verdict, Verdict::accepted);
  run_until(start_ns(2) + 3 * kSlot_ns);
  command(msgclient::UserCommandKind::emergency_stop_hold);
  const std::int32_t stopped = bus_.count(0);
  silent_until(start_ns(2) + 40 * kSlot_ns);
  EXPECT_EQ(bus_.count(0), stopped);
}

}  // namespace
}  // namespace gaitway::msgcontroller
