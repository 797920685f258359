// Order and dependencies of larger graphs than the test plug-ins make.
#include "gaitway/manager/data_flow.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace gaitway::core {
namespace {

TopicUse use(Access access, const std::string& topic) {
  return {access, topic, "T", 1, 8};
}

TEST(DataFlow, WalkingChainInAnyConfigurationOrderIsOneOrder) {
  const std::vector<DataFlowNode> chain = {
      {"zmp", {use(Access::read, "imu"), use(Access::write, "estimate")}},
      {"trajectory",
       {use(Access::read_optional, "walk_command"), use(Access::read, "estimate"),
        use(Access::read_previous, "correction"), use(Access::write, "motion_plan")}},
      {"stability",
       {use(Access::read, "estimate"), use(Access::read, "motion_plan"), use(Access::write, "correction")}},
      {"kinematics",
       {use(Access::read, "motion_plan"), use(Access::read_optional, "correction"),
        use(Access::write, "joint_plan")}}};
  const std::vector<ExternalTopic> external = {{"imu", "message_controller"}};
  std::vector<std::size_t> permutation = {0, 1, 2, 3};
  do {
    std::vector<DataFlowNode> nodes;
    for (const std::size_t i : permutation) {
      nodes.push_back(chain[i]);
    }
    std::vector<std::string> names;
    for (const std::size_t i : order_by_data_flow(nodes, external).order) {
      names.push_back(nodes[i].name);
    }
    EXPECT_THAT(names, testing::ElementsAre("zmp", "trajectory", "stability", "kinematics"));
  } while (std::next_permutation(permutation.begin(), permutation.end()));
}

std::string topic_of(std::size_t node) {
  return std::string("t").append(std::to_string(node));
}

// Random graphs without cycles: every reader comes after its writer, and dependencies are the transitive
// closure.
TEST(DataFlow, OrderAndDependenciesHoldInRandomGraphs) {
  std::mt19937 random(11);
  for (int round = 0; round < 200; ++round) {
    const std::size_t count = 2 + random() % 12;
    std::vector<std::size_t> hidden(count);
    std::iota(hidden.begin(), hidden.end(), std::size_t{0});
    std::shuffle(hidden.begin(), hidden.end(), random);
    std::vector<DataFlowNode> nodes(count);
    std::vector<std::vector<bool>> reach(count, std::vector<bool>(count, false));
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t node = hidden[i];
      nodes[node] = {std::to_string(node), {use(Access::write, topic_of(node))}};
      reach[node][node] = true;
      for (std::size_t j = 0; j < i; ++j) {
        if (random() % 3 == 0) {
          nodes[node].uses.push_back(use(Access::read, topic_of(hidden[j])));
          for (std::size_t k = 0; k < count; ++k) {
            reach[node][k] = reach[node][k] || reach[hidden[j]][k];
          }
        }
      }
    }
    const DataFlow flow = order_by_data_flow(nodes, {});
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        EXPECT_EQ(flow.depends_on[i][j], reach[flow.order[i]][flow.order[j]]) << "round " << round;
        EXPECT_TRUE(i <= j || !flow.depends_on[j][i]) << "round " << round;
      }
    }
  }
}

TEST(DataFlow, ReadingOnesOwnOutputIsACycle) {
  const std::vector<DataFlowNode> nodes = {{"a", {use(Access::write, "x"), use(Access::read, "x")}}};
  EXPECT_THROW(
      {
        try {
          order_by_data_flow(nodes, {});
        } catch (const PluginError& error) {
          EXPECT_THAT(error.what(), testing::HasSubstr("'a' -> x -> 'a'"));
          throw;
        }
      },
      PluginError);
}

// A plug-in that only waits behind a cycle is not blamed.
TEST(DataFlow, CycleNamesOnlyItsMembers) {
  const std::vector<DataFlowNode> nodes = {{"behind", {use(Access::read, "y"), use(Access::write, "z")}},
                                           {"a", {use(Access::read, "y"), use(Access::write, "x")}},
                                           {"b", {use(Access::read, "x"), use(Access::write, "y")}}};
  try {
    order_by_data_flow(nodes, {});
    FAIL() << "was accepted";
  } catch (const PluginError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("wait for each other: 'a' -> x -> 'b' -> y -> 'a'."));
  }
}

TEST(DataFlow, TopicInTheBlockWithoutAWriterIsMissing) {
  const std::vector<DataFlowNode> nodes = {{"a", {use(Access::read, "imu")}}};
  const std::vector<ExternalTopic> external = {{"imu", ""}};
  EXPECT_THROW(order_by_data_flow(nodes, external), PluginError);
}

}  // namespace
}  // namespace gaitway::core
