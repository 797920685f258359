// Pushes of a simulated robot: for everybody who is let in, answered when the simulator has; and a robot that
// is no simulation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "gaitway/api/service_table.hpp"
#include "test_client.hpp"

namespace gaitway::api {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

const json kPush = {{"link", "head"}, {"force", {{"x", 1.5}, {"y", -2.0}, {"z", 0.5}}}, {"duration", 0.2}};

json call_of(const json& arguments) {
  return {{"op", "call_service"}, {"id", "p"}, {"service", "/simulation/push"}, {"args", arguments}};
}

class PushTest : public HubTest {
 protected:
  std::unique_ptr<TestClient> client = connect("anna");
};

class NoSimulationTest : public HubTest {
 protected:
  NoSimulationTest() : HubTest({}, false) {}
  std::unique_ptr<TestClient> client = connect("anna");
};

TEST_F(PushTest, IsAnsweredWhenTheSimulatorHas) {
  client->send(call_of(kPush));
  step();
  EXPECT_THAT(client->receive(), IsEmpty());
  ASSERT_THAT(simulation.pushes, SizeIs(1));
  EXPECT_EQ(simulation.pushes[0].link, "head");
  EXPECT_EQ(simulation.pushes[0].force_N, (std::array{1.5, -2.0, 0.5}));
  EXPECT_EQ(simulation.pushes[0].duration_s, 0.2);
  EXPECT_FALSE(simulation.pushes[0].along_heading);
  simulation.finish(true, "the push begins");
  step();
  const json response = client->receive_one();
  EXPECT_EQ(response["id"], "p");
  EXPECT_EQ(response["values"], (json{{"success", true}, {"message", "the push begins"}}));
}

TEST_F(PushTest, RefusalsOfTheSimulatorAreToldAsTheyAre) {
  client->send(call_of(kPush));
  simulation.finish(false, "link is 'head', but must be one of the robot's");
  step();
  EXPECT_EQ(client->receive_one()["values"],
            (json{{"success", false}, {"message", "link is 'head', but must be one of the robot's"}}));
}

TEST_F(PushTest, WrongArgumentsAreRefused) {
  json wrong = kPush;
  wrong["frame"] = "tail";
  EXPECT_THAT(client->call("/simulation/push", wrong)["values"], HasSubstr("frame is \"tail\""));
  wrong["frame"] = 7;
  EXPECT_THAT(client->call("/simulation/push", wrong)["values"], HasSubstr("frame"));
  EXPECT_THAT(client->call("/simulation/push", {{"link", "head"}, {"force", 5}})["values"],
              HasSubstr("force"));
  simulation.refusal = "duration is 0.0 s, but must be from 0.01 to 2.0 s";
  const json response = client->call("/simulation/push", kPush);
  EXPECT_EQ(response["result"], false);
  EXPECT_EQ(response["values"], simulation.refusal);
  EXPECT_THAT(simulation.pushes, IsEmpty());
}

TEST_F(PushTest, TheFrameMayBeTheRobotsHeading) {
  json push = kPush;
  push["frame"] = "heading";
  client->send(call_of(push));
  ASSERT_THAT(simulation.pushes, SizeIs(1));
  EXPECT_TRUE(simulation.pushes[0].along_heading);
}

TEST_F(PushTest, WhoDoesNotCommandMayPushAndTakesNothing) {
  const auto commander = connect("bert");
  commander->drive(0.1);
  client->send(call_of(kPush));
  EXPECT_THAT(simulation.pushes, SizeIs(1));
  EXPECT_EQ(hub.commander(), "bert");
  EXPECT_THAT(robot.told, Not(Contains("stand")));
}

TEST_F(PushTest, WhoIsNotLetInPushesNothing) {
  const auto stranger = connect("carl", false);
  stranger->send(call_of(kPush));
  EXPECT_THAT(simulation.pushes, IsEmpty());
}

TEST_F(PushTest, ASimulatorThatDoesNotAnswerIsToldInTime) {
  client->send(call_of(kPush));
  pass(Limits{}.answer_ns + 20 * kMillisecond_ns);
  const json response = client->receive_one();
  EXPECT_EQ(response["result"], false);
  EXPECT_THAT(response["values"], HasSubstr("has not answered within"));
}

TEST_F(PushTest, ResultsOfTheRobotAndOfItsSimulationAreNotMixedUp) {
  client->send(call_of(kPush));
  client->send({{"op", "call_service"}, {"id", "s"}, {"service", "/stop"}});
  robot.results.push_back({robot.last_number, true, "the robot stands"});
  step();
  EXPECT_EQ(client->receive_one()["id"], "s");
  simulation.finish(true, "the push begins");
  step();
  EXPECT_EQ(client->receive_one()["id"], "p");
}

TEST_F(PushTest, OneClientWaitsForSoManyAnswersAtMost) {
  for (std::size_t i = 0; i < 40; ++i) {
    client->send(call_of(kPush));
    now_ns += 100 * kMillisecond_ns;
  }
  EXPECT_THAT(simulation.pushes, SizeIs(32));
  EXPECT_THAT(client->receive().back()["values"]["message"], HasSubstr("waits for 32 answers"));
}

TEST_F(PushTest, RosapiListsIt) {
  EXPECT_THAT(client->call("/rosapi/services")["values"]["services"], Contains("/simulation/push"));
  EXPECT_EQ(client->call("/rosapi/service_type", {{"service", "/simulation/push"}})["values"]["type"],
            "gaitway_msgs/srv/PushLink");
  EXPECT_EQ(client->call("/rosapi/service_node", {{"service", "/simulation/push"}})["values"]["node"],
            "/gaitway");
}

TEST_F(NoSimulationTest, APushIsRefusedAndNobodyListsIt) {
  const json response = client->call("/simulation/push", kPush);
  EXPECT_EQ(response["result"], true);
  EXPECT_EQ(response["values"]["success"], false);
  EXPECT_THAT(response["values"]["message"], HasSubstr("this robot is no simulation"));
  const json services = client->call("/rosapi/services")["values"]["services"];
  EXPECT_THAT(services, Not(Contains("/simulation/push")));
  EXPECT_EQ(services.size(),
            static_cast<std::size_t>(std::ranges::count(kServices, false, &ServiceRow::of_simulation)));
  const auto rosapi = [this](const char* const question, const json& arguments) {
    return client->call(std::string("/rosapi/") + question, arguments)["values"];
  };
  EXPECT_EQ(rosapi("service_type", {{"service", "/simulation/push"}})["type"], "");
  EXPECT_EQ(rosapi("service_node", {{"service", "/simulation/push"}})["node"], "");
  EXPECT_TRUE(rosapi("services_for_type", {{"type", "gaitway_msgs/srv/PushLink"}})["services"].empty());
  EXPECT_TRUE(rosapi("service_providers", {{"service", "gaitway_msgs/srv/PushLink"}})["providers"].empty());
  EXPECT_THAT(rosapi("node_details", {{"node", "/gaitway"}})["services"], Not(Contains("/simulation/push")));
}

TEST_F(NoSimulationTest, ItsNameIsTheRobotsOwnAllTheSame) {
  EXPECT_THAT(client->refusal_of({{"op", "advertise_service"},
                                  {"service", "/simulation/push"},
                                  {"type", "gaitway_msgs/srv/PushLink"}}),
              HasSubstr("the robot's own"));
}

}  // namespace
}  // namespace gaitway::api
