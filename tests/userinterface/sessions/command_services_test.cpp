// Who may take the command of the robot and let it go, where the head is told to look, and a mission's
// orders.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "test_client.hpp"

namespace gaitway::api {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class CommandServicesTest : public HubTest {
 protected:
  void call_later(const std::string& service, const json& arguments = json::object()) {
    client->send({{"op", "call_service"}, {"id", "c"}, {"service", service}, {"args", arguments}});
  }
  json finish(bool done, const std::string& text) {
    robot.results.push_back({robot.last_number, done, text});
    step();
    return client->receive_one();
  }
  std::string failure(const std::string& service, const json& arguments) {
    const json response = client->call(service, arguments);
    EXPECT_EQ(response["result"], false) << response.dump();
    return response["values"].is_string() ? response["values"].get<std::string>() : response.dump();
  }

  std::unique_ptr<TestClient> client = connect("anna");
};

TEST_F(CommandServicesTest, TakesAndLetsGoAndPassesOnWhatTheRobotSays) {
  call_later("/command/take");
  EXPECT_EQ(robot.told.back(), "take_command");
  EXPECT_EQ(finish(true, "a person commands")["values"],
            (json{{"success", true}, {"message", "a person commands"}}));
  call_later("/command/let_go");
  EXPECT_EQ(robot.told.back(), "let_command_go");
  EXPECT_EQ(finish(false, "an emergency stop is in force")["values"],
            (json{{"success", false}, {"message", "an emergency stop is in force"}}));
}

TEST_F(CommandServicesTest, OnlyWhoCommandsAmongPeopleMay) {
  const auto other = connect("bert");
  const json lease = other->call("/command/acquire", {{"name", "bert"}});
  ASSERT_EQ(lease["values"]["success"], true);
  const std::size_t told = robot.told.size();
  for (const auto& [service, arguments] : {std::pair<const char*, json>{"/command/take", json::object()},
                                           {"/command/let_go", json::object()},
                                           {"/head/look", {{"mode", "ahead"}}},
                                           {"/behaviour/start", {{"mission", "patrol"}}},
                                           {"/behaviour/end", json::object()},
                                           {"/behaviour/change", json::object()}}) {
    const json response = client->call(service, arguments);
    EXPECT_EQ(response["values"]["success"], false) << service;
    EXPECT_THAT(response["values"]["message"].get<std::string>(), HasSubstr("bert")) << service;
  }
  EXPECT_EQ(robot.told.size(), told);
}

// The stand that ends a walk is an order of a person's, and would take the command from the behaviour.
TEST_F(CommandServicesTest, NoStandFollowsOnceTheCommandIsLetGo) {
  client->send({{"op", "publish"}, {"topic", "/cmd_vel"}, {"msg", {{"linear", {{"x", 0.1}}}}}});
  ASSERT_THAT(robot.told, Contains("walk"));
  call_later("/command/let_go");
  finish(true, "");
  call_later("/walk_to", {{"x", 1.0}, {"y", 0.0}, {"yaw", 0.0}});
  finish(true, "");
  call_later("/command/let_go");
  finish(true, "");
  pass(10 * kSecond_ns);
  client.reset();
  EXPECT_THAT(robot.told, Not(Contains("stand")));
}

TEST_F(CommandServicesTest, NothingButAMissionIsOrderedInAnEmergencyStop) {
  robot.is_emergency_stopped = true;
  for (const char* const service : {"/command/take", "/command/let_go", "/head/look"}) {
    const json response = client->call(service, json::object());
    EXPECT_THAT(response["values"]["message"].get<std::string>(), HasSubstr("/release")) << service;
  }
  call_later("/behaviour/end");
  EXPECT_EQ(robot.told.back(), "mission 1 ");
}

TEST_F(CommandServicesTest, LooksWhereItIsTold) {
  call_later("/head/look",
             {{"mode", "scan"}, {"yaw", 0.25}, {"pitch", -0.5}, {"extent", 0.75}, {"period", 4.0}});
  EXPECT_EQ(finish(true, "")["values"]["success"], true);
  ASSERT_EQ(robot.looks.size(), 1U);
  EXPECT_EQ(robot.looks[0].mode, LookMode::scan);
  EXPECT_EQ(robot.looks[0].yaw_rad, 0.25);
  EXPECT_EQ(robot.looks[0].pitch_rad, -0.5);
  EXPECT_EQ(robot.looks[0].extent_rad, 0.75);
  EXPECT_EQ(robot.looks[0].period_s, 4.0);
  call_later("/head/look", {{"mode", "point"}, {"x", 1.5}, {"y", -2.0}, {"z", 0.5}, {"speed", 3.0}});
  finish(true, "");
  ASSERT_EQ(robot.looks.size(), 2U);
  EXPECT_EQ(robot.looks[1].mode, LookMode::point);
  EXPECT_EQ(robot.looks[1].x_m, 1.5);
  EXPECT_EQ(robot.looks[1].y_m, -2.0);
  EXPECT_EQ(robot.looks[1].z_m, 0.5);
  EXPECT_EQ(robot.looks[1].speed_rad_per_s, 3.0);
  call_later("/head/look");
  finish(true, "");
  EXPECT_EQ(robot.looks.back().mode, LookMode::ahead);
}

TEST_F(CommandServicesTest, WhereItCannotLookIsRefusedByName) {
  EXPECT_THAT(failure("/head/look", {{"mode", "up"}}),
              testing::AllOf(HasSubstr("mode is \"up\""), HasSubstr("\"direction\"")));
  EXPECT_THAT(failure("/head/look", {{"mode", "direction"}, {"yaw", 3.3}}),
              HasSubstr("yaw is 3.3, but must be from -3.2 to 3.2 rad"));
  EXPECT_THAT(failure("/head/look", {{"mode", "direction"}, {"pitch", -4}}), HasSubstr("pitch is -4"));
  EXPECT_THAT(failure("/head/look", {{"mode", "scan"}}), HasSubstr("extent is 0 rad"));
  EXPECT_THAT(failure("/head/look", {{"mode", "scan"}, {"extent", -0.1}}), HasSubstr("extent is -0.1"));
  EXPECT_THAT(failure("/head/look", {{"mode", "scan"}, {"extent", 0.1}, {"period", 601}}),
              HasSubstr("period is 601.0, but must be from 0.0 to 600.0 s"));
  EXPECT_THAT(failure("/head/look", {{"mode", "point"}, {"z", 1e6}}), HasSubstr("z is 1000000"));
  EXPECT_THAT(failure("/head/look", {{"speed", -1}}), HasSubstr("speed is -1"));
  EXPECT_THAT(failure("/head/look", {{"mode", "direction"}, {"yaw", "left"}}), HasSubstr("yaw"));
  EXPECT_TRUE(robot.looks.empty());
}

TEST_F(CommandServicesTest, MissionsAreStartedEndedAndChanged) {
  call_later("/behaviour/start", {{"mission", "patrol"}});
  EXPECT_EQ(robot.told.back(), "mission 0 patrol");
  EXPECT_EQ(finish(false, "patrol.xml:3: no node 'Wlak'")["values"]["message"],
            "patrol.xml:3: no node 'Wlak'");
  call_later("/behaviour/start");
  EXPECT_EQ(robot.told.back(), "mission 0 ") << "the one that is loaded";
  finish(true, "");
  call_later("/behaviour/end");
  EXPECT_EQ(robot.told.back(), "mission 1 ");
  finish(true, "");
  call_later("/behaviour/change");
  EXPECT_EQ(robot.told.back(), "mission 2 ");
  finish(true, "");
  const std::size_t told = robot.told.size();
  EXPECT_THAT(failure("/behaviour/start", {{"mission", std::string(256, 'a')}}),
              HasSubstr("at most 255 bytes"));
  EXPECT_THAT(failure("/behaviour/start", {{"mission", "a\nb"}}), HasSubstr("mission is"));
  EXPECT_EQ(robot.told.size(), told);
}

}  // namespace
}  // namespace gaitway::api
