// Each operation of rosbridge, and each way to get it wrong: a clear status, and nothing else happens.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test_client.hpp"

namespace gaitway::api {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class OperationsTest : public HubTest {
 protected:
  std::unique_ptr<TestClient> client = connect("anna");
};

json twist(const std::string& text) {
  return {{"op", "publish"}, {"topic", "/cmd_vel"}, {"msg", json::parse(text)}};
}

TEST_F(OperationsTest, VelocityCommandReachesTheRobotAtOnce) {
  client->send(twist(R"({"linear": {"x": 0.25, "y": -0.1, "z": 0}, "angular": {"x": 0, "y": 0, "z": 0.5}})"));
  ASSERT_EQ(robot.velocities.size(), 1U);
  EXPECT_EQ(robot.velocities[0].forward_m_per_s, 0.25);
  EXPECT_EQ(robot.velocities[0].left_m_per_s, -0.1);
  EXPECT_EQ(robot.velocities[0].turn_rad_per_s, 0.5);
  EXPECT_EQ(robot.validities_ns[0], Limits{}.velocity_ns);
  EXPECT_THAT(client->receive(), IsEmpty());
}

TEST_F(OperationsTest, VelocityMayLackComponents) {
  client->send(twist(R"({"angular": {"z": -1}})"));
  ASSERT_EQ(robot.velocities.size(), 1U);
  EXPECT_EQ(robot.velocities[0].turn_rad_per_s, -1.0);
}

struct BadMessage {
  const char* what;
  std::string text;
  const char* answer;  // part of the status
};
std::ostream& operator<<(std::ostream& out, const BadMessage& bad) {
  return out << bad.what;
}

class BadMessageTest : public OperationsTest, public testing::WithParamInterface<BadMessage> {};

TEST_P(BadMessageTest, IsRefusedClearlyAndChangesNothing) {
  EXPECT_THAT(client->refusal_of_text(GetParam().text), HasSubstr(GetParam().answer));
  EXPECT_THAT(robot.told, IsEmpty());
  EXPECT_EQ(hub.statistics().commander, "");
  EXPECT_EQ(hub.statistics().subscriptions, 0U);
  EXPECT_FALSE(client->closed);
  client->drive(0.1);
  EXPECT_THAT(robot.told, ElementsAre("walk")) << "the connection works on";
}

std::string velocity(const std::string& msg) {
  return R"({"op": "publish", "topic": "/cmd_vel", "msg": )" + msg + "}";
}
std::string nested(std::size_t depth) {
  return velocity(std::string(depth, '[') + std::string(depth, ']'));
}

INSTANTIATE_TEST_SUITE_P(
    Json, BadMessageTest,
    testing::Values(BadMessage{"Empty", "", "not JSON"}, BadMessage{"Text", "hello", "see byte 1"},
                    BadMessage{"CutShort", R"({"op": "publish")", "not JSON"},
                    BadMessage{"TwoMessages", R"({"op": "status"} {"op": "status"})", "not JSON"},
                    BadMessage{"NotUtf8", "{\"op\": \"\xC3\x28\"}", "UTF-8"},
                    BadMessage{"LoneContinuation", "{\"op\": \"\x80\"}", "UTF-8"},
                    BadMessage{"OverlongEncoding", "{\"op\": \"\xC0\xAF\"}", "UTF-8"},
                    BadMessage{"LoneSurrogate", R"({"op": "\ud800"})", "not JSON"},
                    BadMessage{"NaN", velocity(R"({"linear": {"x": NaN}})"), "not JSON"},
                    BadMessage{"Infinity", velocity(R"({"linear": {"x": 1e999}})"), "too large for a double"},
                    BadMessage{"ListInsteadOfObject", "[1, 2]", "must be an object"},
                    BadMessage{"NumberInsteadOfObject", "7", "must be an object"},
                    BadMessage{"Deep33", nested(33), "nested too deeply"},
                    BadMessage{"Deep10000", nested(10'000), "nested too deeply"},
                    BadMessage{"DeepUnclosed", std::string(60'000, '['), "nested too deeply"},
                    BadMessage{"TooLong", R"({"op": ")" + std::string(70'000, 'x') + "\"}", "at most 65536"}),
    [](const auto& test) { return std::string(test.param.what); });

INSTANTIATE_TEST_SUITE_P(
    Fields, BadMessageTest,
    testing::Values(
        BadMessage{"NoOperation", "{}", "op is missing"},
        BadMessage{"OperationIsNumber", R"({"op": 1})", "op is 1, but must be a text"},
        BadMessage{"UnknownOperation", R"({"op": "dance"})", R"(op is "dance")"},
        BadMessage{"LongOperation", R"({"op": ")" + std::string(5000, 'x') + "\"}", "1 to 256 bytes"},
        BadMessage{"IdIsObject", R"({"op": "status", "id": {}})", "id is an object"},
        BadMessage{"LongId", R"({"op": "status", "id": ")" + std::string(300, 'x') + "\"}", "id is"},
        BadMessage{"NoTopic", R"({"op": "publish", "msg": {}})", "topic is missing"},
        BadMessage{"NoMessage", R"({"op": "publish", "topic": "/cmd_vel"})", "msg is missing"},
        BadMessage{"PublishElsewhere", R"({"op": "publish", "topic": "/joint_states", "msg": {}})",
                   "takes messages on /cmd_vel only"},
        BadMessage{"PathTrick", R"({"op": "publish", "topic": "/../cmd_vel", "msg": {}})", "/../cmd_vel"},
        BadMessage{"MessageIsText", velocity("\"fast\""), "must be an object"},
        BadMessage{"WrongType", velocity(R"({"linear": {"x": "fast"}})"), "linear.x"},
        BadMessage{"Null", velocity(R"({"linear": {"x": null}})"), "linear.x"},
        BadMessage{"UnknownField", velocity(R"({"speed": 1})"), "speed"},
        BadMessage{"TooFast", velocity(R"({"linear": {"x": 1.1}})"), "from -1.0 to 1.0 m/s"},
        BadMessage{"Huge", velocity(R"({"linear": {"y": -1e308}})"), "linear.y is -1e+308"},
        BadMessage{"HugeInteger", velocity(R"({"angular": {"z": 123456789012345678901234567890}})"),
                   "angular.z"},
        BadMessage{"TurnsTooFast", velocity(R"({"angular": {"z": 2.5}})"), "from -2.0 to 2.0 rad/s"},
        BadMessage{"Flies", velocity(R"({"linear": {"z": 0.1}})"), "linear.z is 0.1, but must be 0"},
        BadMessage{"Rolls", velocity(R"({"angular": {"x": 0.1}})"), "angular.x"},
        BadMessage{"Pitches", velocity(R"({"angular": {"y": 0.1}})"), "angular.y"}),
    [](const auto& test) { return std::string(test.param.what); });

INSTANTIATE_TEST_SUITE_P(
    Operations, BadMessageTest,
    testing::Values(
        BadMessage{"AdvertiseService", R"({"op": "advertise_service", "service": "/stop", "type": "a/B"})",
                   "the robot's own"},
        BadMessage{"AdvertiseAction", R"({"op": "advertise_action", "action": "/x"})", "no actions"},
        BadMessage{"SendActionGoal", R"({"op": "send_action_goal", "action": "/x"})", "no actions"},
        BadMessage{"CancelActionGoal", R"({"op": "cancel_action_goal", "action": "/x"})", "no actions"},
        BadMessage{"Fragment", R"({"op": "fragment", "id": "1", "data": "{", "num": 0, "total": 2})",
                   "whole"},
        BadMessage{"Png", R"({"op": "png", "data": "abc"})", "whole"},
        BadMessage{"AdvertiseElsewhere",
                   R"({"op": "advertise", "topic": "/rosout", "type": "rcl_interfaces/Log"})",
                   "/cmd_vel only"},
        BadMessage{"AdvertiseWrongType",
                   R"({"op": "advertise", "topic": "/cmd_vel", "type": "geometry_msgs/TwistStamped"})",
                   "is of geometry_msgs/msg/Twist"},
        BadMessage{"SubscribeUnknownTopic", R"({"op": "subscribe", "topic": "/no_such_topic"})",
                   "/rosapi/topics"},
        BadMessage{"SubscribeWrongType",
                   R"({"op": "subscribe", "topic": "/joint_states", "type": "std_msgs/String"})",
                   "/joint_states is of sensor_msgs/msg/JointState"},
        BadMessage{"SubscribeUnknownType", R"({"op": "subscribe", "topic": "/joint_states", "type": "x/Y"})",
                   R"(type is "x/Y")"},
        BadMessage{"PngCompression", R"({"op": "subscribe", "topic": "/zmp", "compression": "png"})",
                   "compression"},
        BadMessage{"NegativeThrottle", R"({"op": "subscribe", "topic": "/zmp", "throttle_rate": -1})",
                   "throttle_rate is -1"},
        BadMessage{"TextThrottle", R"({"op": "subscribe", "topic": "/zmp", "throttle_rate": "1"})",
                   "throttle_rate"},
        BadMessage{"HugeThrottle", R"({"op": "subscribe", "topic": "/zmp", "throttle_rate": 1e300})",
                   "throttle_rate"},
        BadMessage{"BrokenQueue", R"({"op": "subscribe", "topic": "/zmp", "queue_length": 1.5})",
                   "queue_length"},
        BadMessage{"TinyFragments", R"({"op": "subscribe", "topic": "/zmp", "fragment_size": 1})",
                   "at least 64"},
        BadMessage{"UnknownLevel", R"({"op": "set_level", "level": "loud"})", "level is \"loud\""},
        BadMessage{"NoService", R"({"op": "call_service"})", "service is missing"},
        BadMessage{"NegativeTimeout", R"({"op": "call_service", "service": "/stand", "timeout": -1})",
                   "timeout"},
        BadMessage{"AuthWithoutToken", R"({"op": "auth"})", "token is missing"}),
    [](const auto& test) { return std::string(test.param.what); });

TEST_F(OperationsTest, BinaryMessagesAreRefused) {
  EXPECT_THAT(client->refusal_of_text("\xA1\x62op", true), HasSubstr("binary"));
}

TEST_F(OperationsTest, StatusBearsTheIdOfWhatItIsAbout) {
  client->send({{"op", "dance"}, {"id", "fred"}});
  EXPECT_EQ(client->receive_one()["id"], "fred");
  client->send({{"op", "dance"}, {"id", 42}});
  EXPECT_EQ(client->receive_one()["id"], 42);
  client->send({{"op", "dance"}});
  EXPECT_FALSE(client->receive_one().contains("id"));
}

TEST_F(OperationsTest, AdvertisesWithTypesOfEitherRos) {
  for (const char* const type : {"geometry_msgs/Twist", "geometry_msgs/msg/Twist"}) {
    client->send({{"op", "advertise"}, {"id", type}, {"topic", "/cmd_vel"}, {"type", type}});
  }
  EXPECT_THAT(client->receive(), IsEmpty());
  client->send({{"op", "unadvertise"}, {"id", "geometry_msgs/Twist"}, {"topic", "/cmd_vel"}});
  client->send({{"op", "unadvertise"}, {"topic", "/cmd_vel"}});
  EXPECT_THAT(client->receive(), IsEmpty());
  client->send({{"op", "unadvertise"}, {"id", 5}, {"topic", "/cmd_vel"}});
  const json status = client->receive_one();
  EXPECT_EQ(status["level"], "warning");
  EXPECT_EQ(status["id"], 5);
}

TEST_F(OperationsTest, AdvertisementsAreLimited) {
  for (std::size_t i = 0; i < Limits{}.advertisements; ++i) {
    client->send({{"op", "advertise"}, {"id", i}, {"topic", "/cmd_vel"}, {"type", "geometry_msgs/Twist"}});
  }
  EXPECT_THAT(client->receive(), IsEmpty());
  EXPECT_THAT(client->refusal_of({{"op", "advertise"}, {"id", "x"}, {"topic", "/cmd_vel"}}),
              HasSubstr("unadvertise first"));
}

TEST_F(OperationsTest, LevelSaysWhichStatusesAreSent) {
  const auto statuses = [&] {
    client->send({{"op", "dance"}});                                // error
    client->send({{"op", "unsubscribe"}, {"topic", "/zmp"}});       // warning
    client->send({{"op", "auth"}, {"token", "of no importance"}});  // info
    std::string levels;
    for (const json& status : client->receive()) {
      levels += status["level"].get<std::string>() + " ";
    }
    return levels;
  };
  EXPECT_EQ(statuses(), "error warning ");
  client->send({{"op", "set_level"}, {"level", "info"}});
  EXPECT_EQ(statuses(), "error warning info ");
  client->send({{"op", "set_level"}, {"level", "error"}});
  EXPECT_EQ(statuses(), "error ");
  client->send({{"op", "set_level"}, {"level", "none"}});
  EXPECT_EQ(statuses(), "");
}

TEST_F(OperationsTest, WhatAClientTellsAboutItselfIsTaken) {
  client->send({{"op", "status"}, {"level", "error"}, {"msg", "I feel ill"}});
  EXPECT_THAT(client->receive(), IsEmpty());
}

TEST_F(OperationsTest, CountsWhatItRefuses) {
  client->send({{"op", "dance"}});
  client->drive(0.1);
  EXPECT_EQ(hub.statistics().messages, 2U);
  EXPECT_EQ(hub.statistics().refused, 1U);
}

}  // namespace
}  // namespace gaitway::api
