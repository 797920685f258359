// Who may command the robot, as clients see it; and that nothing walks on when nobody does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gaitway/api/service_table.hpp"
#include "test_client.hpp"

namespace gaitway::api {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class CommandTest : public HubTest {
 protected:
  std::string acquire(TestClient& client, const std::string& name) {
    const json response = client.call("/command/acquire", {{"name", name}});
    EXPECT_EQ(response["result"], true);
    EXPECT_EQ(response["values"]["success"], true) << response.dump();
    return response["values"]["lease"];
  }
  static json values(const json& response) {
    EXPECT_EQ(response["result"], true) << response.dump();
    return response["values"];
  }
  static std::string refusal(const json& response) {
    EXPECT_EQ(values(response)["success"], false) << response.dump();
    return values(response)["message"];
  }

  std::unique_ptr<TestClient> anna = connect("anna"), bert = connect("bert");
};

TEST_F(CommandTest, TheFirstToDriveHasTheCommand) {
  anna->drive(0.1);
  EXPECT_EQ(hub.statistics().commander, "anna");
  bert->drive(0.2);
  EXPECT_THAT(bert->receive_one()["msg"], HasSubstr("\"anna\" has the command"));
  EXPECT_THAT(robot.told, ElementsAre("walk"));
  EXPECT_EQ(robot.velocities.back().forward_m_per_s, 0.1);
}

TEST_F(CommandTest, ServicesThatCommandTakeTheCommandToo) {
  EXPECT_EQ(values(anna->call("/stand"))["success"], true);
  EXPECT_EQ(hub.statistics().commander, "anna");
  EXPECT_THAT(refusal(bert->call("/stand")), HasSubstr("\"anna\" has the command"));
  EXPECT_THAT(robot.told, ElementsAre("stand"));
}

TEST_F(CommandTest, EveryCommandingServiceIsRefusedToOthers) {
  acquire(*anna, "anna");
  for (const ServiceRow& row : kServices) {
    if (row.needs_command) {
      const json response = values(bert->call(row.name, json::parse(row.example)));
      EXPECT_EQ(response.value("success", response.value("successful", true)), false) << row.name;
    }
  }
  EXPECT_THAT(robot.told, IsEmpty());
  EXPECT_EQ(hub.statistics().commander, "anna");
}

TEST_F(CommandTest, WatchingNeedsNoCommand) {
  acquire(*anna, "anna");
  EXPECT_EQ(values(bert->call("/plugins/list"))["success"], true);
  bert->send({{"op", "call_service"}, {"service", "/recording/start"}, {"args", {{"name", "walk"}}}});
  step();
  EXPECT_EQ(values(bert->receive_one())["success"], true);
  bert->subscribe("/zmp");
  EXPECT_THAT(bert->receive(), IsEmpty());
}

TEST_F(CommandTest, IsKeptByAliveSignsAndCommands) {
  const std::string lease = acquire(*anna, "dashboard");
  EXPECT_EQ(hub.statistics().commander, "dashboard");
  for (int i = 0; i < 5; ++i) {
    pass(900 * kMillisecond_ns);
    EXPECT_EQ(values(anna->call("/command/keep_alive", {{"lease", lease}}))["success"], true);
  }
  pass(900 * kMillisecond_ns);
  anna->drive(0.1);
  pass(900 * kMillisecond_ns);
  EXPECT_EQ(hub.statistics().commander, "dashboard");
}

TEST_F(CommandTest, LapsesWithoutThemAndTheRobotStands) {
  anna->drive(0.1);
  pass(kSecond_ns - 10 * kMillisecond_ns);
  EXPECT_THAT(robot.told, ElementsAre("walk"));
  pass(10 * kMillisecond_ns);
  EXPECT_THAT(robot.told, ElementsAre("walk", "stand"));
  EXPECT_EQ(hub.statistics().commander, "");
  bert->drive(0.2);
  EXPECT_EQ(hub.statistics().commander, "bert");
}

TEST_F(CommandTest, ACommandThatCameBeforeTheLapseWasNoticedFindsTheRobotStanding) {
  anna->drive(0.1);
  now_ns += kSecond_ns;
  robot.time_ns += kSecond_ns;
  EXPECT_EQ(values(bert->call("/stand"))["success"], true);
  EXPECT_THAT(robot.told, ElementsAre("walk", "stand", "stand"));
}

TEST_F(CommandTest, ALostConnectionStandsTheRobotAtOnce) {
  anna->drive(0.1);
  anna->disconnect();
  EXPECT_THAT(robot.told, ElementsAre("walk", "stand"));
  bert->drive(0.1);
  EXPECT_EQ(hub.statistics().commander, "bert");
}

TEST_F(CommandTest, ALossThatNobodyDroveUnderChangesNothing) {
  acquire(*anna, "anna");
  anna->disconnect();
  EXPECT_THAT(robot.told, IsEmpty());
}

TEST_F(CommandTest, GivingTheCommandBackStandsTheRobot) {
  const std::string lease = acquire(*anna, "anna");
  anna->drive(0.1);
  EXPECT_EQ(values(anna->call("/command/release", {{"lease", lease}}))["success"], true);
  EXPECT_THAT(robot.told, ElementsAre("walk", "stand"));
  EXPECT_EQ(hub.statistics().commander, "");
}

TEST_F(CommandTest, ALeaseCannotBeUsedByAnotherConnection) {
  const std::string lease = acquire(*anna, "anna");
  EXPECT_THAT(refusal(bert->call("/command/keep_alive", {{"lease", lease}})), HasSubstr("/command/acquire"));
  EXPECT_THAT(refusal(bert->call("/command/release", {{"lease", lease}})), HasSubstr("this connection's"));
  EXPECT_THAT(refusal(bert->call("/command/acquire", {{"name", "anna"}})), HasSubstr("has the command"));
  EXPECT_EQ(hub.statistics().commander, "anna");
}

TEST_F(CommandTest, ALeaseCannotBeUsedAfterAReconnect) {
  const std::string lease = acquire(*anna, "anna");
  anna = connect("anna");
  EXPECT_THAT(refusal(anna->call("/command/keep_alive", {{"lease", lease}})), HasSubstr("this connection's"));
  EXPECT_EQ(hub.statistics().commander, "");
}

TEST_F(CommandTest, AStopByDatagramEndsTheCommandOfEverybody) {
  anna->drive(0.1);
  hub.stopped_by_datagram();
  EXPECT_EQ(hub.statistics().commander, "");
  EXPECT_THAT(robot.told, ElementsAre("walk", "stand"));
  anna->drive(0.1);
  EXPECT_THAT(anna->receive_one()["msg"], HasSubstr("was stopped by somebody else"));
  EXPECT_THAT(robot.told, ElementsAre("walk", "stand"));
  acquire(*anna, "anna");
  anna->drive(0.1);
  EXPECT_THAT(robot.told, ElementsAre("walk", "stand", "walk"));
}

TEST_F(CommandTest, AnybodyMayStop) {
  anna->drive(0.1);
  bert->send({{"op", "call_service"}, {"service", "/stop"}});
  EXPECT_THAT(robot.told, ElementsAre("walk", "stop", "stand"));
  EXPECT_FALSE(robot.walking);
  EXPECT_EQ(hub.statistics().commander, "");
}

TEST_F(CommandTest, AnybodyMayStopInAnEmergency) {
  anna->drive(0.1);
  bert->send({{"op", "call_service"}, {"service", "/emergency_stop"}, {"args", {{"data", true}}}});
  EXPECT_THAT(robot.told, ElementsAre("walk", "emergency_stop soft", "stand"));
  bert->send({{"op", "call_service"}, {"service", "/emergency_stop"}, {"args", json::array({false})}});
  EXPECT_EQ(robot.told[3], "emergency_stop hold");
}

TEST_F(CommandTest, WhatMovesTheRobotIsRefusedWhileItIsEmergencyStopped) {
  robot.is_emergency_stopped = true;
  EXPECT_THAT(refusal(anna->call("/stand")), HasSubstr("call /release"));
  EXPECT_THAT(refusal(anna->call("/play_motion", {{"motion", "wave"}})), HasSubstr("call /release"));
  EXPECT_THAT(
      refusal(anna->call("/move_joint", {{"joint", "neck_yaw"}, {"position", 0.1}, {"duration", 1.0}})),
      HasSubstr("call /release"));
  anna->drive(0.1);
  EXPECT_THAT(anna->receive_one().value("msg", ""), HasSubstr("call /release"));
  EXPECT_THAT(robot.told, IsEmpty());
  EXPECT_THAT(refusal(bert->call("/stop")), HasSubstr("call /release"));
  EXPECT_THAT(robot.told, ElementsAre("stop", "stand")) << "carried out all the same";
}

TEST_F(CommandTest, TheCommanderAloneReleases) {
  robot.is_emergency_stopped = true;
  acquire(*anna, "anna");
  EXPECT_THAT(refusal(bert->call("/release")), HasSubstr("\"anna\" has the command"));
  EXPECT_THAT(robot.told, IsEmpty());
  anna->send({{"op", "call_service"}, {"service", "/release"}});
  EXPECT_THAT(robot.told, ElementsAre("release"));
}

TEST_F(CommandTest, AnEmergencyStopIsCarriedOutWhateverItsArguments) {
  for (const char* const arguments : {R"({"data": "now!"})", R"({"date": true})", "7", "null", "[1, 2, 3]"}) {
    robot.told.clear();
    bert->send({{"op", "call_service"}, {"service", "/emergency_stop"}, {"args", json::parse(arguments)}});
    EXPECT_THAT(robot.told, ElementsAre("emergency_stop hold", "stand")) << arguments;
  }
}

TEST_F(CommandTest, AStopIsCarriedOutWhateverElseIsWrongInItsMessage) {
  const auto too_long = R"({"id": ")" + std::string(300, 'x') + "\"}";
  for (const std::string& wrong :
       {std::string(R"({"timeout": -1})"), std::string(R"({"timeout": "1"})"),
        std::string(R"({"compression": "png"})"), std::string(R"({"compression": 7})"),
        std::string(R"({"fragment_size": 1})"), std::string(R"({"fragment_size": -1})"),
        std::string(R"({"id": 1.5})"), std::string(R"({"id": {}})"), too_long,
        std::string(R"({"timeout": -1, "compression": "png", "fragment_size": 1, "id": []})")}) {
    for (const char* const service : {"/emergency_stop", "emergency_stop", "/stop", "stop"}) {
      robot.told.clear();
      json message = json::parse(wrong);
      message.update({{"op", "call_service"}, {"service", service}});
      bert->send(message);
      EXPECT_THAT(robot.told, Contains(HasSubstr("stop"))) << service << wrong;
      robot.results.push_back({robot.last_number, true, "stopped"});
      step();
      std::vector<std::string> said;
      for (const json& answer : bert->receive()) {
        said.push_back(answer["op"]);
        EXPECT_EQ(answer.value("level", "warning"), "warning") << answer.dump();
      }
      EXPECT_THAT(said, Contains("status")) << service << wrong;
      EXPECT_THAT(said, Contains("service_response")) << service << wrong;
    }
  }
}

TEST_F(CommandTest, WhatIsRightInTheMessageOfAStopCountsAllTheSame) {
  bert->send(
      {{"op", "call_service"}, {"service", "/stop"}, {"id", "s"}, {"timeout", -1}, {"compression", "cbor"}});
  EXPECT_THAT(bert->receive_one().value("msg", ""), HasSubstr("timeout is -1"));
  robot.results.push_back({robot.last_number, true, "stopped"});
  step();
  const auto frame = bert->next_frame();
  ASSERT_TRUE(frame && frame->binary);
  EXPECT_EQ(json::from_cbor(*frame->bytes)["id"], "s");
}

TEST_F(CommandTest, AHeldStickDoesNotUndoAStop) {
  anna->drive(0.1);
  bert->send({{"op", "call_service"}, {"service", "/stop"}});
  for (int i = 0; i < 30; ++i) {
    pass(100 * kMillisecond_ns);
    anna->drive(0.1);
    EXPECT_THAT(anna->receive_one()["msg"], HasSubstr("was stopped by somebody else"));
  }
  EXPECT_FALSE(robot.walking);
  pass(kSecond_ns);
  anna->drive(0.1);
  EXPECT_TRUE(robot.walking);
}

TEST_F(CommandTest, WhoStoppedMayDriveOn) {
  anna->drive(0.1);
  anna->send({{"op", "call_service"}, {"service", "/stop"}});
  anna->drive(0.1);
  EXPECT_THAT(robot.told, ElementsAre("walk", "stop", "stand", "walk"));
}

// It is told from a stop: programs may wait for a robot and try again, but not for people.
TEST_F(CommandTest, AHeldStickDoesNotUndoAnAbsence) {
  anna->drive(0.1);
  hub.robot_lost();
  anna->drive(0.1);
  EXPECT_THAT(anna->receive_one()["msg"], HasSubstr("the robot was not there for a while: let go"));
  pass(kSecond_ns);
  anna->drive(0.1);
  EXPECT_THAT(robot.told, ElementsAre("walk", "walk"));
}

TEST_F(CommandTest, WhoStoppedARobotThatWasAwayMayDriveOn) {
  anna->drive(0.1);
  hub.robot_lost();
  anna->send({{"op", "call_service"}, {"service", "/stop"}});
  anna->drive(0.1);
  EXPECT_THAT(robot.told, ElementsAre("walk", "stop", "stand", "walk"));
}

TEST_F(CommandTest, IsRefusedWhileTheRobotIsNotThere) {
  robot.is_connected = false;
  anna->drive(0.1);
  EXPECT_THAT(anna->receive_one()["msg"],
              HasSubstr("the robot is not there: its message controller does not"));
  robot.silent = "main controller";
  EXPECT_THAT(refusal(anna->call("/stand")),
              HasSubstr("the robot is not there: its main controller does not"));
  EXPECT_THAT(robot.told, IsEmpty());
  robot.is_connected = true;
  anna->drive(0.1);
  EXPECT_THAT(robot.told, ElementsAre("walk"));
}

TEST_F(CommandTest, ARefusedVelocityDoesNotTakeTheCommand) {
  anna->drive(99.0);
  EXPECT_THAT(anna->receive_one()["msg"], HasSubstr("linear.x is 99.0"));
  EXPECT_EQ(hub.statistics().commander, "");
}

}  // namespace
}  // namespace gaitway::api
