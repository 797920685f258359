// The robot's side of the link by itself: what is left of a module, or of a process before this one, moves
// nothing and refuses nothing.
#include "gaitway/api/robot_desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "gaitway/contract/channel_table.hpp"
#include "gaitway/link/byte_order.hpp"
#include "gaitway/link/module_end.hpp"
#include "gaitway/msgclient/memory_block.hpp"

namespace gaitway::api {
namespace {

using facts::kMillisecond_ns;
using facts::kSecond_ns;

// A robot without anybody who obeys, and a module that says what it likes.
class RobotDeskTest : public ::testing::Test {
 protected:
  RobotDeskTest() { restart_module(11); }

  void restart_module(std::uint64_t boot) {
    module = std::make_unique<link::ModuleEnd>(
        contract::identity_of(link::Role::module, boot, "module", robot),
        contract::link_channels({robot.joints.size()}), link::LinkSettings{});
  }
  void start_desk(std::uint64_t boot) {
    client.emplace(block.local_client("api"));
    desk = std::make_unique<RobotDesk>(
        *client, robot, RobotDeskOptions{.boot = boot, .name = "robot", .narrow = false, .link = {}});
  }
  void pass(int milliseconds) {
    for (int ms = 0; ms < milliseconds; ++ms) {
      now_ns += kMillisecond_ns;
      block.beat(now_ns);
      carry(*module, desk->end());
      desk->step(now_ns);
      carry(desk->end(), *module);
    }
  }
  void carry(link::LinkEnd& from, link::LinkEnd& to) const {
    for (link::Bytes bytes = from.pending(now_ns); !bytes.empty(); bytes = from.pending(now_ns)) {
      to.on_bytes(bytes, now_ns);
      from.taken(bytes.size());
    }
  }
  // A velocity that holds for so long, of a module that has asked for so many stops.
  void walk(std::int64_t holds_ns, std::uint32_t stops) {
    WalkCommand request{};
    request.walk = 1;
    request.velocity[0] = 0.1;
    request.valid_until_ns = holds_ns;
    give(contract::OrderKind::walk, request, stops);
  }
  template <class Request>
  void give(contract::OrderKind kind, const Request& request, std::uint32_t stops = 0) {
    std::array<std::uint8_t, link::kMostOrderBytes> room{};
    link::ByteWriter(room).put(stops);
    const std::size_t size = codec.encode(TopicType<Request>::descriptor, &request,
                                          std::span(room).subspan(contract::kStopsSeenBytes));
    const link::Submission submission =
        module->submit(static_cast<std::uint16_t>(kind),
                       std::span(room).first(contract::kStopsSeenBytes + size), now_ns + kSecond_ns, now_ns);
    ASSERT_EQ(submission.refusal, link::Refusal::none);
    pass(5);
  }
  // What was answered last, if anything has been since.
  struct Answered {
    contract::OrderResultCode code{};
    std::vector<std::uint8_t> bytes;
  };
  std::optional<Answered> take_answer() {
    std::optional<Answered> last;
    while (const auto outcome = module->next_outcome(now_ns)) {
      last = Answered{static_cast<contract::OrderResultCode>(outcome->result),
                      {outcome->payload.begin(), outcome->payload.end()}};
    }
    return last;
  }
  template <class Answer>
  Answer decoded(const Answered& answered) {
    Answer answer{};
    EXPECT_EQ(codec.decode(TopicType<Answer>::descriptor, answered.bytes, &answer), answered.bytes.size());
    return answer;
  }
  [[nodiscard]] bool told_to_walk() {
    WalkCommand request{};
    return requests.read(request) && request.walk != 0 && now_ns < request.valid_until_ns;
  }

  const urdf::RobotModel robot =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  const contract::TopicCodec codec{.joint_count = robot.joints.size(), .exact = true};
  msgclient::MemoryBlock block;
  msgclient::Client looker = block.local_client("looker");
  msgclient::Reader<WalkCommand> requests = looker.read<WalkCommand>("walk_request");
  std::int64_t now_ns = kSecond_ns;
  std::optional<msgclient::Client> client;
  std::unique_ptr<RobotDesk> desk;
  std::unique_ptr<link::ModuleEnd> module;
};

// By telling the arbiter, which ends it.
TEST_F(RobotDeskTest, EndsTheWalkOfAProcessBeforeItsOwn) {
  auto told = looker.read<CommandRequest>("command_request");
  CommandRequest before{}, after{};
  start_desk(1);
  pass(200);
  walk(600 * kSecond_ns, 0);
  ASSERT_TRUE(told_to_walk());
  desk.reset();  // killed: it has said nothing
  ASSERT_TRUE(told.read(before));
  start_desk(2);
  ASSERT_TRUE(told.read(after));
  EXPECT_EQ(after.verb, command_request::verb::is_lost) << "who commanded has no link any more";
  EXPECT_NE(after.number, before.number);
}

// One topic tells both, and only its newest value is heard: each has a step of its own.
TEST_F(RobotDeskTest, OneWhoTakesTheCommandAtOnceDoesNotHideThatTheOneBeforeIsLost) {
  auto told = looker.read<CommandRequest>("command_request");
  start_desk(1);
  pass(200);
  restart_module(12);
  // Between two steps of the desk.
  const auto exchange = [this] {
    now_ns += kMillisecond_ns;
    carry(*module, desk->end());
    desk->end().step(now_ns);
    carry(desk->end(), *module);
  };
  for (int ms = 0; ms < 500 && !module->session().open(); ++ms) exchange();
  CommandRequest take{};
  take.verb = command_request::verb::take;
  std::array<std::uint8_t, link::kMostOrderBytes> room{};
  const std::size_t size = codec.encode(TopicType<CommandRequest>::descriptor, &take,
                                        std::span(room).subspan(contract::kStopsSeenBytes));
  ASSERT_EQ(module
                ->submit(static_cast<std::uint16_t>(contract::OrderKind::command),
                         std::span(room).first(contract::kStopsSeenBytes + size), now_ns + kSecond_ns, now_ns)
                .refusal,
            link::Refusal::none);
  for (int ms = 0; ms < 50; ++ms) exchange();  // the desk hangs
  std::vector<std::uint32_t> verbs;
  for (int ms = 0; ms < 50 && verbs.size() < 2; ++ms) {
    const std::uint64_t before = told.newest_sequence();
    pass(1);
    CommandRequest request{};
    ASSERT_LE(told.newest_sequence(), before + 1) << "two in one step";
    if (told.newest_sequence() != before && told.read(request)) verbs.push_back(request.verb);
  }
  EXPECT_THAT(verbs, testing::ElementsAre(command_request::verb::is_lost, command_request::verb::take));
}

TEST_F(RobotDeskTest, AModuleThatWasStartedAnewKnowsOfNoStopsBefore) {
  start_desk(1);
  pass(200);
  module->stop(link::StopKind::stop);
  module->stop(link::StopKind::stop);
  pass(5);
  walk(kSecond_ns, 1);
  EXPECT_FALSE(told_to_walk()) << "it was given before the second stop";
  restart_module(12);
  pass(300);
  walk(kSecond_ns, 0);
  EXPECT_TRUE(told_to_walk()) << "it has asked for no stop";
  module->stop(link::StopKind::emergency_hold);
  pass(5);
  const std::uint64_t given = requests.newest_sequence();
  walk(kSecond_ns, 0);
  EXPECT_EQ(requests.newest_sequence(), given);
}

TEST_F(RobotDeskTest, WhereToLookIsPassedOnAndWhatIsNoModeIsNot) {
  start_desk(1);
  pass(200);
  auto heads = looker.read<HeadCommand>("head_request");
  HeadCommand look{};
  look.mode = head_command::mode::point;
  look.point[0] = 1.25;
  look.speed = 2.0;
  give(contract::OrderKind::head, look);
  HeadCommand asked{};
  ASSERT_TRUE(heads.read(asked));
  EXPECT_EQ(asked.mode, head_command::mode::point);
  EXPECT_EQ(asked.point[0], 1.25);
  EXPECT_EQ(asked.speed, 2.0);
  EXPECT_GT(asked.stamp_ns, kSecond_ns) << "the robot's time, by which newer ones are known";
  EXPECT_EQ(take_answer()->code, contract::OrderResultCode::done);
  look.mode = head_command::mode::hold + 1;
  give(contract::OrderKind::head, look);
  EXPECT_EQ(take_answer()->code, contract::OrderResultCode::malformed);
  module->stop(link::StopKind::stop);
  look.mode = head_command::mode::ahead;
  give(contract::OrderKind::head, look, 0);
  EXPECT_EQ(take_answer()->code, contract::OrderResultCode::stopped) << "it was given before the stop";
}

TEST_F(RobotDeskTest, TheCommandIsAnsweredByWhoGivesIt) {
  start_desk(1);
  pass(200);
  auto requests_of_command = looker.read<CommandRequest>("command_request");
  auto states = looker.write<CommandState>("command_state");
  CommandRequest request{};
  request.verb = command_request::verb::let_go;
  give(contract::OrderKind::command, request);
  CommandRequest asked{};
  ASSERT_TRUE(requests_of_command.read(asked));
  EXPECT_EQ(asked.verb, command_request::verb::let_go);
  EXPECT_NE(asked.number, 0U);
  EXPECT_EQ(asked.number >> 31U, 0U) << "the behaviour's have the top bit set";
  CommandState state{};
  state.answered = asked.number - 1;
  states.publish(state, now_ns);
  pass(5);
  EXPECT_FALSE(take_answer()) << "that was another's";
  state.answered = asked.number;
  state.commander = command_state::commander::behaviour;
  states.publish(state, now_ns);
  pass(5);
  const auto answered = take_answer();
  ASSERT_TRUE(answered);
  EXPECT_EQ(decoded<CommandState>(*answered).commander, command_state::commander::behaviour);
  request.verb = command_request::verb::is_lost;  // is for the desk to say
  give(contract::OrderKind::command, request);
  EXPECT_EQ(take_answer()->code, contract::OrderResultCode::malformed);
}

TEST_F(RobotDeskTest, ARobotWithoutBehaviourSaysSo) {
  start_desk(1);
  pass(200);
  give(contract::OrderKind::behaviour, BehaviourRequest{});
  const auto answered = take_answer();
  ASSERT_TRUE(answered);
  const auto state = decoded<PluginAnswer>(*answered);
  EXPECT_EQ(state.done, 0U);
  EXPECT_NE(std::string_view(reinterpret_cast<const char*>(state.text)).find("add 'behaviour'"),
            std::string_view::npos);
}

// Its answer fits whatever the tree is: nodes are told as state.
TEST_F(RobotDeskTest, AMissionIsAnsweredByTheBehaviour) {
  auto states = looker.write<BehaviourState>("behaviour_state");
  auto missions = looker.read<BehaviourRequest>("behaviour_request");
  BehaviourState state{};
  std::ranges::fill(state.status, std::uint8_t{2});
  std::ranges::fill(state.transition_ns, INT64_MAX);
  std::ranges::fill(state.text, std::uint8_t{'t'});
  states.publish(state, now_ns);
  start_desk(1);
  pass(200);
  BehaviourRequest request{};
  request.mission[0] = 'm';
  give(contract::OrderKind::behaviour, request);
  give(contract::OrderKind::behaviour, request);
  EXPECT_EQ(take_answer()->code, contract::OrderResultCode::overtaken) << "the first";
  BehaviourRequest asked{};
  ASSERT_TRUE(missions.read(asked));
  EXPECT_EQ(asked.mission[0], 'm');
  EXPECT_EQ(asked.number >> 31U, 0U);
  state.answered = asked.number;
  states.publish(state, now_ns);
  pass(5);
  const auto answered = take_answer();
  ASSERT_TRUE(answered);
  const auto answer = decoded<PluginAnswer>(*answered);
  EXPECT_EQ(answer.done, 1U);
  EXPECT_EQ(answer.text[200], 't');
  request.verb = behaviour_request::verb::change + 1;
  give(contract::OrderKind::behaviour, request);
  EXPECT_EQ(take_answer()->code, contract::OrderResultCode::malformed);
}

}  // namespace
}  // namespace gaitway::api
