// What clients are told of who commands the robot, and of its behaviour tree.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "collector.hpp"
#include "gaitway/api/command_messages.hpp"
#include "gaitway/api/feed.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "humanoid.hpp"

namespace gaitway::api {
namespace {

using facts::kMillisecond_ns;
using facts::kSecond_ns;
using test::humanoid;
using ::testing::ElementsAre;

constexpr std::int64_t kBatch_ns = 80 * kMillisecond_ns;

template <std::size_t size>
void put(std::uint8_t (&field)[size], std::string_view text) {
  std::ranges::fill(field, std::uint8_t{0});
  std::ranges::copy(text, field);
}

class CommandNewsTest : public ::testing::Test {
 protected:
  void later(std::int64_t by_ns) {
    now_ns += by_ns;
    block.beat(now_ns);
  }
  void tell_command() {
    later(kMillisecond_ns);
    command.stamp_ns = now_ns;
    commands.publish(command, now_ns);
    feed.poll(now_ns, sink);
  }
  void tell_behaviour() {
    later(kBatch_ns);
    behaviour.stamp_ns = now_ns;
    ++behaviour.ticks;
    behaviours.publish(behaviour, now_ns);
    feed.poll(now_ns, sink);
  }
  // Part `part` of a tree of so many nodes, each the child of the one before.
  void tell_part(std::uint32_t part, std::uint32_t node_count, std::uint32_t revision) {
    later(kBatch_ns);
    gaitway::BehaviourNodes nodes{};
    nodes.stamp_ns = now_ns;
    nodes.revision = revision;
    nodes.node_count = node_count;
    nodes.first = part * kToldNodes;
    nodes.count = std::min<std::uint32_t>(node_count - nodes.first, kToldNodes);
    for (std::uint32_t i = 0; i < nodes.count; ++i) {
      const std::uint32_t node = nodes.first + i;
      nodes.parent[i] = node == 0 ? 0 : node - 1;
      put(nodes.type[i], node + 1 < node_count ? "Inverter" : "WalkTo");
      put(nodes.name[i], "n" + std::to_string(node));
    }
    parts.publish(nodes, now_ns);
    feed.poll(now_ns, sink);
  }
  [[nodiscard]] auto told_commands() { return collector.of<ros::CommandState>(Topic::command_state); }
  [[nodiscard]] auto told_trees() { return collector.of<ros::BehaviourNodes>(Topic::behaviour_nodes); }

  msgclient::MemoryBlock block;
  msgclient::Client robot = block.local_client("robot");
  msgclient::Writer<gaitway::CommandState> commands = robot.write<gaitway::CommandState>("command_state");
  msgclient::Writer<gaitway::BehaviourState> behaviours =
      robot.write<gaitway::BehaviourState>("behaviour_state");
  msgclient::Writer<gaitway::BehaviourNodes> parts = robot.write<gaitway::BehaviourNodes>("behaviour_nodes");
  msgclient::Client api = block.local_client("api");
  Feed feed{api, humanoid()};
  test::Collector collector{Topic::command_state, Topic::behaviour_state, Topic::behaviour_nodes};
  decltype(test::sink_of(collector)) sink = test::sink_of(collector);
  std::int64_t now_ns = kSecond_ns;
  gaitway::CommandState command{};
  gaitway::BehaviourState behaviour{};
};

TEST_F(CommandNewsTest, WhoCommandsIsToldInWords) {
  command.commander = command_state::commander::person;
  command.reason = command_state::reason::person_stops;
  command.since_ns = 1'500 * kMillisecond_ns;
  command.in_force[1] = command_state::in_force::person;
  command.in_force[3] = command_state::in_force::behaviour;
  command.may_get_up = 1;
  put(command.text, "a person commands");
  tell_command();
  ASSERT_EQ(told_commands().size(), 1U);
  const ros::CommandState told = told_commands().front();
  EXPECT_EQ(told.commander, "person");
  EXPECT_EQ(told.reason, "person_stops");
  EXPECT_EQ(told.text, "a person commands");
  EXPECT_EQ(told.since.sec, 1);
  EXPECT_EQ(told.since.nanosec, 500'000'000U);
  EXPECT_EQ(told.walk, "nobody");
  EXPECT_EQ(told.way, "person");
  EXPECT_EQ(told.motion, "nobody");
  EXPECT_EQ(told.head, "behaviour");
  EXPECT_TRUE(told.may_get_up);
  command.commander = command_state::commander::emergency_stop;
  command.reason = command_state::reason::emergency_stop_released;
  ++command.changes;
  tell_command();
  EXPECT_EQ(told_commands().back().commander, "emergency_stop");
  EXPECT_EQ(told_commands().back().reason, "emergency_stop_released");
  command.commander = 77;
  command.reason = 77;
  ++command.changes;
  tell_command();
  EXPECT_EQ(told_commands().back().commander, "unknown");
  EXPECT_EQ(told_commands().back().reason, "unknown");
}

// A behaviour that goes on ordering is turned away with each batch.
TEST_F(CommandNewsTest, WhatIsNoNewsIsToldOnceASecond) {
  tell_command();
  for (int i = 0; i < 2'500; ++i) {
    ++command.turned_away;
    ++command.answered;
    tell_command();
  }
  EXPECT_EQ(told_commands().size(), 3U);
  command.in_force[0] = command_state::in_force::behaviour;
  tell_command();
  EXPECT_EQ(told_commands().size(), 4U) << "another order is";
  command.answered += 5;
  tell_command();
  EXPECT_EQ(told_commands().size(), 4U) << "who asked has the answer";
}

TEST_F(CommandNewsTest, ARobotThatWasStartedAnewIsHeardAnew) {
  tell_command();
  now_ns = 0;
  tell_command();
  EXPECT_EQ(told_commands().size(), 2U);
}

TEST_F(CommandNewsTest, TransitionsAreToldOldestFirst) {
  behaviour.state = behaviour_state::state::runs;
  behaviour.node_count = 3;
  behaviour.status[2] = behaviour_state::status::failure;
  put(behaviour.mission, "find_and_walk_to_tag");
  constexpr std::uint64_t kSoFar = kTreeTransitions + 6;  // the ring has gone round
  for (std::uint64_t i = 0; i < kSoFar; ++i) {
    behaviour.transition_ns[i % kTreeTransitions] = static_cast<std::int64_t>(i) * kSecond_ns;
    behaviour.transition_node[i % kTreeTransitions] = static_cast<std::uint32_t>(i);
    behaviour.transition_to[i % kTreeTransitions] = behaviour_state::transition_to::running;
  }
  behaviour.transitions = kSoFar;
  tell_behaviour();
  const auto& all = collector.of<ros::BehaviourState>(Topic::behaviour_state);
  ASSERT_EQ(all.size(), 1U);
  const ros::BehaviourState& told = all.front();
  EXPECT_EQ(told.mission, "find_and_walk_to_tag");
  EXPECT_EQ(told.state, "runs");
  EXPECT_THAT(told.status, ElementsAre(0, 0, 3));
  EXPECT_EQ(told.transitions, kSoFar);
  ASSERT_EQ(told.transition_node.size(), static_cast<std::size_t>(kTreeTransitions));
  EXPECT_EQ(told.transition_node.front(), 6U);
  EXPECT_EQ(told.transition_node.back(), kSoFar - 1);
  EXPECT_EQ(told.transition_time.back(), static_cast<double>(kSoFar - 1));
  EXPECT_EQ(told.transition_to.back(), ros::BehaviourState::RUNNING);
}

TEST_F(CommandNewsTest, ATreeThatStandsStillIsToldOnceASecond) {
  for (int i = 0; i < 50; ++i) tell_behaviour();  // 4 s
  EXPECT_EQ(collector.count(Topic::behaviour_state), 4U) << "each 13th: 1.04 s";
  ++behaviour.transitions;
  tell_behaviour();
  EXPECT_EQ(collector.count(Topic::behaviour_state), 5U);
  put(behaviour.text, "sees tag 7");
  tell_behaviour();
  EXPECT_EQ(collector.count(Topic::behaviour_state), 6U);
}

TEST_F(CommandNewsTest, ATreeIsToldWhenAllOfItsPartsHaveCome) {
  tell_part(2, 40, 1);  // whoever comes later hears them from somewhere in the middle on
  tell_part(0, 40, 1);
  tell_part(0, 40, 1);
  EXPECT_TRUE(told_trees().empty());
  tell_part(1, 40, 1);
  ASSERT_EQ(told_trees().size(), 1U);
  const ros::BehaviourNodes tree = told_trees().front();
  EXPECT_EQ(tree.revision, 1U);
  EXPECT_EQ(tree.node_count, 40U);
  ASSERT_EQ(tree.parent.size(), 40U);
  EXPECT_EQ(tree.parent[0], 0U);
  EXPECT_EQ(tree.parent[17], 16U);
  EXPECT_EQ(tree.type[38], "Inverter");
  EXPECT_EQ(tree.type[39], "WalkTo");
  EXPECT_EQ(tree.name[39], "n39");
  for (std::uint32_t part = 0; part < 3; ++part) tell_part(part, 40, 1);
  EXPECT_EQ(told_trees().size(), 1U) << "it is the same";
  tell_part(1, 20, 2);
  EXPECT_EQ(told_trees().size(), 1U);
  tell_part(0, 20, 2);
  ASSERT_EQ(told_trees().size(), 2U);
  EXPECT_EQ(told_trees().back().name.size(), 20U);
}

TEST_F(CommandNewsTest, OfATreeThatIsTooLargeTheFirstNodesAreTold) {
  for (std::uint32_t part = 0; part < kMaxTreeNodes / kToldNodes; ++part) tell_part(part, 5'000, 1);
  ASSERT_EQ(told_trees().size(), 1U);
  EXPECT_EQ(told_trees().front().node_count, 5'000U);
  EXPECT_EQ(told_trees().front().parent.size(), static_cast<std::size_t>(kMaxTreeNodes));
}

// Whatever the memory block holds.
TEST_F(CommandNewsTest, PartsThatAreNonsenseAddNothing) {
  gaitway::BehaviourNodes nodes{};
  nodes.revision = 1;
  nodes.node_count = 3;
  nodes.count = UINT32_MAX;
  nodes.first = UINT32_MAX;
  parts.publish(nodes, now_ns);
  feed.poll(now_ns, sink);
  EXPECT_TRUE(told_trees().empty());
  tell_part(0, 3, 1);
  EXPECT_EQ(told_trees().size(), 1U);
}

}  // namespace
}  // namespace gaitway::api
