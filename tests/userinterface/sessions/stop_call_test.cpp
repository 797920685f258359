// A stop is told from all else before it is parsed, and what its sender sent before it moves the robot no
// more.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "test_client.hpp"

namespace gaitway::api {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class StopCallTest : public HubTest {
 protected:
  std::unique_ptr<TestClient> client = connect("anna");
};

TEST_F(StopCallTest, StopsAreUrgentHoweverTheyAreWritten) {
  for (const char* const message : {
           R"({"op": "call_service", "service": "/stop"})",
           R"({"op":"call_service","service":"stop","args":{}})",
           R"({"op":"publish","op":"call_service","service":"/stand","service":"/stop"})",
       }) {
    EXPECT_EQ(client->urgency(message), Urgency::urgent) << message;
  }
}

TEST_F(StopCallTest, EmergencyStopsAreEmergencies) {
  EXPECT_EQ(
      client->urgency(
          R"({"service":"\/emergency_stop","id":[1],"timeout":-1,"args":{"data":true},"op":"call_service"})"),
      Urgency::emergency);
}

TEST_F(StopCallTest, NothingElseIsUrgent) {
  for (const char* const message : {
           R"({"op": "call_service", "service": "/stand", "id": "stop"})",
           R"({"op": "publish", "service": "/stop"})",
           R"({"op": "publish", "topic": "/cmd_vel", "msg": {"op": "call_service", "service": "/stop"}})",
           R"({"op": "call_service", "args": {"service": "/stop"}})",
           R"({"op": "call_service", "service": ["/stop"]})",
           R"({"op": "call_service", "service": "/stop", "service": 1})",
           R"([{"op": "call_service", "service": "/stop"}])",
           R"({"op": "call_service", "service": "/stop")",
           "stop",
           "",
       }) {
    EXPECT_EQ(client->urgency(message), Urgency::none) << message;
  }
  EXPECT_EQ(client->urgency(R"({"op": "call_service", "service": "/stop"})", true), Urgency::none)
      << "binary";
}

TEST_F(StopCallTest, LongOnesAndStrangersWaitForTheirTurn) {
  const json call = {{"op", "call_service"}, {"service", "/stop"}, {"args", {{"x", std::string(2000, 'x')}}}};
  EXPECT_EQ(client->urgency(call.dump()), Urgency::none);
  const auto stranger = connect("stranger", false);
  EXPECT_EQ(stranger->urgency(R"({"op": "call_service", "service": "/stop"})"), Urgency::none);
}

TEST_F(StopCallTest, WhatAStopHasOvertakenMovesTheRobotNoMore) {
  client->call("/command/acquire");
  client->send({{"op", "call_service"}, {"service", "/emergency_stop"}});
  robot.told.clear();
  client->receive();
  client->send_overtaken({{"op", "publish"}, {"topic", "/cmd_vel"}, {"msg", {{"linear", {{"x", 0.1}}}}}});
  EXPECT_THAT(client->receive_one()["msg"], HasSubstr("has been carried out before this"));
  for (const char* const service : {"/release", "/stand"}) {
    client->send_overtaken({{"op", "call_service"}, {"service", service}, {"args", json::object()}});
    EXPECT_EQ(client->receive_one()["values"]["success"], false) << service;
  }
  EXPECT_THAT(robot.told, IsEmpty());
  client->send_overtaken({{"op", "call_service"}, {"service", "/rosapi/get_time"}});
  EXPECT_EQ(client->receive_one()["result"], true) << "what moves nothing is carried out";
  client->drive(0.1);
  EXPECT_THAT(robot.told, Contains("walk")) << "what came after it, too";
}

}  // namespace
}  // namespace gaitway::api
