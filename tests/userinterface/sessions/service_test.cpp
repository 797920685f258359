// Calls of services: arguments, answers at once and later, and rosapi as clients use it.
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
using testing::SizeIs;

HubOptions with_parameters() {
  HubOptions options;
  options.parameters = {{"stability:dcm_gain", "1.5"}, {"trajectory:step_height", "0.02 m"}};
  return options;
}

class ServiceTest : public HubTest {
 protected:
  explicit ServiceTest(HubOptions options = with_parameters()) : HubTest(std::move(options)) {}

  static json values(const json& response) {
    EXPECT_EQ(response["result"], true) << response.dump();
    return response["values"];
  }
  static std::string failure(const json& response) {
    EXPECT_EQ(response["result"], false) << response.dump();
    return response["values"];
  }
  void call_later(const std::string& service, const json& arguments, const json& id = "c") {
    client->send({{"op", "call_service"}, {"id", id}, {"service", service}, {"args", arguments}});
  }
  // Of a service that is answered by the next step.
  json call_and_step(const std::string& service, const json& arguments = json::object()) {
    call_later(service, arguments);
    step();
    return client->receive_one();
  }
  void finish(bool done, const std::string& text) {
    robot.results.push_back({robot.last_number, done, text});
    step();
  }

  std::unique_ptr<TestClient> client = connect("anna");
};

TEST_F(ServiceTest, AnswersBearServiceAndId) {
  client->send({{"op", "call_service"}, {"id", 7}, {"service", "rosapi/get_time"}});
  const json response = client->receive_one();
  EXPECT_EQ(response["op"], "service_response");
  EXPECT_EQ(response["id"], 7);
  EXPECT_EQ(response["service"], "rosapi/get_time") << "as the client wrote it";
  client->send({{"op", "call_service"}, {"service", "/rosapi/get_time"}});
  EXPECT_FALSE(client->receive_one().contains("id"));
}

TEST_F(ServiceTest, AnswersInCborWhereAsked) {
  client->send({{"op", "call_service"}, {"id", "x"}, {"service", "/rosapi/topics"}, {"compression", "cbor"}});
  const auto frame = client->next_frame();
  ASSERT_TRUE(frame && frame->binary);
  const json response = json::from_cbor(*frame->bytes);
  EXPECT_EQ(response["id"], "x");
  EXPECT_EQ(response["result"], true);
  EXPECT_THAT(response["values"]["topics"], Contains("/zmp"));
  client->send({{"op", "call_service"}, {"service", "/nothing"}, {"compression", "cbor"}});
  EXPECT_EQ(client->receive_one()["result"], false);
}

TEST_F(ServiceTest, LongAnswersComeInFragmentsWhereAsked) {
  client->send({{"op", "call_service"}, {"service", "/rosapi/topics"}, {"fragment_size", 200}});
  std::string whole;
  for (const json& fragment : client->receive()) {
    whole += fragment["data"].get<std::string>();
  }
  EXPECT_THAT(json::parse(whole)["values"]["topics"], Contains("/zmp"));
}

TEST_F(ServiceTest, UnknownServicesFail) {
  for (const char* const name : {"/dance", "/stand/", "//stand", "/../stand", "/STAND", "stop; reboot"}) {
    EXPECT_THAT(failure(client->call(name)), HasSubstr("/rosapi/services")) << name;
  }
  EXPECT_THAT(robot.told, IsEmpty());
}

TEST_F(ServiceTest, ArgumentsComeByNameOrInOrder) {
  call_later("/move_joint", {{"joint", "left_knee"}, {"position", 0.5}, {"duration", 1.5}});
  EXPECT_EQ(robot.moved_joint, "1 0.500000 1.500000");
  call_later("/move_joint", {"neck_yaw", -0.5, 2});
  EXPECT_EQ(robot.moved_joint, "0 -0.500000 2.000000");
}

TEST_F(ServiceTest, BadArgumentsAreRefusedClearly) {
  const auto why = [this](const json& arguments) { return failure(client->call("/move_joint", arguments)); };
  EXPECT_THAT(why({{"joint", "tail"}, {"position", 0}, {"duration", 1}}), HasSubstr("joint is \"tail\""));
  EXPECT_THAT(why({{"joint", "left_knee"}, {"position", -0.1}, {"duration", 1}}),
              HasSubstr("from 0.0 to 2.0 rad"));
  EXPECT_THAT(why({{"joint", "left_knee"}, {"position", 1}, {"duration", 0}}), HasSubstr("duration is 0.0"));
  EXPECT_THAT(why({{"joint", "left_knee"}, {"position", 1}, {"duration", 1e300}}),
              HasSubstr("at most 60.0 s"));
  EXPECT_THAT(why({{"joint", 7}}), HasSubstr("joint"));
  EXPECT_THAT(why({{"knee", 7}}), HasSubstr("knee"));
  EXPECT_THAT(why({1, 2, 3, 4}), HasSubstr("the service takes 3"));
  EXPECT_THAT(why("left_knee"), HasSubstr("args is \"left_knee\""));
  EXPECT_THAT(robot.told, IsEmpty());
  EXPECT_EQ(hub.statistics().commander, "") << "a bad call does not take the command";
}

TEST_F(ServiceTest, OrdersAreAnsweredWhenTheRobotHasSaidWhatBecameOfThem) {
  call_later("/stop", json::object(), "s");
  EXPECT_THAT(client->receive(), IsEmpty());
  finish(true, "the robot stands");
  const json response = client->receive_one();
  EXPECT_EQ(response["id"], "s");
  EXPECT_EQ(response["result"], true);
  EXPECT_EQ(response["values"], (json{{"success", true}, {"message", "the robot stands"}}));
}

TEST_F(ServiceTest, OrdersThatFailSaySo) {
  call_later("/move_joint", {"neck_yaw", 0.1, 1.0});
  finish(false, "the robot walks");
  EXPECT_EQ(values(client->receive_one()), (json{{"success", false}, {"message", "the robot walks"}}));
}

TEST_F(ServiceTest, OrdersAreAnsweredInAnyOrder) {
  call_later("/stop", json::object(), 1);
  call_later("/stop", json::object(), 2);
  robot.results.push_back({2, true, "second"});
  robot.results.push_back({99, true, "nobody asked"});
  robot.results.push_back({1, true, "first"});
  step();
  const auto responses = client->receive();
  ASSERT_THAT(responses, SizeIs(2));
  EXPECT_EQ(responses[0]["id"], 2);
  EXPECT_EQ(responses[0]["values"]["message"], "second");
  EXPECT_EQ(responses[1]["id"], 1);
}

TEST_F(ServiceTest, OrdersWithoutAnAnswerTimeOut) {
  call_later("/stop", json::object());
  pass(Limits{}.answer_ns - 10 * kMillisecond_ns);
  EXPECT_THAT(client->receive(), IsEmpty());
  pass(10 * kMillisecond_ns);
  EXPECT_THAT(failure(client->receive_one()), HasSubstr("within 10.0 s"));
  finish(true, "too late");
  EXPECT_THAT(client->receive(), IsEmpty());
}

TEST_F(ServiceTest, ClientsMayWaitForLess) {
  client->send({{"op", "call_service"}, {"service", "/stop"}, {"timeout", 0.5}});
  pass(500 * kMillisecond_ns);
  EXPECT_THAT(failure(client->receive_one()), HasSubstr("within 0.5 s"));
}

TEST_F(ServiceTest, AnswersToThoseWhoHaveGoneAreForgotten) {
  call_later("/stop", json::object());
  client->disconnect();
  finish(true, "the robot stands");
  client = connect("bert");
  EXPECT_THAT(client->receive(), IsEmpty());
}

TEST_F(ServiceTest, AFullWayToTheRobotIsTold) {
  robot.is_blocked = true;
  EXPECT_THAT(values(client->call("/stop"))["message"], HasSubstr("try again"));
  EXPECT_THAT(values(client->call("/plugins/reload", {{"name", "stability"}}))["message"],
              HasSubstr("try again"));
}

TEST_F(ServiceTest, OrdersOfOneClientThatWaitAreLimitedButStopsAreNot) {
  for (int i = 0; i < 32; ++i) {
    call_later("/plugins/reload", {{"name", "stability"}});
  }
  EXPECT_THAT(client->receive(), IsEmpty());
  EXPECT_THAT(values(client->call("/plugins/reload", {{"name", "stability"}}))["message"],
              HasSubstr("waits for 32 answers"));
  call_later("/stop", json::object());
  EXPECT_EQ(robot.told.back(), "stand");
}

TEST_F(ServiceTest, PlugInsAreListed) {
  const json response = values(client->call("/plugins/list"));
  EXPECT_EQ(response["plugins"][0]["name"], "stability");
  EXPECT_EQ(response["plugins"][0]["steps"], 7);
  EXPECT_EQ(response["plugins"][0]["worst_step_us"], 12.5);
}

TEST_F(ServiceTest, PlugInsAreChanged) {
  call_later("/plugins/reload", {{"name", "stability"}, {"library", "build/libnew.so"}});
  finish(true, "reloaded");
  EXPECT_EQ(values(client->receive_one())["message"], "reloaded");
  call_later("/plugins/load", {{"name", "vision"}});
  call_later("/plugins/unload", {{"name", "stability"}});
  ASSERT_THAT(robot.orders, SizeIs(3));
  EXPECT_EQ(robot.orders[0].verb, PluginVerb::reload);
  EXPECT_EQ(robot.orders[0].library, "build/libnew.so");
  EXPECT_EQ(robot.orders[1].verb, PluginVerb::load);
  EXPECT_EQ(robot.orders[1].plugin, "vision");
  EXPECT_EQ(robot.orders[2].verb, PluginVerb::unload);
}

TEST_F(ServiceTest, UnknownPlugInsAndTrickyNamesAreRefused) {
  EXPECT_THAT(failure(client->call("/plugins/reload", {{"name", "vision"}})), HasSubstr("/plugins/list"));
  EXPECT_THAT(failure(client->call("/plugins/get_parameters", {{"plugin", ""}})), HasSubstr("/plugins/list"));
  for (const std::string& name :
       {std::string(""), std::string("../api"), std::string(".hidden"), std::string("a b"),
        std::string("a\0b", 3), std::string(65, 'x'), std::string("caf\xC3\xA9")}) {
    EXPECT_THAT(failure(client->call("/plugins/load", {{"name", name}})), HasSubstr("name is")) << name;
  }
  EXPECT_THAT(
      failure(client->call("/plugins/load", {{"name", "x"}, {"library", std::string("/lib/a\0.so", 10)}})),
      HasSubstr("control characters"));
  EXPECT_THAT(failure(client->call("/plugins/load", {{"name", "x"}, {"library", std::string(400, 'x')}})),
              HasSubstr("at most 399 bytes"));
  EXPECT_THAT(robot.orders, IsEmpty());
}

TEST_F(ServiceTest, ParametersAreReadOneByOne) {
  call_later("/plugins/get_parameters", {{"plugin", "stability"}});
  EXPECT_EQ(robot.orders.back().verb, PluginVerb::describe_parameter);
  finish(true, "dcm_gain\t1.7\t\tlive\tgain");
  EXPECT_THAT(client->receive(), IsEmpty());
  EXPECT_EQ(robot.orders.back().index, 1U);
  finish(true, "limit\t0.1 rad\trad\t\tof trims \xff");
  finish(false, "stability has 2 parameters");
  const json response = values(client->receive_one());
  EXPECT_EQ(response["success"], true);
  EXPECT_EQ(response["names"], (json{"dcm_gain", "limit"}));
  EXPECT_EQ(response["values"], (json{"1.7", "0.1 rad"}));
  EXPECT_EQ(response["units"], (json{"", "rad"}));
  EXPECT_EQ(response["docs"], (json{"gain", "of trims \uFFFD"}));
  EXPECT_EQ(response["live"], (json{true, false}));
  EXPECT_EQ(values(client->call("/rosapi/get_param", {{"name", "stability:dcm_gain"}}))["value"], "1.7");
}

TEST_F(ServiceTest, TheNamesOfAllPlugInsParametersAreListed) {
  call_later("/rosapi/get_param_names", json::object());
  std::size_t plugins = 0;
  for (; client->receive().empty() && plugins < 10; ++plugins) {
    const std::string plugin = robot.orders.back().plugin;
    EXPECT_EQ(robot.orders.back().index, 0U);
    finish(true, "first\t1\t1\t\t");
    finish(true, "second\t1\t1\t\t");
    EXPECT_EQ(robot.orders.back().plugin, plugin);
    finish(false, "has 2 parameters");
  }
  EXPECT_EQ(plugins, robot.plugin_list.size());
  const std::size_t orders = robot.orders.size();
  const json names = values(client->call("/rosapi/get_param_names"))["names"];
  for (const PluginStatus& plugin : robot.plugin_list) {
    EXPECT_THAT(names.dump(), HasSubstr(plugin.name + ":first"));
    EXPECT_THAT(names.dump(), HasSubstr(plugin.name + ":second"));
  }
  EXPECT_EQ(robot.orders.size(), orders) << "read once";
}

TEST_F(ServiceTest, EndlessParametersEnd) {
  call_later("/plugins/get_parameters", {{"plugin", "stability"}});
  for (int i = 0; i < 256; ++i) {
    finish(true, "again\t\t\t\t");
  }
  EXPECT_THAT(values(client->receive_one())["names"], SizeIs(256));
}

TEST_F(ServiceTest, ParametersAreSetAndRemembered) {
  call_later("/plugins/set_parameter", {{"plugin", "stability"}, {"parameter", "dcm_gain"}, {"value", "2"}});
  EXPECT_EQ(robot.orders.back().verb, PluginVerb::set_parameter);
  EXPECT_EQ(robot.orders.back().value, "2");
  const auto known = [this] {
    return values(client->call("/rosapi/get_param", {{"name", "stability:dcm_gain"}}))["value"];
  };
  EXPECT_EQ(known(), "1.5") << "not done yet";
  finish(true, "set");
  client->receive();
  EXPECT_EQ(known(), "2");
  call_later("/rosapi/set_param", {{"name", "stability:dcm_gain"}, {"value", "2.5"}});
  EXPECT_EQ(robot.orders.back().parameter, "dcm_gain");
  finish(false, "not while walking");
  EXPECT_EQ(values(client->receive_one()), (json{{"successful", false}, {"reason", "not while walking"}}));
  EXPECT_EQ(known(), "2");
}

TEST_F(ServiceTest, WalksToPlacesAndPassesOnWhyNot) {
  call_later("/walk_to", {{"x", 1.5}, {"y", -0.5}, {"yaw", 3.0}});
  EXPECT_EQ(robot.told.back(), "walk_to 1.500000 -0.500000 3.000000");
  finish(true, "");
  EXPECT_EQ(values(client->receive_one())["success"], true);
  call_later("/walk_to", {{"x", 9.0}, {"y", 0.0}, {"yaw", 0.0}});
  finish(false, "goal_outside_map: the goal lies outside of the map");
  EXPECT_EQ(values(client->receive_one())["message"], "goal_outside_map: the goal lies outside of the map");
  call_later("/walk_to/cancel", json::object());
  EXPECT_EQ(robot.told.back(), "leave_way");
  finish(true, "");
  EXPECT_EQ(values(client->receive_one())["success"], true);
  const std::size_t told = robot.told.size();
  for (const json& place :
       {json{{"x", 1001.0}, {"y", 0.0}, {"yaw", 0.0}}, json{{"x", 0.0}, {"y", 0.0}, {"yaw", 101.0}},
        json{{"x", "1"}, {"y", 0.0}, {"yaw", 0.0}}, json{{"x", nullptr}, {"y", 0.0}, {"yaw", 0.0}}}) {
    EXPECT_EQ(client->call("/walk_to", place)["result"], false) << place;
  }
  EXPECT_EQ(robot.told.size(), told);
}

// It goes on without the command being renewed, but not without who gave it.
TEST_F(ServiceTest, AWayEndsWhenWhoGaveItHasGone) {
  call_later("/walk_to", {{"x", 1.0}, {"y", 0.0}, {"yaw", 0.0}});
  finish(true, "");
  client->receive();
  const std::size_t told = robot.told.size();
  pass(3 * kSecond_ns);
  EXPECT_EQ(robot.told.size(), told) << "the lease of the command has run out";
  client.reset();
  EXPECT_EQ(robot.told.back(), "stand");
}

TEST_F(ServiceTest, PlaysMotionsAndPassesOnWhyNot) {
  call_later("/play_motion", {{"motion", "wave"}});
  EXPECT_EQ(robot.told.back(), "play_motion wave");
  finish(true, "'wave' begins");
  EXPECT_EQ(values(client->receive_one()), (json{{"success", true}, {"message", "'wave' begins"}}));
  call_later("/play_motion", {{"motion", "jump"}});
  finish(false, "there is no motion 'jump'");
  EXPECT_EQ(values(client->receive_one())["message"], "there is no motion 'jump'");
  const std::size_t told = robot.told.size();
  for (const std::string& name : {std::string(), std::string(48, 'a'), std::string("a\nb")}) {
    EXPECT_EQ(client->call("/play_motion", {{"motion", name}})["result"], false) << name;
  }
  EXPECT_EQ(robot.told.size(), told);
}

TEST_F(ServiceTest, RecordsUnderPlainNamesOnly) {
  EXPECT_EQ(values(call_and_step("/recording/start", {{"name", "walk-1.a_b"}}))["file"],
            "/recordings/walk-1.a_b.mcap");
  EXPECT_EQ(values(call_and_step("/recording/start", {{"name", "other"}}))["success"], false);
  EXPECT_EQ(values(call_and_step("/recording/stop"))["message"], "/recordings/walk.mcap");
  EXPECT_EQ(values(call_and_step("/recording/stop"))["success"], false);
  for (const std::string& name : {std::string("../walk"), std::string("/etc/passwd"), std::string(".walk"),
                                  std::string("a/b"), std::string("a\0b", 3), std::string(65, 'x')}) {
    EXPECT_THAT(failure(client->call("/recording/start", {{"name", name}})), HasSubstr("name is")) << name;
  }
  EXPECT_FALSE(robot.recording);
}

TEST_F(ServiceTest, ListsTheNewestRecordingsAndSaysHowManyThereAre) {
  EXPECT_EQ(values(call_and_step("/recording/list"))["message"], "there are no recordings");
  robot.recording_list = {{"/recordings/b.mcap", 2'000, 1'700'000'000'500'000'000},
                          {"/recordings/a.mcap", 1'000, 1'600'000'000'000'000'000}};
  json answer = values(call_and_step("/recording/list"));
  EXPECT_EQ(answer["success"], true);
  EXPECT_EQ(answer["message"], "");
  EXPECT_EQ(answer["recordings"], json::parse(R"([
      {"file": "/recordings/b.mcap", "bytes": 2000, "start": {"sec": 1700000000, "nanosec": 500000000}},
      {"file": "/recordings/a.mcap", "bytes": 1000, "start": {"sec": 1600000000, "nanosec": 0}}])"));
  robot.recording_list.resize(250);
  answer = values(call_and_step("/recording/list"));
  EXPECT_THAT(answer["recordings"], SizeIs(100));
  EXPECT_EQ(answer["message"], "the newest 100 of 250 recordings");
}

TEST_F(ServiceTest, EveryServiceAnswersItsExample) {
  for (const ServiceRow& row : kServices) {
    client->send({{"op", "call_service"}, {"service", row.name}, {"args", json::parse(row.example)}});
    auto messages = client->receive();
    for (int i = 0; i < 5 && messages.empty(); ++i, messages = client->receive()) {
      simulation.finish(true, "");
      finish(i == 0, R"({"name": "x"})");
    }
    ASSERT_THAT(messages, SizeIs(1)) << row.name;
    EXPECT_EQ(messages[0]["result"], true) << row.name << ": " << messages[0].dump();
    robot.recording = true;  // so that it can be stopped
  }
}

TEST_F(ServiceTest, RosapiTellsTopicsAndTypes) {
  const json topics = values(client->call("/rosapi/topics"));
  ASSERT_EQ(topics["topics"].size(), kTopicCount + 1);
  EXPECT_EQ(topics["types"].size(), kTopicCount + 1);
  EXPECT_THAT(topics["topics"], Contains("/cmd_vel"));
  const json raw = values(client->call("/rosapi/topics_and_raw_types"));
  EXPECT_EQ(raw["topics"], topics["topics"]);
  EXPECT_THAT(raw["typedefs_full_text"][0].get<std::string>(), HasSubstr("float64[] position"));
  EXPECT_EQ(values(client->call("/rosapi/topic_type", {{"topic", "/cmd_vel"}}))["type"],
            "geometry_msgs/msg/Twist");
  EXPECT_EQ(values(client->call("/rosapi/topic_type", {{"topic", "/none"}}))["type"], "");
  EXPECT_EQ(
      values(client->call("/rosapi/topics_for_type", {{"type", "geometry_msgs/PointStamped"}}))["topics"],
      (json{"/zmp", "/zmp/reference", "/com"}));
}

TEST_F(ServiceTest, RosapiTellsServicesNodesAndDetails) {
  EXPECT_EQ(values(client->call("/rosapi/services"))["services"].size(), kServices.size());
  EXPECT_EQ(values(client->call("/rosapi/service_type", {{"service", "/stop"}}))["type"],
            "std_srvs/srv/Trigger");
  EXPECT_THAT(values(client->call("/rosapi/services_for_type", {{"type", "std_srvs/Trigger"}}))["services"],
              Contains("/stop"));
  EXPECT_EQ(values(client->call("/rosapi/nodes"))["nodes"], (json{"/gaitway"}));
  const json node = values(client->call("/rosapi/node_details", {{"node", "/gaitway"}}));
  EXPECT_EQ(node["subscribing"], (json{"/cmd_vel"}));
  EXPECT_EQ(node["publishing"].size(), kTopicCount);
  EXPECT_EQ(values(client->call("/rosapi/publishers", {{"topic", "/zmp"}}))["publishers"],
            (json{"/gaitway"}));
  EXPECT_EQ(values(client->call("/rosapi/subscribers", {{"topic", "/zmp"}}))["subscribers"], json::array());
  const json details = values(client->call("/rosapi/message_details", {{"type", "geometry_msgs/Twist"}}));
  EXPECT_EQ(details["typedefs"][0]["fieldnames"], (json{"linear", "angular"}));
  const json request =
      values(client->call("/rosapi/service_request_details", {{"type", "std_srvs/SetBool"}}));
  EXPECT_EQ(request["typedefs"][0]["fieldnames"], (json{"data"}));
  EXPECT_THAT(failure(client->call("/rosapi/message_details", {{"type", "x/Y"}})),
              HasSubstr("type is \"x/Y\""));
}

TEST_F(ServiceTest, RosapiTellsTimeAndParameters) {
  robot.time_ns = 12 * kSecond_ns + 345;
  const json time = values(client->call("/rosapi/get_time"))["time"];
  EXPECT_EQ(time["sec"], 12);
  EXPECT_EQ(time["nanosec"], 345);
  const json gain = values(client->call("/rosapi/get_param", {{"name", "stability:dcm_gain"}}));
  EXPECT_EQ(json::parse(gain["value"].get<std::string>()), 1.5);
  const json height = values(client->call("/rosapi/get_param", {{"name", "trajectory:step_height"}}));
  EXPECT_EQ(json::parse(height["value"].get<std::string>()), "0.02 m");
  const json none = values(client->call("/rosapi/get_param", {{"name", "none"}}));
  EXPECT_EQ(json({none["successful"], none["value"]}), json({false, "null"})) << "clients parse the value";
  EXPECT_EQ(values(client->call("/rosapi/has_param", {{"name", "none"}}))["exists"], false);
  EXPECT_EQ(values(client->call("/rosapi/delete_param", {{"name", "stability:dcm_gain"}}))["successful"],
            false);
}

}  // namespace
}  // namespace gaitway::api
