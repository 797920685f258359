// Requests in by topics, commands out: who is obeyed, what ends when somebody takes over, and that nothing of
// the past is obeyed later.
#include "gaitway/msgcontroller/command_arbiter.hpp"

#include <cstring>
#include <limits>
#include <string>
#include <string_view>

#include "gaitway/facts/facts.hpp"
#include "message_controller_fixture.hpp"

namespace gaitway::msgcontroller {
namespace {

namespace commanders = command_state::commander;
namespace sources = command_state::in_force;

class CommandArbiterTest : public testing::Test {
 protected:
  static constexpr double kPersons = 0.1, kBehaviours = 0.2;  // m/s

  void milliseconds(int count = 1) {
    for (int i = 0; i < count; ++i) {
      now_ns_ += facts::kMillisecond_ns;
      passed_ = arbiter_.step(now_ns_, emergency_);
    }
  }
  static WalkCommand walk(double forward_m_per_s, std::int64_t valid_until_ns = 0) {
    WalkCommand result{};
    result.walk = 1;
    result.velocity[0] = forward_m_per_s;
    result.valid_until_ns = valid_until_ns;
    return result;
  }
  void behaviour_walks() {
    behaviour_walk_.publish(walk(kBehaviours, now_ns_ + 500 * facts::kMillisecond_ns), now_ns_);
    milliseconds();
  }
  void person_walks() {
    person_walk_.publish(walk(kPersons), now_ns_);
    milliseconds();
  }
  void ask(std::uint32_t verb) {
    CommandRequest request{};
    request.number = ++number_;
    request.verb = verb;
    requests_.publish(request, now_ns_);
    milliseconds();
  }
  void stop(std::uint32_t StopRequest::*kind = &StopRequest::stops) {
    ++(stops_.*kind);
    stop_requests_.publish(stops_, now_ns_);
    milliseconds();
  }
  void play(msgclient::Writer<MotionRequest>& by, std::uint32_t number, std::string_view name) {
    MotionRequest motion{};
    motion.number = number;
    std::memcpy(motion.name, name.data(), name.size());
    by.publish(motion, now_ns_);
    milliseconds();
  }
  void go(msgclient::Writer<WalkToRequest>& by, std::uint32_t number) {
    WalkToRequest way{};
    way.number = number;
    way.goal[0] = number;
    by.publish(way, now_ns_);
    milliseconds();
  }
  void fall(std::uint32_t how) {
    Estimate estimate{};
    estimate.fall = how;
    estimates_.publish(estimate, now_ns_);
    milliseconds();
  }

  [[nodiscard]] double walks_with() {
    WalkCommand command{};
    EXPECT_TRUE(walk_commands_.read(command));
    return command.walk != 0 ? command.velocity[0] : 0.0;
  }
  [[nodiscard]] WalkToRequest way() {
    WalkToRequest command{};
    static_cast<void>(way_commands_.read(command));
    return command;
  }
  [[nodiscard]] std::string motion() {
    MotionRequest command{};
    static_cast<void>(motion_commands_.read(command));
    return reinterpret_cast<const char*>(command.name);
  }
  [[nodiscard]] CommandState state() {
    CommandState result{};
    EXPECT_TRUE(states_.read(result));
    return result;
  }

  msgclient::MemoryBlock block_;
  msgclient::Client arbiter_client_ = block_.local_client("arbiter");
  msgclient::Client api_ = block_.local_client("api");
  msgclient::Client behaviour_ = block_.local_client("behaviour");
  msgclient::Client robot_ = block_.local_client("robot");
  CommandArbiter arbiter_{arbiter_client_};
  msgclient::Writer<WalkCommand> person_walk_ = api_.write<WalkCommand>("walk_request");
  msgclient::Writer<WalkToRequest> person_way_ = api_.write<WalkToRequest>("walk_to_request");
  msgclient::Writer<MotionRequest> person_motion_ = api_.write<MotionRequest>("motion_request");
  msgclient::Writer<HeadCommand> person_head_ = api_.write<HeadCommand>("head_request");
  msgclient::Writer<CommandRequest> requests_ = api_.write<CommandRequest>("command_request");
  msgclient::Writer<StopRequest> stop_requests_ = api_.write<StopRequest>("stop_request");
  msgclient::Writer<WalkCommand> behaviour_walk_ = behaviour_.write<WalkCommand>("behaviour_walk");
  msgclient::Writer<WalkToRequest> behaviour_way_ = behaviour_.write<WalkToRequest>("behaviour_walk_to");
  msgclient::Writer<MotionRequest> behaviour_motion_ = behaviour_.write<MotionRequest>("behaviour_motion");
  msgclient::Writer<HeadCommand> behaviour_head_ = behaviour_.write<HeadCommand>("behaviour_head");
  msgclient::Writer<Estimate> estimates_ = robot_.write<Estimate>("estimate");
  msgclient::Writer<NavigationState> ways_ = robot_.write<NavigationState>("navigation_state");
  msgclient::Writer<MotionState> motions_ = robot_.write<MotionState>("motion_state");
  msgclient::Reader<WalkCommand> walk_commands_ = robot_.read<WalkCommand>("walk_command");
  msgclient::Reader<WalkToRequest> way_commands_ = robot_.read<WalkToRequest>("walk_to_command");
  msgclient::Reader<MotionRequest> motion_commands_ = robot_.read<MotionRequest>("motion_command");
  msgclient::Reader<HeadCommand> head_commands_ = robot_.read<HeadCommand>("head_command");
  msgclient::Reader<CommandState> states_ = robot_.read<CommandState>("command_state");
  std::int64_t now_ns_ = 0;
  bool emergency_ = false;
  PassedOrders passed_;
  StopRequest stops_{};
  std::uint32_t number_ = 0;
};

TEST_F(CommandArbiterTest, NobodyCommandsAtFirstAndTheRobotStands) {
  milliseconds();
  EXPECT_EQ(walks_with(), 0.0);
  EXPECT_EQ(state().commander, commanders::nobody);
}

TEST_F(CommandArbiterTest, TheBehaviourIsObeyedUntilAPersonGivesAnOrderAndAgainWhenTheyLetGo) {
  behaviour_walks();
  EXPECT_EQ(walks_with(), kBehaviours);
  EXPECT_EQ(state().in_force[0], sources::behaviour);
  person_walks();
  EXPECT_EQ(walks_with(), kPersons);
  behaviour_walks();
  EXPECT_EQ(walks_with(), kPersons);
  milliseconds(200);
  EXPECT_EQ(state().turned_away, 1U);
  ask(command_request::verb::let_go);
  EXPECT_EQ(walks_with(), 0.0) << "what the behaviour wanted meanwhile does not count";
  EXPECT_EQ(state().answered, number_);
  behaviour_walks();
  EXPECT_EQ(walks_with(), kBehaviours);
}

TEST_F(CommandArbiterTest, APersonWhoTakesTheCommandEndsAllThatTheBehaviourHasOrdered) {
  go(behaviour_way_, 0x8000'0001U);
  play(behaviour_motion_, 0x8000'0002U, "wave");
  behaviour_walks();
  ask(command_request::verb::take);
  EXPECT_EQ(walks_with(), 0.0);
  EXPECT_EQ(way().cancel, 1U);
  EXPECT_EQ(motion(), "");
  EXPECT_EQ(state().commander, commanders::person);
}

TEST_F(CommandArbiterTest, AnOrderOfAPersonLeavesTheirOtherOrdersAlone) {
  HeadCommand look{};
  look.mode = head_command::mode::direction;
  look.direction[0] = 0.5;
  person_head_.publish(look, now_ns_);
  milliseconds();
  person_walks();
  EXPECT_EQ(walks_with(), kPersons);
  HeadCommand looks{};
  ASSERT_TRUE(head_commands_.read(looks));
  EXPECT_EQ(looks.direction[0], 0.5);
  EXPECT_EQ(state().in_force[3], sources::person);
}

TEST_F(CommandArbiterTest, AStopEndsEverythingAndOutlastsWhatTheBehaviourAsks) {
  go(behaviour_way_, 0x8000'0001U);
  stop();
  EXPECT_EQ(way().cancel, 1U);
  for (int i = 0; i < 50; ++i) {
    behaviour_walks();
    ASSERT_EQ(walks_with(), 0.0);
  }
  go(behaviour_way_, 0x8000'0002U);
  EXPECT_EQ(way().cancel, 1U);
  EXPECT_EQ(state().reason, command_state::reason::person_stops);
}

TEST_F(CommandArbiterTest, WhatLiesThereWhenAStopIsHeardIsNotObeyedAfterIt) {
  WalkToRequest there{};
  there.number = 7;
  there.goal[0] = 1.0;
  person_way_.publish(there, now_ns_);
  person_walk_.publish(walk(kPersons), now_ns_);
  CommandRequest let_go{};
  let_go.number = 1;
  let_go.verb = command_request::verb::let_go;
  requests_.publish(let_go, now_ns_);
  ++stops_.stops;
  stop_requests_.publish(stops_, now_ns_);
  milliseconds(5);
  EXPECT_EQ(walks_with(), 0.0);
  EXPECT_EQ(way_commands_.newest_sequence(), 0U);
  EXPECT_EQ(state().reason, command_state::reason::person_stops);
  behaviour_walks();
  EXPECT_EQ(walks_with(), 0.0);
}

TEST_F(CommandArbiterTest,
       AnEmergencyStopThatWasHeardIsInForceUntilTheMessageControllerHasObeyedAndReleased) {
  ++stops_.holds;
  stop_requests_.publish(stops_, now_ns_);
  milliseconds(3);  // as a process that wakes up more often than once a millisecond
  EXPECT_EQ(state().commander, commanders::emergency_stop);
  emergency_ = true;
  milliseconds();
  emergency_ = false;
  milliseconds();
  EXPECT_EQ(state().reason, command_state::reason::emergency_stop_released);
}

TEST_F(CommandArbiterTest, AMotionThatPlaysOnWhenAnotherIsRefusedIsEndedByWhoTakesOver) {
  play(behaviour_motion_, 0x8000'0001U, "wave");
  play(behaviour_motion_, 0x8000'0002U, "bow");
  MotionState plays{};
  plays.answered = 0x8000'0002U;
  plays.refused = 1;
  plays.state = 2;
  motions_.publish(plays, now_ns_);
  milliseconds();
  ask(command_request::verb::take);
  EXPECT_EQ(motion(), "");
}

TEST_F(CommandArbiterTest, AStickThatIsHeldOrLetGoDoesNotBreakOffGettingUp) {
  person_walks();
  fall(estimate::fall::lies);
  play(behaviour_motion_, 0x8000'0001U, "get_up_front");
  fall(estimate::fall::upright);  // the motion still plays
  person_walks();
  EXPECT_EQ(walks_with(), 0.0);
  person_walk_.publish(WalkCommand{}, now_ns_);
  milliseconds();
  EXPECT_EQ(motion(), "get_up_front");
  play(person_motion_, 5, "");
  EXPECT_EQ(motion(), "") << "who leaves it means it";
}

TEST_F(CommandArbiterTest, AStopHoldsTheHeadWhereverItIsOnItsWayTo) {
  for (const std::uint32_t mode : {head_command::mode::direction, head_command::mode::ahead}) {
    HeadCommand look{};
    look.mode = mode;
    look.direction[0] = 1.0;
    person_head_.publish(look, now_ns_);
    milliseconds();
    stop();
    HeadCommand now{};
    ASSERT_TRUE(head_commands_.read(now));
    EXPECT_EQ(now.mode, head_command::mode::hold);
  }
}

TEST_F(CommandArbiterTest, ALookOfNoKnownModeIsNone) {
  HeadCommand look{};
  look.mode = head_command::mode::hold + 1;
  behaviour_head_.publish(look, now_ns_);
  milliseconds();
  EXPECT_EQ(head_commands_.newest_sequence(), 0U);
}

TEST_F(CommandArbiterTest, WhoCommandedBeforePeopleCameIsNotLostWithTheirComing) {
  go(person_way_, 3);
  arbiter_.begin_anew_with_people(now_ns_ + 500 * facts::kMillisecond_ns);
  ask(command_request::verb::is_lost);  // as the API's plug-in says when it begins
  EXPECT_EQ(way().cancel, 0U);
  ask(command_request::verb::is_lost);
  EXPECT_EQ(way().cancel, 1U);
}

TEST_F(CommandArbiterTest, AStandAfterAStopIsNoOrderToGoOn) {
  person_walks();
  stop();
  person_walk_.publish(WalkCommand{}, now_ns_);  // as programs send it after a stop
  milliseconds();
  EXPECT_EQ(state().reason, command_state::reason::person_stops);
  fall(estimate::fall::falls);
  EXPECT_EQ(state().may_get_up, 0U);
}

TEST_F(CommandArbiterTest, AnOrderAndItsLettingGoInOneMillisecondLeaveNobodyInCommand) {
  person_walks();
  play(person_motion_, 7, "wave");
  MotionRequest leave{};
  leave.number = 8;
  person_motion_.publish(leave, now_ns_);
  ask(command_request::verb::let_go);
  EXPECT_EQ(state().commander, commanders::nobody);
}

TEST_F(CommandArbiterTest, AStandTakesTheCommandFromTheBehaviour) {
  behaviour_walks();
  person_walk_.publish(WalkCommand{}, now_ns_);
  milliseconds();
  EXPECT_EQ(walks_with(), 0.0);
  behaviour_walks();
  EXPECT_EQ(walks_with(), 0.0);
}

TEST_F(CommandArbiterTest, NobodyIsObeyedDuringAnEmergencyStopAndNothingGoesOnAfterIt) {
  person_walks();
  emergency_ = true;
  milliseconds();
  EXPECT_EQ(walks_with(), 0.0);
  EXPECT_EQ(state().commander, commanders::emergency_stop);
  person_walks();
  ask(command_request::verb::let_go);
  behaviour_walks();
  EXPECT_EQ(walks_with(), 0.0);
  emergency_ = false;
  milliseconds(100);
  EXPECT_EQ(walks_with(), 0.0);
  EXPECT_EQ(state().reason, command_state::reason::emergency_stop_released);
  behaviour_walks();
  EXPECT_EQ(walks_with(), 0.0);
  person_walks();
  EXPECT_EQ(walks_with(), kPersons);
}

TEST_F(CommandArbiterTest, AnEmergencyStopThatIsAskedForCountsBeforeTheMessageControllerHasObeyed) {
  behaviour_walks();
  ++stops_.holds;
  stop_requests_.publish(stops_, now_ns_);
  behaviour_walk_.publish(walk(kBehaviours), now_ns_);
  person_walk_.publish(walk(kPersons), now_ns_);
  milliseconds();
  EXPECT_EQ(walks_with(), 0.0);
  EXPECT_EQ(state().commander, commanders::emergency_stop);
}

TEST_F(CommandArbiterTest, AStopThatComesThroughMailboxOrQueueIsTold) {
  behaviour_walks();
  arbiter_.on_command(msgclient::UserCommandKind::stop, now_ns_);
  EXPECT_EQ(walks_with(), 0.0) << "at once, not in the next millisecond";
  behaviour_walks();
  EXPECT_EQ(walks_with(), 0.0);
}

TEST_F(CommandArbiterTest, AJointMovedByHandTakesTheCommand) {
  behaviour_walks();
  arbiter_.on_command(msgclient::UserCommandKind::manual_joint, now_ns_);
  milliseconds();
  EXPECT_EQ(walks_with(), 0.0);
  EXPECT_EQ(state().reason, command_state::reason::person_moves_joint);
}

TEST_F(CommandArbiterTest, WhenThePersonIsLostTheRobotStandsAndTheBehaviourStaysOut) {
  person_walks();
  ask(command_request::verb::is_lost);
  EXPECT_EQ(walks_with(), 0.0);
  EXPECT_EQ(state().reason, command_state::reason::person_is_lost);
  behaviour_walks();
  EXPECT_EQ(walks_with(), 0.0);
}

TEST_F(CommandArbiterTest, APersonWhoNeverCommandedIsNotLost) {
  ask(command_request::verb::is_lost);
  behaviour_walks();
  EXPECT_EQ(walks_with(), kBehaviours);
}

TEST_F(CommandArbiterTest, AWalkThatIsNotRenewedEnds) {
  behaviour_walks();
  milliseconds(520);
  EXPECT_EQ(walks_with(), 0.0);
  person_walk_.publish(walk(kPersons, now_ns_ + 10 * facts::kMillisecond_ns), now_ns_);
  milliseconds(5);
  EXPECT_EQ(walks_with(), kPersons);
  milliseconds(5);
  EXPECT_EQ(walks_with(), 0.0);
  EXPECT_TRUE(passed_.walk) << "a log that plays it again has its end";
  EXPECT_EQ(state().commander, commanders::person);
}

TEST_F(CommandArbiterTest, ABehaviourWhoseOrdersHaveEndedCommandsNoMore) {
  go(behaviour_way_, 0x8000'0001U);
  NavigationState navigation{};
  navigation.answered = 0x8000'0001U;
  navigation.result = navigation_state::result::arrived;
  ways_.publish(navigation, now_ns_);
  milliseconds(500);
  EXPECT_EQ(state().commander, commanders::behaviour) << "it may think";
  milliseconds(600);
  EXPECT_EQ(state().commander, commanders::nobody);
}

TEST_F(CommandArbiterTest, AfterAFallUnderAPersonTheBehavioursMotionsAreObeyedAndNothingElseOfIt) {
  person_walks();
  fall(estimate::fall::falls);
  EXPECT_EQ(walks_with(), 0.0);
  fall(estimate::fall::lies);
  behaviour_walks();
  EXPECT_EQ(walks_with(), 0.0);
  play(behaviour_motion_, 0x8000'0001U, "get_up_front");
  EXPECT_EQ(motion(), "get_up_front");
  EXPECT_EQ(state().commander, commanders::person);
  fall(estimate::fall::upright);
  EXPECT_EQ(motion(), "get_up_front");
  MotionState ended{};
  ended.answered = 0x8000'0001U;
  motions_.publish(ended, now_ns_);
  milliseconds();
  EXPECT_EQ(state().may_get_up, 0U);
  play(behaviour_motion_, 0x8000'0002U, "wave");
  EXPECT_EQ(motion(), "get_up_front") << "turned away";
}

TEST_F(CommandArbiterTest, TheRightToGetUpIsNotHandedOnFromMotionToMotion) {
  person_walks();
  fall(estimate::fall::lies);
  play(behaviour_motion_, 0x8000'0001U, "get_up_front");
  fall(estimate::fall::upright);
  play(behaviour_motion_, 0x8000'0002U, "wave");  // while the first one still counts as playing
  EXPECT_EQ(motion(), "get_up_front");
}

TEST_F(CommandArbiterTest, WhatTheBehaviourAskedInTheMillisecondOfTheLettingGoDoesNotCount) {
  person_walks();
  behaviour_walk_.publish(walk(kBehaviours), now_ns_);
  ask(command_request::verb::let_go);
  EXPECT_EQ(walks_with(), 0.0);
}

TEST_F(CommandArbiterTest, AStickThatIsHeldDoesNotKeepTheRobotFromGettingUp) {
  person_walks();
  fall(estimate::fall::lies);
  person_walks();
  play(behaviour_motion_, 0x8000'0001U, "get_up_front");
  EXPECT_EQ(motion(), "get_up_front");
}

TEST_F(CommandArbiterTest, APersonWhoPlaysAMotionGetsItUpThemselves) {
  person_walks();
  fall(estimate::fall::lies);
  play(person_motion_, 7, "get_up_back");
  play(behaviour_motion_, 0x8000'0001U, "get_up_front");
  EXPECT_EQ(motion(), "get_up_back");
}

TEST_F(CommandArbiterTest, AFallEndsWhatTheBehaviourWalks) {
  behaviour_walks();
  fall(estimate::fall::falls);
  EXPECT_EQ(walks_with(), 0.0);
  EXPECT_EQ(state().commander, commanders::behaviour);
}

TEST_F(CommandArbiterTest, NonsenseIsAStandAndNoLook) {
  behaviour_walk_.publish(walk(std::numeric_limits<double>::quiet_NaN()), now_ns_);
  milliseconds();
  EXPECT_EQ(walks_with(), 0.0);
  person_walk_.publish(walk(1e9), now_ns_);
  HeadCommand look{};
  look.mode = head_command::mode::point;
  look.point[2] = std::numeric_limits<double>::infinity();
  behaviour_head_.publish(look, now_ns_);
  milliseconds();
  EXPECT_EQ(walks_with(), 0.0);
  EXPECT_EQ(head_commands_.newest_sequence(), 0U);
}

TEST_F(CommandArbiterTest, AHeadThatLooksAroundStandsStillWhenSomebodyElseTakesOver) {
  HeadCommand scan{};
  scan.mode = head_command::mode::scan;
  scan.extent = 1.0;
  behaviour_head_.publish(scan, now_ns_);
  milliseconds();
  person_walks();
  HeadCommand now{};
  ASSERT_TRUE(head_commands_.read(now));
  EXPECT_EQ(now.mode, head_command::mode::hold);
}

TEST_F(CommandArbiterTest, ItTellsAStateOnlyWhenItHasChanged) {
  milliseconds(10);
  const std::uint64_t before = states_.newest_sequence();
  milliseconds(1000);
  EXPECT_EQ(states_.newest_sequence(), before);
}

TEST_F(CommandArbiterTest, WhatLiesThereWhenPeopleComeDoesNotCount) {
  person_walk_.publish(walk(kPersons), now_ns_);
  arbiter_.begin_anew_with_people(now_ns_ + 500 * facts::kMillisecond_ns);
  milliseconds();
  EXPECT_EQ(walks_with(), 0.0);
}

TEST_F(CommandArbiterTest, AfterItsEndNobodyIsObeyed) {
  person_walks();
  arbiter_.end(now_ns_);
  person_walks();
  behaviour_walks();
  EXPECT_EQ(walks_with(), 0.0);
}

}  // namespace
}  // namespace gaitway::msgcontroller
