// People's commands that come through the queue `user_command`, past the main controller: what they do, how
// fast, and what is refused.
#include <limits>

#include "message_controller_fixture.hpp"

namespace gaitway::msgcontroller {
namespace {

using Kind = msgclient::UserCommandKind;
using msgclient::Reason;

class UserCommandQueueTest : public MessageControllerTest {
 protected:
  bool push(UserCommand command) {
    command.number = ++commands_;
    return queue_.push(command, now_ns_);
  }
  static UserCommand command_of(std::uint32_t kind) {
    UserCommand command{};
    command.kind = kind;
    return command;
  }
  bool push(Kind kind) { return push(command_of(static_cast<std::uint32_t>(kind))); }
  static UserCommand move(std::uint32_t joint, double position_rad) {
    UserCommand command = command_of(static_cast<std::uint32_t>(Kind::manual_joint));
    command.joint = joint;
    command.duration_slots = 10;
    command.position = position_rad;
    return command;
  }
  // What became of the last command; it was answered within the millisecond.
  Reason outcome() {
    run_until(now_ns_ + kMillisecond_ns);
    UserCommandAnswer answer{};
    EXPECT_TRUE(answers_.read(answer));
    EXPECT_EQ(answer.number, commands_);
    return static_cast<Reason>(answer.reason);
  }

  // Hands over a batch and a tail in which every joint is so many counts from its home; 10 ms before it
  // plays.
  Reason give(
      std::uint32_t sequence, const std::function<int(int point)>& from_home = [](int) { return 0; }) {
    run_until(std::int64_t{sequence} * kCycle_ns - 10 * kMillisecond_ns);
    auto mail = std::make_unique<msgclient::HandOver>(batch(sequence));
    for (int point = 0; point < static_cast<int>(mail->point_count); ++point) {
      for (int joint = 0; joint < static_cast<int>(robot_.joints.size()); ++joint) {
        const urdf::Joint& description = robot_.joints[static_cast<std::size_t>(joint)];
        const int count = JointsOnABus::home_count(description) + from_home(point);
        mail->set_position(point, joint, static_cast<float>(count * description.count_rad));
      }
    }
    EXPECT_TRUE(adapter_.host().post(*mail, now_ns_));
    run_until(now_ns_ + 2 * kMillisecond_ns);
    return adapter_.host().take_answer(now_ns_)->reason;
  }

  msgclient::Client api_ = block_.local_client("api");
  msgclient::QueueWriter<UserCommand> queue_ = api_.write_queue<UserCommand>("user_command");
  msgclient::StreamReader<UserCommandAnswer> answers_ =
      api_.read_stream<UserCommandAnswer>("user_command_answer");
};

TEST_F(UserCommandQueueTest, AnEmergencyStopIsOnTheBusInTheMillisecondInWhichItIsSeen) {
  hand_over(2);
  run_until(2 * kCycle_ns + 23 * kMillisecond_ns);
  ASSERT_TRUE(push(Kind::emergency_stop_soft));
  EXPECT_EQ(outcome(), Reason::none);
  EXPECT_EQ(bus_.sent[can::MessageKind::emergency_stop], 1);
  EXPECT_EQ(controller_.mode(), Mode::emergency_stop);
}

TEST_F(UserCommandQueueTest, AStopPlaysTheSafeTailToItsEnd) {
  hand_over(2);
  ASSERT_TRUE(push(Kind::stop));
  EXPECT_EQ(outcome(), Reason::none);
  EXPECT_EQ(hand_over(3).reason, Reason::stopping);
  run_until(7 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
}

// The batch that is with the joints already would go on for 80 ms more.
TEST_F(UserCommandQueueTest, AStopPutsTheRunningBatchsTailInThePlaceOfThePreparedBatch) {
  hand_over(2);
  EXPECT_EQ(hand_over(3).verdict, Verdict::accepted);  // while batch 2 runs
  const int before = bus_.sent[can::MessageKind::trajectory];
  ASSERT_TRUE(push(Kind::stop));
  EXPECT_EQ(outcome(), Reason::none);
  EXPECT_EQ(bus_.sent[can::MessageKind::trajectory], before + 22) << "at once";
  run_until(7 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  EXPECT_EQ(controller_.state().resynchronised, 0U);
  expect_moved(8 + 10);  // batch 2 and its tail of half the speed, nothing of batch 3
}

TEST_F(UserCommandQueueTest, AStopShortlyBeforeTheNextBatchLetsItPlayAndSendsItsTailAsItBegins) {
  hand_over(2);
  EXPECT_EQ(hand_over(3).verdict, Verdict::accepted);
  run_until(3 * kCycle_ns - 2 * kMillisecond_ns);
  ASSERT_TRUE(push(Kind::stop));
  EXPECT_EQ(outcome(), Reason::none);
  const int before = bus_.sent[can::MessageKind::trajectory];
  run_until(3 * kCycle_ns + kMillisecond_ns);
  EXPECT_EQ(bus_.sent[can::MessageKind::trajectory], before + 22);
  run_until(8 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  expect_moved(16 + 10);
}

TEST_F(UserCommandQueueTest, AStopInsideABatchWithoutASuccessorSendsItsTailAtOnce) {
  hand_over(2);
  run_until(2 * kCycle_ns + 3 * kMillisecond_ns);
  const int before = bus_.sent[can::MessageKind::trajectory];
  ASSERT_TRUE(push(Kind::stop));
  EXPECT_EQ(outcome(), Reason::none);
  EXPECT_EQ(bus_.sent[can::MessageKind::trajectory], before + 22);
  run_until(7 * kCycle_ns);
  expect_moved(8 + 10);
  EXPECT_EQ(controller_.state().resynchronised, 0U);
}

TEST_F(UserCommandQueueTest, AJointMovesWithinItsLimitsOnly) {
  run_until(kCycle_ns);
  ASSERT_TRUE(push(move(3, robot_.joints[3].upper_rad + 0.01)));
  EXPECT_EQ(outcome(), Reason::beyond_limits);
  ASSERT_TRUE(push(move(3, std::numeric_limits<double>::quiet_NaN())));
  EXPECT_EQ(outcome(), Reason::beyond_limits);
  ASSERT_TRUE(push(move(3, 1e300)));
  EXPECT_EQ(outcome(), Reason::beyond_limits);
  ASSERT_TRUE(push(move(22, 0.0)));
  EXPECT_EQ(outcome(), Reason::unknown_joint);
  ASSERT_TRUE(push(move(3, robot_.joints[3].home_rad + 20 * robot_.joints[3].count_rad)));
  EXPECT_EQ(outcome(), Reason::none);
  run_until(3 * kCycle_ns);
  EXPECT_EQ(bus_.count(3) - JointsOnABus::home_count(robot_.joints[3]), 20);
}

// What a standing robot plays: batches that leave it where it is.
TEST_F(UserCommandQueueTest, AJointMovesWhileBatchesLeaveTheRobotWhereItIs) {
  EXPECT_EQ(give(2), Reason::none);
  run_until(2 * kCycle_ns + 5 * kMillisecond_ns);
  EXPECT_EQ(give(3), Reason::none);
  ASSERT_TRUE(push(move(3, robot_.joints[3].home_rad + 20 * robot_.joints[3].count_rad)));
  EXPECT_EQ(outcome(), Reason::none);
  EXPECT_EQ(bus_.sent[can::MessageKind::user_command], 1) << "at once";
  EXPECT_EQ(give(4), Reason::moving_by_hand);
  run_until(5 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  EXPECT_EQ(bus_.count(3) - JointsOnABus::home_count(robot_.joints[3]), 20);
  EXPECT_EQ(controller_.state().resynchronised, 0U);
  EXPECT_EQ(give(6), Reason::moving_by_hand) << "it is not where the plan has it";
  ASSERT_TRUE(push(move(3, robot_.joints[3].home_rad)));
  EXPECT_EQ(outcome(), Reason::none);
  EXPECT_EQ(give(9), Reason::none);
  run_until(10 * kCycle_ns);
  expect_moved(0);
}

// A robot that keeps its balance never repeats its counts.
TEST_F(UserCommandQueueTest, AJointThatSwaysInTheStandMovesAsSoonAsItsBatchIsOver) {
  const auto sway = [](int point) { return point % 5 - 2; };
  EXPECT_EQ(give(2, sway), Reason::none);
  run_until(2 * kCycle_ns + 5 * kMillisecond_ns);
  EXPECT_EQ(give(3, sway), Reason::none);
  ASSERT_TRUE(push(move(3, robot_.joints[3].home_rad + 20 * robot_.joints[3].count_rad)));
  EXPECT_EQ(outcome(), Reason::none);
  EXPECT_EQ(bus_.sent[can::MessageKind::user_command], 0) << "the joint would not take it yet";
  ASSERT_TRUE(push(move(4, robot_.joints[4].home_rad)));
  EXPECT_EQ(outcome(), Reason::moving_by_hand);
  EXPECT_EQ(give(4, sway), Reason::moving_by_hand);
  run_until(5 * kCycle_ns);
  EXPECT_EQ(bus_.sent[can::MessageKind::user_command], 1);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  EXPECT_EQ(bus_.count(3) - JointsOnABus::home_count(robot_.joints[3]), 20);
  EXPECT_EQ(controller_.state().resynchronised, 0U);
}

TEST_F(UserCommandQueueTest, AStopTakesBackTheMovementThatWaits) {
  const auto sway = [](int point) { return point % 5 - 2; };
  EXPECT_EQ(give(2, sway), Reason::none);
  run_until(2 * kCycle_ns + 5 * kMillisecond_ns);
  ASSERT_TRUE(push(move(3, robot_.joints[3].home_rad + 20 * robot_.joints[3].count_rad)));
  EXPECT_EQ(outcome(), Reason::none);
  ASSERT_TRUE(push(Kind::stop));
  EXPECT_EQ(outcome(), Reason::none);
  run_until(5 * kCycle_ns);
  EXPECT_EQ(bus_.sent[can::MessageKind::user_command], 0);
  EXPECT_EQ(controller_.mode(), Mode::holding);
}

// Three counts a time slot: within 0.3 s each joint is 4 degrees away.
TEST_F(UserCommandQueueTest, AJointDoesNotMoveByHandWhileABatchOrItsTailMoves) {
  EXPECT_EQ(give(2, [](int point) { return 3 * point; }), Reason::none);
  run_until(2 * kCycle_ns + 5 * kMillisecond_ns);
  ASSERT_TRUE(push(move(3, robot_.joints[3].home_rad)));
  EXPECT_EQ(outcome(), Reason::not_standing);
  run_until(3 * kCycle_ns + 5 * kMillisecond_ns);
  ASSERT_TRUE(push(move(3, robot_.joints[3].home_rad)));
  EXPECT_EQ(outcome(), Reason::not_standing) << "its tail";
}

TEST_F(UserCommandQueueTest, WhatNobodyKnowsIsRefused) {
  run_until(kCycle_ns);
  ASSERT_TRUE(push(command_of(5)));
  EXPECT_EQ(outcome(), Reason::unknown_command);
  EXPECT_EQ(controller_.mode(), Mode::holding);
}

TEST_F(UserCommandQueueTest, EachCommandIsAnsweredInItsOrder) {
  run_until(kCycle_ns);
  for (int i = 0; i < 8; ++i) {
    ASSERT_TRUE(push(command_of(99)));
  }
  run_until(now_ns_ + kMillisecond_ns);
  UserCommandAnswer answer{};
  for (std::uint32_t number = 1; number <= 8; ++number) {
    ASSERT_TRUE(answers_.read(answer));
    EXPECT_EQ(answer.number, number);
  }
  EXPECT_FALSE(answers_.read(answer));
}

}  // namespace
}  // namespace gaitway::msgcontroller
