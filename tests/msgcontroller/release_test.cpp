// The release of an emergency stop: what it starts from, what it waits for, and what it refuses.
#include <algorithm>
#include <optional>

#include "message_controller_fixture.hpp"

namespace gaitway::msgcontroller {
namespace {

using Kind = msgclient::UserCommandKind;
using msgclient::Reason;

class ReleaseTest : public MessageControllerTest {
 protected:
  // Once the controller knows where the joints stand, their encoders read something else.
  void SetUp() override {
    run_until(now_ns_ + 2 * kSlot_ns);
    std::ranges::fill(bus_.sensors, localcontroller::JointSensors{});
  }
  void push(Kind kind) {
    UserCommand command{};
    command.number = ++commands_;
    command.kind = static_cast<std::uint32_t>(kind);
    ASSERT_TRUE(queue_.push(command, now_ns_));
  }
  // The next answer, which must come within a fifth of a second.
  Reason outcome() {
    UserCommandAnswer answer{};
    for (int ms = 0; ms < 200; ++ms) {
      run_until(now_ns_ + kMillisecond_ns);
      if (answers_.read(answer)) {
        EXPECT_EQ(answer.number, commands_);
        return static_cast<Reason>(answer.reason);
      }
    }
    ADD_FAILURE() << "no answer";
    return Reason::none;
  }
  void stop(Kind kind = Kind::emergency_stop_hold) {
    push(kind);
    ASSERT_EQ(outcome(), Reason::none);
    run_until(now_ns_ + 3 * kSlot_ns);
  }
  void expect_all(can::JointState state) {
    for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
      EXPECT_EQ(bus_.joint(joint).state(), state) << "joint " << joint;
    }
  }
  // The first frame of this kind from now on, which the bus is offered and which is taken back. No batch
  // arrives meanwhile.
  std::shared_ptr<std::optional<can::Frame>> take_back(can::MessageKind kind) {
    auto taken = std::make_shared<std::optional<can::Frame>>();
    bus_.drop = [taken, kind](const can::Frame& frame) {
      const auto is = can::kFullProfile.identify(frame.id)->kind;
      if (is == kind && !*taken) {
        *taken = frame;
      }
      return is == kind || is == can::MessageKind::trajectory;
    };
    return taken;
  }
  // It waits again as the robot is stopped and, in the same millisecond, released.
  void expect_nothing_after_a_stop_and_its_release(const can::Frame& frame) {
    bus_.drop = [](const can::Frame&) { return false; };
    controller_.put_back(frame);
    push(Kind::emergency_stop_hold);
    push(Kind::release);
    every_millisecond = [this] {
      for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
        EXPECT_EQ(bus_.count(joint), 0)
            << "joint " << joint << " leaves where its encoder reads, " << now_ns_;
      }
    };
    run_until(now_ns_ + 10 * kSlot_ns);
    EXPECT_EQ(controller_.mode(), Mode::holding);
    expect_all(can::JointState::holding);
  }
  // Batches that leave every joint where the robot holds it.
  Reason hand_over_where_it_stands(std::uint32_t sequence) {
    auto mail = std::make_unique<msgclient::HandOver>(batch(sequence));
    for (int point = 0; point < static_cast<int>(mail->point_count); ++point) {
      for (int joint = 0; joint < static_cast<int>(robot_.joints.size()); ++joint) {
        mail->set_position(point, joint,
                           static_cast<float>(controller_.expected_count(joint) *
                                              robot_.joints[static_cast<std::size_t>(joint)].count_rad));
      }
    }
    run_until(std::int64_t{sequence} * kCycle_ns - 16 * kMillisecond_ns);
    EXPECT_TRUE(adapter_.host().post(*mail, now_ns_));
    run_until(now_ns_ + 3 * kMillisecond_ns);
    return adapter_.host().take_answer(now_ns_)->reason;
  }

  msgclient::Client api_ = block_.local_client("api");
  msgclient::QueueWriter<UserCommand> queue_ = api_.write_queue<UserCommand>("user_command");
  msgclient::StreamReader<UserCommandAnswer> answers_ =
      api_.read_stream<UserCommandAnswer>("user_command_answer");
};

TEST_F(ReleaseTest, TheRobotHoldsWhereItsJointsAreMeasuredAndTakesBatchesAgain) {
  hand_over(2);
  run_until(2 * kCycle_ns + 35 * kMillisecond_ns);
  stop(Kind::emergency_stop_soft);
  EXPECT_EQ(hand_over(4).reason, Reason::emergency_stopped);
  push(Kind::release);
  EXPECT_EQ(outcome(), Reason::none);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  run_until(now_ns_ + 5 * kSlot_ns);
  expect_all(can::JointState::holding);
  for (std::size_t joint = 0; joint < bus_.size(); ++joint) {  // these joints' encoders read 0
    EXPECT_EQ(bus_.count(joint), 0) << "joint " << joint;
    EXPECT_EQ(controller_.expected_count(static_cast<int>(joint)), 0) << "joint " << joint;
  }
  const std::uint64_t repaired = controller_.state().resynchronised;
  EXPECT_EQ(hand_over_where_it_stands(static_cast<std::uint32_t>(now_ns_ / kCycle_ns) + 2), Reason::none);
  run_until(now_ns_ + 3 * kCycle_ns);
  EXPECT_EQ(controller_.state().resynchronised, repaired) << "joints and controller agree";
}

TEST_F(ReleaseTest, NoRepairFromBeforeTheStopMovesAReleasedJoint) {
  hand_over(2);
  run_until(2 * kCycle_ns);
  const auto repair = take_back(can::MessageKind::resynchronisation);
  hand_over(3);
  run_until(3 * kCycle_ns + 5 * kMillisecond_ns);
  ASSERT_TRUE(*repair) << "a joint that got no batch is given its count";
  expect_nothing_after_a_stop_and_its_release(**repair);
}

TEST_F(ReleaseTest, NoMovementByHandFromBeforeTheStopMovesAReleasedJoint) {
  run_until(kCycle_ns);
  const auto movement = take_back(can::MessageKind::user_command);
  UserCommand command{};
  command.number = ++commands_;
  command.kind = static_cast<std::uint32_t>(Kind::manual_joint);
  command.position = robot_.joints.front().home_rad + 0.05;
  command.duration_slots = 50;
  ASSERT_TRUE(queue_.push(command, now_ns_));
  run_until(now_ns_ + kMillisecond_ns);
  ASSERT_TRUE(*movement);
  expect_nothing_after_a_stop_and_its_release(**movement);
}

TEST_F(ReleaseTest, NoJointStaysSoftThatWasSoftBeforeTheStop) {
  std::uint8_t softness = 0;
  bus_.drop = [&softness](const can::Frame& frame) {
    if (const auto sync = can::decode_sync(can::kFullProfile, frame)) {
      softness = sync->softness;
    }
    return false;
  };
  run_until(kCycle_ns);
  ASSERT_TRUE(adapter_.host().post(msgclient::TrimUpdate{.softness = 1.0F}, now_ns_));
  run_until(now_ns_ + 2 * kSlot_ns);
  ASSERT_EQ(softness, can::kMostSoftness);
  stop();
  push(Kind::release);
  ASSERT_EQ(outcome(), Reason::none);
  run_until(now_ns_ + 2 * kSlot_ns);
  EXPECT_EQ(softness, 0) << "the main controller has sent nothing since";
}

TEST_F(ReleaseTest, WithoutAnEmergencyStopItIsRefused) {
  run_until(kCycle_ns);
  push(Kind::release);
  EXPECT_EQ(outcome(), Reason::not_stopped);
  EXPECT_EQ(bus_.sent[can::MessageKind::emergency_stop], 0);
}

TEST_F(ReleaseTest, AReleaseThatSomeJointsDoNotHearIsRepeated) {
  run_until(kCycle_ns);
  stop();
  int lost = 3;
  bus_.drop = [&lost](const can::Frame& frame) {
    return can::kFullProfile.identify(frame.id)->kind == can::MessageKind::emergency_stop && lost-- > 0;
  };
  push(Kind::release);
  EXPECT_EQ(outcome(), Reason::none);
  run_until(now_ns_ + kSlot_ns);
  expect_all(can::JointState::holding);
}

TEST_F(ReleaseTest, WhatCannotBeReleasedAsAWholeStaysStopped) {
  run_until(kCycle_ns);
  stop();
  bus_.drop = [](const can::Frame& frame) {
    return can::kFullProfile.identify(frame.id)->kind == can::MessageKind::emergency_stop &&
           frame.data[0] == 2;
  };
  push(Kind::release);
  EXPECT_EQ(outcome(), Reason::emergency_stopped);
  EXPECT_EQ(controller_.mode(), Mode::emergency_stop);
  expect_all(can::JointState::stopped);
}

TEST_F(ReleaseTest, AStopDuringTheReleaseWins) {
  run_until(kCycle_ns);
  stop();
  push(Kind::release);
  run_until(now_ns_ + 2 * kMillisecond_ns);
  push(Kind::release);
  run_until(now_ns_ + kMillisecond_ns);
  UserCommandAnswer answer{};
  ASSERT_TRUE(answers_.read(answer));
  EXPECT_EQ(static_cast<Reason>(answer.reason), Reason::releasing);
  msgclient::Writer<StopRequest> stops = api_.write<StopRequest>("stop_request");
  StopRequest asked{};
  asked.holds = 1;
  stops.publish(asked, now_ns_);
  run_until(now_ns_ + 5 * kSlot_ns);
  ASSERT_TRUE(answers_.read(answer));
  EXPECT_EQ(answer.number, commands_ - 1);
  EXPECT_EQ(static_cast<Reason>(answer.reason), Reason::emergency_stopped);
  EXPECT_EQ(controller_.mode(), Mode::emergency_stop);
  expect_all(can::JointState::stopped);
}

TEST_F(ReleaseTest, AJointThatIsMissingKeepsTheRobotStopped) {
  run_until(kCycle_ns);
  stop();
  bus_.drop_from_joint = [](const can::Frame& frame) {
    return can::kFullProfile.identify(frame.id)->node == 5;
  };
  run_until(now_ns_ + 5 * kSlot_ns);
  push(Kind::release);
  EXPECT_EQ(outcome(), Reason::node_fault);
  expect_all(can::JointState::stopped);
}

TEST_F(ReleaseTest, AStopAfterAnEmergencyStopDoesNotEndIt) {
  hand_over(2);
  ASSERT_EQ(hand_over(3).verdict, Verdict::accepted);  // waits while batch 2 runs
  bus_.intrude(controller_, can::encode(can::kFullProfile, can::Trajectory{.node = 5}), now_ns_);  // forged
  push(Kind::emergency_stop_hold);
  EXPECT_EQ(outcome(), Reason::none);
  push(Kind::stop);
  EXPECT_EQ(outcome(), Reason::none);
  EXPECT_EQ(controller_.mode(), Mode::emergency_stop);
  run_until(4 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::emergency_stop);
  EXPECT_EQ(controller_.state().tail_played, 0U);
}

TEST_F(ReleaseTest, WhatWaitsToBeSentIsDroppedByAnEmergencyStop) {
  run_until(2 * kCycle_ns - 16 * kMillisecond_ns);
  ASSERT_TRUE(adapter_.host().post(*std::make_unique<msgclient::HandOver>(batch(2)), now_ns_));
  for (const std::int64_t end_ns = now_ns_ + 3 * kMillisecond_ns; now_ns_ < end_ns;
       now_ns_ += kMillisecond_ns) {
    controller_.step(now_ns_);  // the bus is busy: nobody takes frames
  }
  ASSERT_FALSE(controller_.queue().empty());
  push(Kind::emergency_stop_hold);
  controller_.step(now_ns_);
  int stops = 0;
  can::Frame frame;
  while (controller_.take_frame(frame)) {
    const can::MessageKind kind = can::kFullProfile.identify(frame.id)->kind;
    EXPECT_NE(kind, can::MessageKind::trajectory) << "a joint that is released soon would play it";
    stops += kind == can::MessageKind::emergency_stop ? 1 : 0;
  }
  EXPECT_EQ(stops, 1);
}

TEST_F(ReleaseTest, AJointThatDoesNotHearThatItIsToGoSoftIsToldAgain) {
  run_until(kCycle_ns);
  stop();
  int lost = 1;
  bus_.drop = [&lost](const can::Frame& frame) {
    return can::kFullProfile.identify(frame.id)->kind == can::MessageKind::emergency_stop && lost-- > 0;
  };
  stop(Kind::emergency_stop_soft);
  expect_all(can::JointState::soft);
}

TEST_F(ReleaseTest, AJointThatHangsBeyondItsLimitIsHeldAtIt) {
  constexpr std::size_t kJoint = 3;
  const urdf::Joint& joint = robot_.joints[kJoint];
  run_until(kCycle_ns);
  stop(Kind::emergency_stop_soft);
  bus_.sensors[kJoint].encoder_count = static_cast<std::int32_t>(
      std::lround((joint.upper_rad + 20 * joint.count_rad) / joint.encoder_count_rad));
  run_until(now_ns_ + 2 * kSlot_ns);
  push(Kind::release);
  EXPECT_EQ(outcome(), Reason::none);
  run_until(now_ns_ + 2 * kSlot_ns);
  EXPECT_EQ(bus_.count(kJoint), static_cast<std::int32_t>(joint.upper_rad / joint.count_rad));
  EXPECT_EQ(controller_.expected_count(kJoint), bus_.count(kJoint));
}

TEST_F(ReleaseTest, AJointThatSagsBeforeTheOthersHaveConfirmedIsHeldWhereItWasReleased) {
  constexpr std::size_t kJoint = 3;
  const urdf::Joint& joint = robot_.joints[kJoint];
  run_until(kCycle_ns);
  stop();
  bus_.drop_from_joint = [](const can::Frame& frame) {
    return can::kFullProfile.identify(frame.id)->node == 5;
  };
  push(Kind::release);
  run_until(now_ns_ + 2 * kSlot_ns);
  bus_.sensors[kJoint].encoder_count =
      static_cast<std::int32_t>(std::lround(12 * joint.count_rad / joint.encoder_count_rad));
  run_until(now_ns_ + 2 * kSlot_ns);
  bus_.drop_from_joint = [](const can::Frame&) { return false; };
  EXPECT_EQ(outcome(), Reason::none);
  run_until(now_ns_ + 2 * kSlot_ns);
  EXPECT_EQ(controller_.expected_count(kJoint), 0);
  EXPECT_EQ(bus_.count(kJoint), 0);
}

TEST_F(ReleaseTest, ATimeOffTheBusDuringTheReleaseDoesNotStopTheJointsAgain) {
  run_until(kCycle_ns);
  stop();
  run_until((now_ns_ / kSlot_ns + 1) * kSlot_ns + 5 * kMillisecond_ns);
  push(Kind::release);
  run_until(now_ns_ + 6 * kMillisecond_ns);  // every joint has confirmed it, but the slot is not over
  controller_.on_bus_state(can::BusState::bus_off, {256, 0}, now_ns_);
  controller_.on_bus_state(can::BusState::error_active, {0, 0}, now_ns_);
  EXPECT_EQ(outcome(), Reason::none);
  run_until(now_ns_ + 2 * kSlot_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  expect_all(can::JointState::holding);
}

TEST_F(ReleaseTest, AMessageControllerThatFindsTheJointsStoppedReleasesThem) {
  run_until(kCycle_ns);
  stop();
  msgclient::MemoryBlock block;
  msgclient::EmiAdapter adapter{block};
  msgclient::Client client = block.local_client("message_controller");
  MessageController restarted{robot_, client, adapter.message()};
  const auto run_slots = [&](int slots) {
    for (const std::int64_t end_ns = now_ns_ + slots * kSlot_ns; now_ns_ < end_ns;
         now_ns_ += kMillisecond_ns) {
      bus_.millisecond(restarted, now_ns_);
    }
  };
  run_slots(3);
  EXPECT_EQ(restarted.mode(), Mode::emergency_stop);
  ASSERT_TRUE(adapter.host().post(msgclient::UserCommandMail{.sequence = 1, .kind = Kind::release}, now_ns_));
  run_slots(8);
  const auto answer = adapter.host().take_answer(now_ns_);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->verdict, Verdict::accepted);
  EXPECT_EQ(restarted.mode(), Mode::holding);
  expect_all(can::JointState::holding);
}

TEST_F(ReleaseTest, AMovementByHandThatWasStoppedHoldsUpNoBatch) {
  run_until(kCycle_ns);
  const double target = robot_.joints[3].home_rad + 20 * robot_.joints[3].count_rad;
  ASSERT_TRUE(adapter_.host().post(msgclient::UserCommandMail{.sequence = 1,
                                                              .kind = Kind::manual_joint,
                                                              .joint = 3,
                                                              .position = static_cast<float>(target),
                                                              .duration_slots = 250},
                                   now_ns_));
  run_until(now_ns_ + 2 * kMillisecond_ns);
  ASSERT_EQ(adapter_.host().take_answer(now_ns_)->verdict, Verdict::accepted);
  stop();
  push(Kind::release);
  EXPECT_EQ(outcome(), Reason::none);
  EXPECT_EQ(hand_over_where_it_stands(static_cast<std::uint32_t>(now_ns_ / kCycle_ns) + 2), Reason::none);
}

TEST_F(ReleaseTest, TwoReleasesWithAStopBetweenThemAreBothAnswered) {
  run_until(kCycle_ns);
  stop();
  push(Kind::release);
  push(Kind::emergency_stop_hold);
  push(Kind::release);
  run_until(now_ns_ + 10 * kSlot_ns);
  std::map<std::uint32_t, Reason> answers;
  for (UserCommandAnswer answer{}; answers_.read(answer);) {
    answers[answer.number] = static_cast<Reason>(answer.reason);
  }
  EXPECT_EQ(answers, (std::map<std::uint32_t, Reason>{{commands_ - 2, Reason::emergency_stopped},
                                                      {commands_ - 1, Reason::none},
                                                      {commands_, Reason::none}}));
}

TEST_F(ReleaseTest, ABatchThatArrivesLateAfterTheReleaseIsNotPlayed) {
  constexpr std::size_t kJoint = 4;
  can::Frame late;
  bus_.drop = [&late](const can::Frame& frame) {
    const auto trajectory = can::decode_trajectory(can::kFullProfile, frame);
    late = trajectory && trajectory->node == 5 ? frame : late;
    return false;
  };
  hand_over(2);
  push(Kind::emergency_stop_hold);
  EXPECT_EQ(outcome(), Reason::none);
  run_until(2 * kCycle_ns - 7 * kMillisecond_ns);
  push(Kind::release);
  run_until(now_ns_ + kMillisecond_ns);
  ASSERT_EQ(bus_.joint(kJoint).state(), can::JointState::holding);
  bus_.joint(kJoint).on_frame(late, now_ns_);
  every_millisecond = [&] { ASSERT_EQ(bus_.count(kJoint), 0) << "this joint's encoder reads 0"; };
  EXPECT_EQ(outcome(), Reason::none);
  run_until(3 * kCycle_ns);
}

}  // namespace
}  // namespace gaitway::msgcontroller
