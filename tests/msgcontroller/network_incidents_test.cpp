// What the message controller does about a bus that is not as it should be: foreign frames, silent joints, a
// bus that goes off, stops that do not arrive.
#include <random>

#include "message_controller_fixture.hpp"

namespace gaitway::msgcontroller {
namespace {

using can::kFullProfile;
using can::MessageKind;

class NetworkIncidents : public MessageControllerTest {
 protected:
  // Walks into the batch of cycle 2.
  void start_moving() {
    ASSERT_EQ(hand_over(2, 40).verdict, Verdict::accepted);
    run_until(2 * kCycle_ns + 2 * kSlot_ns + kMillisecond_ns);
  }
  void intrude(const can::Frame& frame) { bus_.intrude(controller_, frame, now_ns_); }
  // Within one time slot the topic tells.
  void expect_reported(Incident incident, can::NodeId node) {
    EXPECT_EQ(controller_.health().last_incident, static_cast<std::uint32_t>(incident));
    EXPECT_EQ(controller_.health().last_incident_node, node);
  }
  void expect_safe_stop() {
    EXPECT_EQ(hand_over(3).reason, msgclient::Reason::stopping);
    run_until(9 * kCycle_ns);
    EXPECT_EQ(controller_.mode(), Mode::holding);
    expect_moved(28);  // the batch and its whole tail, which goes on half as fast
  }
  const NetworkHealth& health() { return controller_.health(); }
};

TEST_F(NetworkIncidents, AnUnknownIdentifierIsCountedAndDisturbsNothing) {
  start_moving();
  intrude({.id = 0x7AB, .size = 8, .data = {1, 2, 3}});
  EXPECT_EQ(health().unknown_identifiers, 1U);
  expect_reported(Incident::unknown_identifier, 0);
  EXPECT_EQ(hand_over(3).verdict, Verdict::accepted);
}

TEST_F(NetworkIncidents, ANodeThatNoJointHasIsUnknown) {
  intrude(can::encode(kFullProfile, can::Feedback{.node = 40}));
  EXPECT_EQ(health().unknown_identifiers, 1U);
}

TEST_F(NetworkIncidents, EachMalformedFrameHasItsOwnCounter) {
  start_moving();
  can::Frame feedback = can::encode(kFullProfile, can::Feedback{.node = 5});
  feedback.size = 7;
  intrude(feedback);
  EXPECT_EQ(health().wrong_lengths, 1U);
  expect_reported(Incident::wrong_length, 5);
  feedback = can::encode(kFullProfile, can::Feedback{.node = 6});
  feedback.remote = true;
  intrude(feedback);
  EXPECT_EQ(health().remote_frames, 1U);
  expect_reported(Incident::remote_frame, 6);
  intrude({.id = 0x1234'567, .size = 0, .extended = true});
  EXPECT_EQ(health().extended_frames, 1U);
  EXPECT_EQ(health().unknown_identifiers + health().forged, 0U) << "one cause each";
  EXPECT_EQ(hand_over(3).verdict, Verdict::accepted);
}

TEST_F(NetworkIncidents, AForgedTrajectoryEndsInASafeStopAndIsPutRightBeforeItPlays) {
  start_moving();
  ASSERT_EQ(hand_over(3, 40).verdict, Verdict::accepted);
  for (const bool toggle : {false, true}) {  // whichever the batch has that waits
    intrude(can::encode(kFullProfile, can::Trajectory{5, toggle, {100, 100, 100, 100, 100, 100, 100, 100}}));
  }
  EXPECT_EQ(health().forged, 2U);
  expect_reported(Incident::forged, 5);
  run_until(3 * kCycle_ns + 7 * kSlot_ns + 5 * kMillisecond_ns);
  expect_moved(16);
  EXPECT_EQ(hand_over(4).reason, msgclient::Reason::stopping);
}

TEST_F(NetworkIncidents, AForgedUserCommandEndsInASafeStop) {
  start_moving();
  intrude(can::encode(kFullProfile, can::UserCommand{3, 1000, 1}));
  EXPECT_EQ(health().forged, 1U);
  expect_safe_stop();
}

TEST_F(NetworkIncidents, AForgedResynchronisationIsUndoneInTheNextSlotAndEndsInASafeStop) {
  start_moving();
  for (const bool toggle : {false, true}) {
    intrude(can::encode(kFullProfile, can::Resynchronisation{5, toggle, 3, 500, {}}));
  }
  run_until(2 * kCycle_ns + 5 * kSlot_ns + 5 * kMillisecond_ns);
  expect_moved(6);
  expect_safe_stop();
}

TEST_F(NetworkIncidents, AForgedEmergencyStopIsTakenForWhatItIs) {
  start_moving();
  intrude(can::encode(kFullProfile, can::EmergencyStop{can::StopMode::hold}));
  EXPECT_EQ(controller_.mode(), Mode::emergency_stop);
  EXPECT_EQ(health().forged, 1U);
}

TEST_F(NetworkIncidents, AFrameThatTheBusDeliversTwiceIsCountedAndHarmless) {
  start_moving();
  can::Frame last;
  bus_.drop_from_joint = [&](const can::Frame& frame) {
    last = kFullProfile.identify(frame.id)->node == 5 ? frame : last;
    return false;
  };
  run_until(now_ns_ + kSlot_ns);
  bus_.intrude(controller_, last, now_ns_);
  EXPECT_EQ(health().doubled, 1U);
  EXPECT_EQ(health().second_senders, 0U);
  EXPECT_EQ(hand_over(3).verdict, Verdict::accepted);
}

TEST_F(NetworkIncidents, ASecondNodeWithTheSameIdentifierIsReportedAtOnceAndStopsTheRobot) {
  start_moving();
  every_millisecond = [&] {
    if (now_ns_ % kSlot_ns == 5 * kMillisecond_ns) {
      controller_.on_frame(can::encode(kFullProfile, can::Feedback{.node = 5, .position = 77}), now_ns_);
    }
  };
  run_until(now_ns_ + kSlot_ns);
  EXPECT_EQ(health().second_senders, 1U);
  run_until(now_ns_ + 3 * kSlot_ns);
  every_millisecond = nullptr;
  EXPECT_EQ(hand_over(3).reason, msgclient::Reason::stopping);
}

TEST_F(NetworkIncidents, FeedbackThatArrivesASlotLateIsNoSecondNode) {
  start_moving();
  std::vector<can::Frame> delayed;
  bool hold_back = true;
  bus_.drop_from_joint = [&](const can::Frame& frame) {
    if (hold_back) {
      delayed.push_back(frame);
    }
    return hold_back;
  };
  every_millisecond = [&] {  // every other slot's feedback comes at the beginning of the next one
    if (now_ns_ % kSlot_ns == 9 * kMillisecond_ns) {
      hold_back = !hold_back;
    }
    if (now_ns_ % kSlot_ns == 0) {
      for (const can::Frame& frame : delayed) {
        controller_.on_frame(frame, now_ns_);
      }
      delayed.clear();
    }
  };
  run_until(now_ns_ + 20 * kSlot_ns);
  EXPECT_EQ(health().second_senders, 0U);
  EXPECT_EQ(health().doubled, 0U);
}

TEST_F(NetworkIncidents, ASilentNodeIsNamedWithinTwoSlotsAndItsReturnIsSeen) {
  start_moving();
  run_until(2 * kCycle_ns + 3 * kSlot_ns + 5 * kMillisecond_ns);
  bus_.drop_from_joint = [](const can::Frame& frame) { return kFullProfile.identify(frame.id)->node == 19; };
  run_until(2 * kCycle_ns + 6 * kSlot_ns + kMillisecond_ns);  // silent in slots 4 and 5
  const auto joint = static_cast<unsigned>(*robot_.joint_of_node(19));
  EXPECT_EQ(health().missing, std::uint64_t{1} << joint);
  EXPECT_EQ(health().feedback_missing, 1U);
  expect_reported(Incident::feedback_missing, 19);
  bus_.drop_from_joint = [](const can::Frame&) { return false; };
  run_until(2 * kCycle_ns + 7 * kSlot_ns + kMillisecond_ns);
  EXPECT_EQ(health().missing, 0U);
  EXPECT_EQ(health().nodes_returned, 1U);
  EXPECT_EQ(hand_over(3).verdict, Verdict::accepted) << "an arm's joint";
}

TEST_F(NetworkIncidents, ALegsJointThatStaysSilentStopsTheRobot) {
  start_moving();
  bus_.drop_from_joint = [](const can::Frame& frame) { return kFullProfile.identify(frame.id)->node == 4; };
  hand_over(3, 40);
  run_until(4 * kCycle_ns - 20 * kMillisecond_ns);
  EXPECT_EQ(hand_over(4).reason, msgclient::Reason::stopping);
}

TEST_F(NetworkIncidents, ARestartedJointIsBroughtBackToItsCountWithinTwoSlots) {
  start_moving();
  localcontroller::JointConfig config;
  config.node = robot_.joints[4].node;
  config.count_rad = robot_.joints[4].count_rad;
  config.encoder_count_rad = robot_.joints[4].encoder_count_rad;
  config.lower_rad = robot_.joints[4].lower_rad;
  config.upper_rad = robot_.joints[4].upper_rad;
  config.initial_reference_count = bus_.count(4) + 3;  // where its encoder says that it is
  bus_.joint(4) = localcontroller::JointController(config);
  run_until(2 * kCycle_ns + 5 * kSlot_ns + 5 * kMillisecond_ns);
  expect_moved(6);
  EXPECT_EQ(health().nodes_restarted, 1U);
  run_until(2 * kCycle_ns + 7 * kSlot_ns + 5 * kMillisecond_ns);
  expect_moved(8);
}

TEST_F(NetworkIncidents, OffTheBusNothingWaitsAndBackOnItThePreparedBatchIsSentAgain) {
  start_moving();
  run_until(3 * kCycle_ns - 16 * kMillisecond_ns);
  controller_.on_bus_state(can::BusState::bus_off, {256, 0}, now_ns_);
  const auto mail = std::make_unique<msgclient::HandOver>(batch(3));
  ASSERT_TRUE(adapter_.host().post(*mail, now_ns_));
  run_until(now_ns_ + 4 * kMillisecond_ns);
  EXPECT_TRUE(controller_.queue().empty());
  EXPECT_EQ(health().bus_offs, 1U);
  EXPECT_GE(health().flushed, robot_.joints.size());
  controller_.on_bus_state(can::BusState::error_active, {0, 0}, now_ns_);
  run_until(3 * kCycle_ns + 5 * kMillisecond_ns);
  expect_moved(9);
}

TEST_F(NetworkIncidents, WhatWaitsWhenTheBusGoesOffIsDroppedAndCounted) {
  start_moving();
  run_until(2 * kCycle_ns + 3 * kSlot_ns);
  controller_.step(now_ns_);  // its SYNC waits
  ASSERT_FALSE(controller_.queue().empty());
  controller_.on_bus_state(can::BusState::bus_off, {256, 0}, now_ns_);
  EXPECT_TRUE(controller_.queue().empty()) << "it would go out stale";
  EXPECT_GE(health().flushed, 1U);
}

TEST_F(NetworkIncidents, AJointThatDidNotHearTheEmergencyStopIsStoppedInTheNextSlot) {
  start_moving();
  int lost = 0;
  bus_.drop = [&](const can::Frame& frame) {
    return kFullProfile.identify(frame.id)->kind == MessageKind::emergency_stop && lost++ == 0;
  };
  command(msgclient::UserCommandKind::emergency_stop_hold);
  run_until(now_ns_ + 2 * kSlot_ns);
  for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
    EXPECT_EQ(bus_.joint(joint).state(), can::JointState::stopped) << joint;
  }
  EXPECT_GE(health().stops_repeated, 1U);
  const int sent = bus_.sent[MessageKind::emergency_stop];
  run_until(now_ns_ + 4 * kSlot_ns);
  EXPECT_EQ(bus_.sent[MessageKind::emergency_stop], sent) << "everybody has confirmed it";
}

TEST_F(NetworkIncidents, AFrameThatCannotBeSentInItsTimeIsDropped) {
  start_moving();
  for (int ms = 0; ms < 25; ++ms) {  // nobody takes frames: the bus is busy
    controller_.step(now_ns_);
    now_ns_ += kMillisecond_ns;
  }
  EXPECT_GE(health().expired, 1U);
  int syncs = 0;
  can::Frame frame;
  while (controller_.take_frame(frame)) {
    syncs += kFullProfile.identify(frame.id)->kind == MessageKind::sync ? 1 : 0;
  }
  EXPECT_EQ(syncs, 1) << "two SYNCs would set the joints' clocks wrong";
}

// One joint at a time hears nothing that is meant for it for 18 ms, so that a frame and its repetition are
// lost, and sometimes the first repair. Then it is right again two slots later at the latest.
TEST_F(NetworkIncidents, NoJointIsWrongForMoreThanTwoSlotsAfterItHearsAgain) {
  constexpr std::int64_t kDeaf_ns = 18 * kMillisecond_ns;
  std::mt19937 random(11);
  std::int64_t deaf_from_ns = 0;
  can::NodeId deaf_node = 1;
  bus_.drop = [&](const can::Frame& frame) {
    const auto heard = kFullProfile.identify(frame.id);
    const bool meant_for_it =
        heard->kind == MessageKind::trajectory || heard->kind == MessageKind::resynchronisation;
    return meant_for_it && heard->node == deaf_node && now_ns_ < deaf_from_ns + kDeaf_ns &&
           now_ns_ >= deaf_from_ns;
  };
  std::vector<int> wrong_slots(bus_.size(), 0);
  int wrong_joints = 0;
  every_millisecond = [&] {
    if (now_ns_ >= deaf_from_ns + kDeaf_ns + 3 * kSlot_ns) {
      deaf_from_ns = now_ns_ + static_cast<std::int64_t>(random() % 30) * kMillisecond_ns;
      deaf_node = static_cast<can::NodeId>(1 + random() % 22);
    }
    if (now_ns_ % kSlot_ns != 9 * kMillisecond_ns) {
      return;
    }
    const bool deaf = now_ns_ >= deaf_from_ns && now_ns_ < deaf_from_ns + kDeaf_ns;
    for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
      const bool wrong = bus_.count(joint) != controller_.expected_count(static_cast<int>(joint));
      wrong_slots[joint] = wrong && !deaf ? wrong_slots[joint] + 1 : 0;
      wrong_joints += wrong ? 1 : 0;
      ASSERT_LE(wrong_slots[joint], 2) << "joint " << joint << " at " << now_ns_;
    }
  };
  for (std::uint32_t sequence = 2; sequence < 42; ++sequence) {
    ASSERT_EQ(hand_over(sequence).verdict, Verdict::accepted) << sequence;
  }
  EXPECT_GT(wrong_joints, 5);
}

class PaperNetwork : public MessageControllerTest {
 protected:
  PaperNetwork() : MessageControllerTest("paper") {}
  // The twelve leg joints by one count a point.
  msgclient::HandOver leg_batch(std::uint32_t sequence) {
    msgclient::HandOver plan = batch(sequence);
    for (int point = 0; point < static_cast<int>(plan.point_count); ++point) {
      for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
        if (robot_.joints[joint].node > 12) {
          plan.set_position(point, static_cast<int>(joint),
                            static_cast<float>(robot_.joints[joint].home_rad));
        }
      }
    }
    return plan;
  }
  msgclient::Answer hand_over_plan(std::uint32_t sequence, const msgclient::HandOver& plan) {
    run_until(std::int64_t{sequence} * kCycle_ns - 16 * kMillisecond_ns);
    EXPECT_TRUE(adapter_.host().post(plan, now_ns_));
    run_until(now_ns_ + 3 * kMillisecond_ns);
    return adapter_.host().take_answer(now_ns_).value_or(msgclient::Answer{.verdict = Verdict::corrupt});
  }
};

TEST_F(PaperNetwork, SendsTheBatchWhereItStartsAndNothingElse) {
  ASSERT_EQ(hand_over_plan(2, leg_batch(2)).verdict, Verdict::accepted);
  EXPECT_TRUE(bus_.sent.empty());
  run_until(2 * kCycle_ns + 7 * kSlot_ns + 5 * kMillisecond_ns);
  EXPECT_EQ(bus_.sent, (std::map<MessageKind, int>{{MessageKind::trajectory, 12}}));
  for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
    EXPECT_EQ(bus_.count(joint) - JointsOnABus::home_count(robot_.joints[joint]),
              robot_.joints[joint].node <= 12 ? 8 : 0);
  }
  EXPECT_EQ(controller_.health().missing, 0U);
}

TEST_F(PaperNetwork, RefusesAMovementOfAJointThatIsNotOnTheBus) {
  const auto answer = hand_over_plan(2, batch(2));
  EXPECT_EQ(answer.verdict, Verdict::refused);
  EXPECT_EQ(answer.reason, msgclient::Reason::node_fault);
  EXPECT_GT(robot_.joints[static_cast<std::size_t>(answer.joint)].node, 12);
}

TEST_F(PaperNetwork, ALostTrajectoryIsMadeUpForWithinTheBatch) {
  int lost = 0;
  bus_.drop = [&](const can::Frame& frame) { return frame.id == 5 && lost++ == 0; };
  ASSERT_EQ(hand_over_plan(2, leg_batch(2)).verdict, Verdict::accepted);
  ASSERT_EQ(hand_over_plan(3, leg_batch(3)).verdict, Verdict::accepted);
  run_until(3 * kCycle_ns + 7 * kSlot_ns + 5 * kMillisecond_ns);
  const auto joint = static_cast<std::size_t>(*robot_.joint_of_node(5));
  EXPECT_EQ(bus_.count(joint) - JointsOnABus::home_count(robot_.joints[joint]), 16);
  EXPECT_EQ(controller_.state().resynchronised, 1U);
}

TEST_F(PaperNetwork, TheEmergencyStopIsAUserCommandToAllNodes) {
  ASSERT_EQ(hand_over_plan(2, leg_batch(2)).verdict, Verdict::accepted);
  run_until(2 * kCycle_ns + 2 * kSlot_ns);
  command(msgclient::UserCommandKind::emergency_stop_soft);
  run_until(now_ns_ + kSlot_ns);
  for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
    if (robot_.joints[joint].node <= 12) {
      EXPECT_EQ(bus_.joint(joint).state(), can::JointState::soft) << joint;
    }
  }
}

TEST_F(PaperNetwork, AForgedEmergencyStopHoldsAndAForgedMovementEndsInASafeStop) {
  ASSERT_EQ(hand_over_plan(2, leg_batch(2)).verdict, Verdict::accepted);
  run_until(2 * kCycle_ns + 2 * kSlot_ns);
  const auto forge = [this](can::NodeId node) {
    const can::UserCommand command{.node = node,
                                   .target_count = static_cast<std::int16_t>(can::StopMode::hold)};
    bus_.intrude(controller_, can::encode(controller_.profile(), command), now_ns_);
  };
  forge(5);
  EXPECT_NE(controller_.mode(), Mode::emergency_stop);
  EXPECT_EQ(hand_over_plan(3, leg_batch(3)).reason, msgclient::Reason::stopping);
  forge(0);
  EXPECT_EQ(controller_.mode(), Mode::emergency_stop);
}

}  // namespace
}  // namespace gaitway::msgcontroller
