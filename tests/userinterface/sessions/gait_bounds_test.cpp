// What the gait walks now is read from its plug-in, told, and kept to.
#include "userinterface/sessions/gait_bounds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "test_client.hpp"

namespace gaitway::api {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

// With a plug-in that has parameters, and tells them when it is asked.
class GaitBoundsTest : public HubTest {
 protected:
  GaitBoundsTest() { robot.plugin_list.push_back({.name = "trajectory", .state = "works"}); }

  // The robot answers what it was asked, until nothing is.
  void answer_all() {
    step();
    while (answered_ < robot.orders.size()) {
      const PluginOrder order = robot.orders[answered_++];
      if (order.verb != PluginVerb::describe_parameter) {
        robot.results.push_back({robot.last_number, true, "done"});
      } else if (order.index >= parameters.size()) {
        robot.results.push_back({robot.last_number, false, "there are no more"});
      } else {
        robot.results.push_back({robot.last_number, true, parameters[order.index]});
      }
      step();
    }
  }
  std::size_t asked_since(std::size_t before) const { return robot.orders.size() - before; }
  json limits() { return client->call("/walk/limits")["values"]; }

  std::vector<std::string> parameters{
      "com_height\t0.3\tm\t\t",         "step_time\t0.4\ts\tlive\t",    "max_step_forward\t0.16 m\tm\tlive\t",
      "max_step_backward\t0.08\tm\t\t", "max_step_turn\t0.2\trad\t\t",  "foot_spacing\t0.1\tm\t\t",
      "max_foot_spacing\t0.18\tm\t\t",  "swing_height\t0.03\tm\tlive\t"};
  std::size_t answered_ = 0;
  std::unique_ptr<TestClient> client = connect("anna");
};

TEST_F(GaitBoundsTest, AreTold) {
  answer_all();
  const json told = limits();
  EXPECT_EQ(told["success"], true);
  EXPECT_DOUBLE_EQ(told["forward"], 0.4);
  EXPECT_DOUBLE_EQ(told["backward"], 0.2);
  EXPECT_DOUBLE_EQ(told["left"], 0.1);
  EXPECT_DOUBLE_EQ(told["turn"], 0.5);
}

TEST_F(GaitBoundsTest, AreKeptTo) {
  answer_all();
  client->drive(0.4);
  client->drive(-0.2, 0.5);
  EXPECT_THAT(client->receive(), IsEmpty());
  client->drive(0.41);
  EXPECT_THAT(
      client->receive_one()["msg"],
      AllOf(HasSubstr("linear.x is 0.41"), HasSubstr("from -0.2 to 0.4 m/s"), HasSubstr("/walk/limits")));
  client->drive(-0.21);
  EXPECT_THAT(client->receive_one()["msg"], HasSubstr("linear.x is -0.21"));
  client->drive(0.1, -0.51);
  EXPECT_THAT(client->receive_one()["msg"], HasSubstr("angular.z is -0.51"));
  EXPECT_EQ(robot.velocities.size(), 2U);
}

TEST_F(GaitBoundsTest, WhileTheyAreNotKnownTheApisOwnCount) {
  const json told = limits();
  EXPECT_EQ(told["success"], false);
  EXPECT_EQ(told["forward"], 1.0);
  client->drive(0.9);
  EXPECT_THAT(client->receive(), IsEmpty());
  parameters.pop_back();
  parameters.pop_back();
  answer_all();
  EXPECT_EQ(limits()["success"], false) << "one is lacking";
}

TEST_F(GaitBoundsTest, AnotherUnitIsNotTakenForItsOwn) {
  parameters[2] = "max_step_forward\t16 cm\tm\tlive\t";
  answer_all();
  EXPECT_EQ(limits()["success"], false);
}

TEST_F(GaitBoundsTest, AreReadAgainWhenAClientChangesThem) {
  answer_all();
  parameters[1] = "step_time\t0.8\ts\tlive\t";
  client->send({{"op", "call_service"},
                {"service", "/plugins/set_parameter"},
                {"args", {{"plugin", "trajectory"}, {"parameter", "step_time"}, {"value", "0.8 s"}}}});
  answer_all();
  client->receive();
  const std::size_t before = robot.orders.size();
  answer_all();
  EXPECT_DOUBLE_EQ(limits()["forward"], 0.2);
  EXPECT_EQ(asked_since(before), 0U);
}

TEST_F(GaitBoundsTest, AreReadAgainFromTimeToTimeWithoutAllOthers) {
  answer_all();
  const std::size_t before = robot.orders.size();
  pass(GaitWatch::kPeriod_ns - kSecond_ns);
  EXPECT_EQ(asked_since(before), 0U);
  parameters[4] = "max_step_turn\t0.4\trad\t\t";
  pass(kSecond_ns);
  answer_all();
  EXPECT_EQ(asked_since(before), GaitWatch::kNames.size());
  EXPECT_DOUBLE_EQ(limits()["turn"], 1.0);
}

TEST_F(GaitBoundsTest, OfAnotherPlugInOfThatNameAreFoundWhereTheyAre) {
  answer_all();
  std::swap(parameters[0], parameters[6]);
  parameters[3] = "max_step_backward\t0.04\tm\t\t";
  pass(GaitWatch::kPeriod_ns);
  answer_all();
  EXPECT_DOUBLE_EQ(limits()["backward"], 0.1);
  EXPECT_DOUBLE_EQ(limits()["left"], 0.1);
}

TEST_F(GaitBoundsTest, WhatIsNotAnsweredIsAskedForAgain) {
  step();
  EXPECT_EQ(robot.orders.size(), 1U);
  pass(10 * kSecond_ns);
  EXPECT_GT(robot.orders.size(), 1U);
  EXPECT_LT(robot.orders.size(), 5U);
}

TEST_F(GaitBoundsTest, AreForgottenWithTheLink) {
  answer_all();
  hub.robot_lost();
  EXPECT_EQ(limits()["success"], false);
  answer_all();
  EXPECT_EQ(limits()["success"], true);
}

}  // namespace
}  // namespace gaitway::api
