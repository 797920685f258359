// Services that have the simulation's time and its state: what they ask of the simulator, what they answer,
// and the state that is published.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "gaitway/api/service_table.hpp"
#include "simulation_client.hpp"

namespace gaitway::api {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class SimulationServicesTest : public SimulationClientTest {
 protected:
  std::string failure(const std::string& service, const json& arguments = json::object()) {
    const json response = response_of(service, arguments);
    EXPECT_EQ(response["result"], false) << response.dump();
    return response["values"].is_string() ? response["values"].get<std::string>() : "";
  }
  // The code of simulation_interfaces and its text.
  std::pair<int, std::string> result(const std::string& service, const json& arguments = json::object()) {
    const json answer = call(service, arguments)["result"];
    return {answer["result"], answer["error_message"]};
  }
  std::pair<int, std::string> set_state(int target) {
    return result("set_simulation_state", {{"state", {{"state", target}}}});
  }
};

TEST_F(SimulationServicesTest, SpeedIsSetWithinItsBounds) {
  EXPECT_EQ(call("set_speed", {{"speed", 4.5}}), (json{{"success", true}, {"message", ""}}));
  EXPECT_THAT(simulation.orders, ElementsAre(json{{"order", "speed"}, {"times", 4.5}}));
  for (const double wrong : {0.0, 0.09, 40.1, -1.0}) {
    EXPECT_THAT(failure("set_speed", {{"speed", wrong}}),
                AllOf(HasSubstr("speed is "), HasSubstr("from 0.1 to 40.0 times real time")));
  }
  EXPECT_THAT(failure("set_speed", {{"speed", "fast"}}), HasSubstr("speed is \"fast\""));
  simulation.refusals["speed"] = "it has failed";
  EXPECT_EQ(call("set_speed", {{"speed", 1}}), (json{{"success", false}, {"message", "it has failed"}}));
}

TEST_F(SimulationServicesTest, ASeekHasTimeAndTellsWhereItEnded) {
  EXPECT_EQ(call("seek", {{"time", 1.25}}), (json{{"success", true}, {"message", ""}, {"time", 1.25}}));
  EXPECT_THAT(simulation.orders, ElementsAre(json{{"order", "seek"}, {"time_s", 1.25}}));
  EXPECT_EQ(simulation.patiences_ns[0], 10 * kSecond_ns) << "the simulator simulates up to there";
  EXPECT_THAT(failure("seek", {{"time", -0.5}}), HasSubstr("time is -0.5, but must be from 0.0"));
  simulation.refusals["seek"] = "time_s is 9, but must be at most 4";
  EXPECT_EQ(call("seek", {{"time", 9}})["message"], "time_s is 9, but must be at most 4");
}

TEST_F(SimulationServicesTest, AnEventIsPassedOnAsItIs) {
  const std::string event = "{fault: {kind: jam, duration_s: 0.01}}";
  EXPECT_EQ(call("apply", {{"event", event}})["success"], true);
  EXPECT_THAT(simulation.orders, ElementsAre(json{{"order", "apply"}, {"event", event}}));
  EXPECT_THAT(failure("apply", {{"event", ""}}), HasSubstr("event has 0 bytes"));
  EXPECT_THAT(failure("apply", {{"event", std::string(3001, 'x')}}), HasSubstr("event has 3001 bytes"));
  simulation.refusals["apply"] = "kind is 'jan'. Did you mean 'jam'?";
  EXPECT_EQ(call("apply", {{"event", event}})["message"], "kind is 'jan'. Did you mean 'jam'?");
}

TEST_F(SimulationServicesTest, APlanIsSidesPlacesAndDuration) {
  const json plan = call("plan", {{"x", 1.0}, {"y", -0.5}, {"yaw", 0.25}});
  EXPECT_THAT(simulation.orders, ElementsAre(json{{"order", "plan"}, {"goal", {1.0, -0.5, 0.25}}}));
  EXPECT_EQ(plan["success"], true);
  EXPECT_EQ(plan["sides"], "AAE=") << "uint8[] are in base64, as rosbridge has it: 0, 1";
  EXPECT_EQ(plan["steps"], (json{0.1, 0.04, 0.0, 0.2, -0.04, 0.1}));
  EXPECT_EQ(plan["feet"], (json{0.0, 0.04, 0.0, 0.0, -0.04, 0.0}));
  EXPECT_EQ(plan["duration"], 3.5);
  simulation.refusals["plan"] = "there is no way: the goal is within 'table'";
  EXPECT_EQ(call("plan", {{"x", 1.0}})["message"], "there is no way: the goal is within 'table'");
  EXPECT_THAT(failure("plan", {{"x", 1001}}), HasSubstr("x is 1001.0, but must be from -1000.0 to 1000.0 m"));
}

TEST_F(SimulationServicesTest, GeometryIsToldPartByPart) {
  simulation.solids_an_answer = 2;
  const json first = call("geometry");
  EXPECT_EQ(first["geometry"], 3);
  EXPECT_EQ(first["world"], "boxes");
  EXPECT_EQ(first["total"], 3);
  EXPECT_EQ(first["floor_colour"], (json{0.5, 0.5, 0.5}));
  ASSERT_THAT(first["solids"], SizeIs(2));
  EXPECT_EQ(first["solids"][1],
            json::parse(R"({"name": "ball", "kind": "thing", "shape": "sphere", "movable": true,
                            "size": {"x": 0.1, "y": 0.1, "z": 0.1}, "colour": [0.5, 0.25, 1],
                            "pose": {"position": {"x": 0.1, "y": 0, "z": 0.05},
                                     "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}})"));
  EXPECT_THAT(call("geometry", {{"first", 2}})["solids"], SizeIs(1));
  EXPECT_THAT(failure("geometry", {{"first", -1}}), HasSubstr("first is -1"));
}

TEST_F(SimulationServicesTest, StatesAreThoseOfTheDefinition) {
  const auto state = [this](const char* word, double time_s, double recorded_s) -> int {
    simulation.state["state"] = word;
    simulation.state["time_s"] = time_s;
    simulation.state["recorded_s"] = recorded_s;
    return call("get_simulation_state")["state"]["state"];
  };
  EXPECT_EQ(state("paused", 0.0, 0.0), 0) << "stopped";
  EXPECT_EQ(state("playing", 0.0, 0.0), 1);
  EXPECT_EQ(state("paused", 0.0, 2.0), 2);
  EXPECT_EQ(state("paused", 1.0, 2.0), 2);
  simulation.state["text"] = "the model has diverged";
  EXPECT_EQ(state("failed", 1.0, 2.0), 2);
  EXPECT_EQ(result("get_simulation_state"), (std::pair(4, std::string("the model has diverged"))));
}

TEST_F(SimulationServicesTest, StatesAreChangedByTheOrdersThatTheyTake) {
  EXPECT_EQ(set_state(1).first, 1);
  EXPECT_THAT(simulation.orders, ElementsAre(json{{"order", "play"}}));
  simulation.state["state"] = "playing";
  simulation.orders.clear();
  EXPECT_EQ(set_state(1).first, 101) << "already in the target state";
  EXPECT_EQ(set_state(2).first, 1);
  EXPECT_EQ(set_state(0).first, 1);
  EXPECT_THAT(simulation.orders,
              ElementsAre(json{{"order", "pause"}}, json{{"order", "pause"}}, json{{"order", "reset"}}));
  simulation.refusals["reset"] = "it cannot be";
  EXPECT_EQ(set_state(0), (std::pair(102, std::string("it cannot be"))));
}

TEST_F(SimulationServicesTest, StatesThatCannotBeGoneToAreRefusedByTheirCodes) {
  simulation.state["time_s"] = simulation.state["recorded_s"] = 0.0;
  EXPECT_EQ(set_state(2).first, 103) << "paused out of stopped";
  EXPECT_EQ(set_state(0).first, 101);
  EXPECT_EQ(set_state(3).first, 0) << "nobody ends the simulator from here";
  EXPECT_EQ(set_state(9).first, 0);
  simulation.state["state"] = "busy";
  simulation.state["text"] = "seeks";
  EXPECT_THAT(set_state(1), testing::Pair(3, HasSubstr("seeks")));
  simulation.state["state"] = "failed";
  EXPECT_EQ(set_state(1).first, 102);
  EXPECT_THAT(simulation.orders, IsEmpty());
  EXPECT_EQ(set_state(0).first, 1) << "a reset mends it";
  EXPECT_THAT(simulation.orders, SizeIs(2));
}

TEST_F(SimulationServicesTest, StepsAreMillisecondsOfAPausedSimulation) {
  EXPECT_EQ(result("step_simulation", {{"steps", 80}}).first, 1);
  EXPECT_EQ(result("step_simulation").first, 1) << "one, by the definition";
  EXPECT_THAT(simulation.orders, ElementsAre(json{{"order", "step"}, {"milliseconds", 80}},
                                             json{{"order", "step"}, {"milliseconds", 1}}));
  EXPECT_THAT(result("step_simulation", {{"steps", 0}}), testing::Pair(4, HasSubstr("steps is 0")));
  EXPECT_EQ(result("step_simulation", {{"steps", 10'001}}).first, 4);
  simulation.state["state"] = "playing";
  EXPECT_THAT(result("step_simulation"), testing::Pair(4, HasSubstr("must be paused")));
  EXPECT_THAT(simulation.orders, SizeIs(2));
}

TEST_F(SimulationServicesTest, AResetIsOfEverything) {
  for (const int scope : {0, 7, 255}) {
    EXPECT_EQ(result("reset_simulation", {{"scope", scope}}).first, 1) << scope;
  }
  EXPECT_THAT(simulation.orders, SizeIs(3));
  EXPECT_EQ(simulation.patiences_ns[0], 10 * kSecond_ns);
  EXPECT_THAT(result("reset_simulation", {{"scope", 1}}), testing::Pair(0, HasSubstr("scope is 1")));
  EXPECT_THAT(simulation.orders, SizeIs(3));
}

TEST_F(SimulationServicesTest, FeaturesAreWhatTheServicesDo) {
  const json features = call("get_simulator_features")["features"];
  EXPECT_EQ(features["features"], (json{0, 1, 4, 8, 10, 11, 12, 14, 20, 24, 25, 26, 31, 32, 44}));
  EXPECT_EQ(features["spawn_formats"], (json{"gaitway"}));
  EXPECT_EQ(call("get_current_world")["world"]["name"], "boxes");
}

TEST_F(SimulationServicesTest, ASimulatorOfPushesAloneSaysSoAndHasNoState) {
  simulation.takes_orders = false;
  const std::string why = "this simulator takes pushes alone";
  EXPECT_EQ(call("seek", {{"time", 1}})["message"], why);
  EXPECT_EQ(result("get_simulation_state"), std::pair(4, why));
  EXPECT_EQ(result("spawn_entity", {{"name", "a"}, {"entity_resource", {{"uri", "gaitway:box"}}}}).second,
            why);
  const json features = call("get_simulator_features")["features"];
  EXPECT_THAT(features["features"], IsEmpty());
  EXPECT_EQ(features["custom_info"], why);
  simulation.state_orders = 0;
  pass(5 * kSecond_ns);
  EXPECT_FALSE(hub.take_simulation_state());
  EXPECT_LE(simulation.state_orders, 6) << "it is asked again once a second";
  simulation.takes_orders = true;
  pass(kSecond_ns + 100 * kMillisecond_ns);
  EXPECT_TRUE(hub.take_simulation_state()) << "another one may be there now";
}

TEST_F(SimulationServicesTest, TheStateComesTenTimesASecond) {
  step();
  static_cast<void>(hub.take_simulation_state());
  int states = 0;
  for (int i = 0; i < 100; ++i) {
    pass(10 * kMillisecond_ns);
    states += hub.take_simulation_state() ? 1 : 0;
  }
  EXPECT_NEAR(states, 10, 1);
  simulation.is_silent = true;
  simulation.state_orders = 0;
  pass(kSecond_ns);
  EXPECT_EQ(simulation.state_orders, 1) << "it is not asked again before it has answered";
}

TEST_F(SimulationServicesTest, TheStateIsPublishedAsTheSimulatorTellsIt) {
  client->subscribe("/simulation/state");
  pass(200 * kMillisecond_ns);
  const auto state = hub.take_simulation_state();
  ASSERT_TRUE(state);
  EXPECT_FALSE(hub.take_simulation_state()) << "each once";
  hub.publish(Topic::simulation_state, *state);
  EXPECT_EQ(client->receive_one()["msg"], json::parse(R"({
      "time": 2.5, "recorded": 4, "state": "paused", "text": "", "speed": 2, "pace": 0.98, "world": "boxes",
      "geometry": 3, "run": 1, "fallen": false, "odometry": [1, 2, 0, 0.5], "base": [0.1, 0.2, 0.3, 0, 0, 0, 1],
      "thing_names": ["ball"], "thing_poses": [{"position": {"x": 3, "y": 0, "z": 0.1},
                                                "orientation": {"x": 0, "y": 0, "z": 0, "w": 1}}],
      "mark_times": [1], "mark_kinds": ["push"], "event_times": [1], "event_texts": ["{push: {body: trunk}}"]})"));
}

TEST_F(SimulationServicesTest, AnAnswerThatIsNoneIsToldByItsField) {
  simulation.state.erase("run");
  EXPECT_THAT(failure("get_simulation_state"),
              HasSubstr("has no field \"run\", which the simulator's state must have"));
  simulation.state["run"] = "x";
  EXPECT_THAT(failure("get_simulation_state"), HasSubstr("run is \"x\", but must be a whole number"));
  simulation.state["run"] = 1;
  simulation.state["marks"][0].erase("kind");
  EXPECT_THAT(failure("get_simulation_state"), HasSubstr("marks[0] has no field \"kind\""));
  simulation.state["marks"][0]["kind"] = "push";
  simulation.state["pace"] = nullptr;
  simulation.state["newer"] = "field";
  simulation.state["marks"][0]["newer"] = 1;
  EXPECT_EQ(result("get_simulation_state").first, 1) << "not measured yet, and known to later releases alone";
  pass(2 * kSecond_ns);
  EXPECT_TRUE(hub.take_simulation_state());
}

TEST_F(SimulationServicesTest, ASilentSimulatorIsToldInTimeAndAClientThatHasGoneIsForgotten) {
  simulation.is_silent = true;
  client->send(
      {{"op", "call_service"}, {"service", "/simulation/seek"}, {"args", {{"time", 1}}}, {"timeout", 0.5}});
  pass(600 * kMillisecond_ns);
  const json late = client->receive_one();
  EXPECT_EQ(late["result"], false);
  EXPECT_THAT(late["values"], HasSubstr("the simulator has not answered within 0.5 s"));
  client->send({{"op", "call_service"}, {"service", "/simulation/get_entities"}});
  client->disconnect();
  pass(11 * kSecond_ns);
}

TEST_F(SimulationServicesTest, OneClientWaitsForSoManyAnswersAtMost) {
  simulation.is_silent = true;
  for (int i = 0; i < 33; ++i) {
    client->send({{"op", "call_service"}, {"service", "/simulation/seek"}, {"args", {{"time", 1}}}});
  }
  EXPECT_THAT(client->receive_one()["values"]["message"], HasSubstr("waits for 32 answers"));
  client->send({{"op", "call_service"}, {"service", "/simulation/get_entities"}});
  EXPECT_THAT(client->receive_one()["values"], HasSubstr("waits for 32 answers"));
}

TEST_F(SimulationServicesTest, NobodyNeedsTheCommandForThem) {
  const auto commander = connect("bert");
  commander->drive(0.1);
  EXPECT_EQ(set_state(1).first, 1);
  EXPECT_EQ(hub.commander(), "bert");
  const auto stranger = connect("carl", false);
  stranger->send({{"op", "call_service"}, {"service", "/simulation/seek"}, {"args", {{"time", 1}}}});
  step();
  EXPECT_THAT(simulation.orders, SizeIs(1)) << "who is not let in has none of it";
}

TEST_F(SimulationServicesTest, RosapiTellsTypesFieldsAndConstants) {
  EXPECT_EQ(client->call("/rosapi/topic_type", {{"topic", "/simulation/state"}})["values"]["type"],
            "gaitway_msgs/msg/SimulationState");
  EXPECT_EQ(client->call("/rosapi/service_type", {{"service", "/simulation/spawn_entity"}})["values"]["type"],
            "simulation_interfaces/srv/SpawnEntity");
  const json types =
      client->call("/rosapi/service_response_details",
                   {{"type", "simulation_interfaces/SetSimulationState"}})["values"]["typedefs"];
  ASSERT_THAT(types, SizeIs(2));
  EXPECT_EQ(types[0]["constnames"],
            (json{"ALREADY_IN_TARGET_STATE", "STATE_TRANSITION_ERROR", "INCORRECT_TRANSITION"}));
  EXPECT_EQ(types[0]["constvalues"], (json{"101", "102", "103"}));
  EXPECT_EQ(types[1]["type"], "simulation_interfaces/Result");
  EXPECT_EQ(types[1]["fieldnames"], (json{"result", "error_message"}));
  EXPECT_EQ(types[1]["constvalues"], (json{"0", "1", "2", "3", "4"}));
}

class NoSimulationServicesTest : public HubTest {
 protected:
  NoSimulationServicesTest() : HubTest({}, false) {}

  std::unique_ptr<TestClient> client = connect("anna");
};

TEST_F(NoSimulationServicesTest, AreRefusedAndNotListed) {
  for (const ServiceRow& row : kServices) {
    if (!row.of_simulation) {
      continue;
    }
    const json response = client->call(row.name, json::parse(row.example));
    EXPECT_THAT(response["values"].dump(), HasSubstr("this robot is no simulation")) << row.name;
    EXPECT_EQ(response["result"], !row.type.starts_with("simulation_interfaces/")) << row.name;
  }
  const json topics = client->call("/rosapi/topics")["values"]["topics"];
  EXPECT_THAT(topics, Not(Contains("/simulation/state")));
  EXPECT_EQ(client->call("/rosapi/topic_type", {{"topic", "/simulation/state"}})["values"]["type"], "");
  EXPECT_THAT(client->call("/rosapi/publishers", {{"topic", "/simulation/state"}})["values"]["publishers"],
              IsEmpty());
  pass(kSecond_ns);
  EXPECT_FALSE(hub.take_simulation_state());
}

}  // namespace
}  // namespace gaitway::api
