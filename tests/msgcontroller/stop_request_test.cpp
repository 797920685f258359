// People's stops, which have a topic of their own: none is refused, however many there are and whatever else
// is asked, and many that wait are obeyed as one.
#include "message_controller_fixture.hpp"

namespace gaitway::msgcontroller {
namespace {

class StopRequestTest : public MessageControllerTest {
 protected:
  void ask(std::uint32_t StopRequest::*kind) {
    ++(asked_.*kind);
    stops_.publish(asked_, now_ns_);
  }
  void millisecond() { run_until(now_ns_ + kMillisecond_ns); }
  StopRequest obeyed() {
    StopRequest answer{};
    EXPECT_TRUE(answers_.read(answer));
    return answer;
  }

  msgclient::Client api_ = block_.local_client("api");
  msgclient::Writer<StopRequest> stops_ = api_.write<StopRequest>("stop_request");
  msgclient::Reader<StopRequest> answers_ = api_.read<StopRequest>("stop_answer");
  StopRequest asked_{};
};

TEST_F(StopRequestTest, AnEmergencyStopIsOnTheBusInItsMillisecondWhileOtherCommandsFillTheirQueue) {
  msgclient::QueueWriter<UserCommand> queue = api_.write_queue<UserCommand>("user_command");
  run_until(kCycle_ns);
  UserCommand move{};
  move.kind = static_cast<std::uint32_t>(msgclient::UserCommandKind::manual_joint);
  while (queue.push(move, now_ns_)) {
  }
  ask(&StopRequest::holds);
  millisecond();
  EXPECT_EQ(bus_.sent[can::MessageKind::emergency_stop], 1);
  EXPECT_EQ(controller_.mode(), Mode::emergency_stop);
  EXPECT_EQ(obeyed().holds, 1U);
}

TEST_F(StopRequestTest, ManyStopsBetweenTwoMillisecondsAreOneAndAllAreAnswered) {
  run_until(kCycle_ns);
  for (int i = 0; i < 5000; ++i) {
    ask(&StopRequest::holds);
    ask(&StopRequest::stops);
  }
  millisecond();
  EXPECT_EQ(bus_.sent[can::MessageKind::emergency_stop], 1);
  EXPECT_EQ(obeyed().holds, 5000U);
  EXPECT_EQ(obeyed().stops, 5000U);
}

TEST_F(StopRequestTest, AStopThatLetsGoIsNotLostAmongThoseThatHold) {
  run_until(kCycle_ns);
  ask(&StopRequest::holds);
  ask(&StopRequest::softs);
  ask(&StopRequest::holds);
  run_until(now_ns_ + 2 * kSlot_ns);
  EXPECT_EQ(bus_.joint(0).state(), can::JointState::soft);
  EXPECT_EQ(obeyed().softs, 1U);
}

TEST_F(StopRequestTest, AFloodOfEmergencyStopsLoadsTheBusNoMoreThanOne) {
  run_until(kCycle_ns);
  for (int ms = 0; ms < 100; ++ms) {
    for (int i = 0; i < 20; ++i) {
      ask(&StopRequest::holds);
    }
    millisecond();
  }
  EXPECT_EQ(bus_.sent[can::MessageKind::emergency_stop], 1);
  ask(&StopRequest::softs);
  millisecond();
  EXPECT_EQ(bus_.sent[can::MessageKind::emergency_stop], 2) << "soft is more than hold";
  EXPECT_EQ(obeyed().holds, 2000U);
}

TEST_F(StopRequestTest, AStopPlaysTheSafeTailToItsEnd) {
  hand_over(2);
  EXPECT_EQ(hand_over(2).reason, msgclient::Reason::old_sequence);
  ask(&StopRequest::stops);
  millisecond();
  EXPECT_EQ(hand_over(3).reason, msgclient::Reason::stopping);
  EXPECT_EQ(controller_.state().refused, 2U);
  EXPECT_EQ(controller_.refused_by_a_stop(), 1U) << "the other one came twice";
  run_until(7 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
}

// A process that takes the API's place writes what was obeyed before it asks for anything.
TEST_F(StopRequestTest, WhatIsWrittenAgainIsNotObeyedAgain) {
  run_until(kCycle_ns);
  stops_.publish(asked_, now_ns_);
  run_until(2 * kCycle_ns);
  EXPECT_EQ(controller_.mode(), Mode::holding);
  EXPECT_EQ(obeyed().holds, 0U);
}

}  // namespace
}  // namespace gaitway::msgcontroller
