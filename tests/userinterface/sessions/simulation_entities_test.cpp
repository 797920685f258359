// What is in a simulated world, as clients of simulation_interfaces see it: names, filters, states, and what
// is spawned, moved and removed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "simulation_client.hpp"

namespace gaitway::api {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;

using Outcome = std::pair<int, std::string>;

class SimulationEntitiesTest : public SimulationClientTest {
 protected:
  static Outcome outcome(const json& values) {
    return {values["result"]["result"], values["result"]["error_message"]};
  }
  std::vector<std::string> entities(const json& filters = json::object()) {
    const json values = call("get_entities", {{"filters", filters}});
    EXPECT_EQ(outcome(values), (Outcome{1, ""}));
    return values["entities"];
  }
  std::string refusal(const json& filters) {
    const json response = response_of("get_entities", {{"filters", filters}});
    EXPECT_EQ(response["result"], false) << response.dump();
    return response["values"].dump();
  }
  // The orders that are no geometry's.
  std::vector<json> applied() {
    std::vector<json> events;
    for (const json& order : simulation.orders) {
      if (order["order"] == "apply") {
        events.push_back(json::parse(order["event"].get<std::string>()));
      }
    }
    return events;
  }
  static json spawn_request(const std::string& name, const std::string& uri = "gaitway:box?mass=0.5") {
    return {{"name", name},
            {"entity_resource", {{"uri", uri}}},
            {"initial_pose", {{"pose", {{"position", {{"x", 1.0}, {"y", 2.0}, {"z", 0.05}}}}}}}};
  }
  void at(double time_s, double base_x_m, double yaw_rad) {
    simulation.state["time_s"] = time_s;
    simulation.state["base"] = {
        base_x_m, 0.0, 0.3, 0.0, 0.0, std::sin(yaw_rad / 2.0), std::cos(yaw_rad / 2.0)};
  }
  json robot_state() { return call("get_entity_state", {{"entity", "robot"}})["state"]; }
};

TEST_F(SimulationEntitiesTest, AreTheRobotAndEverySolidUnderUniqueNames) {
  EXPECT_THAT(entities(), ElementsAre("robot", "table", "ball", "crate"));
  simulation.solids.push_back(RecordedSimulation::solid("table", "box", "box", {0, 0, 0}, false));
  simulation.solids.push_back(RecordedSimulation::solid("", "tile", "box", {0, 0, 0}, false));
  simulation.solids.push_back(RecordedSimulation::solid("robot", "tile", "box", {0, 0, 0}, false));
  simulation.state["geometry"] = 4;
  EXPECT_THAT(entities(), ElementsAre("robot", "table", "ball", "crate", "table_2", "tile", "robot_2"));
}

TEST_F(SimulationEntitiesTest, GeometryIsReadInPartsAndAgainWhenItIsAnother) {
  simulation.solids_an_answer = 1;
  EXPECT_THAT(entities(), SizeIs(4));
  EXPECT_THAT(simulation.orders, SizeIs(3));
  EXPECT_THAT(entities(), SizeIs(4));
  EXPECT_THAT(simulation.orders, SizeIs(3)) << "it is kept";
  simulation.solids.pop_back();
  simulation.state["geometry"] = 4;
  EXPECT_THAT(entities(), SizeIs(3));
  simulation.solids.pop_back();
  simulation.state["run"] = 2;
  EXPECT_THAT(entities(), SizeIs(2)) << "after a seek the same number may be another geometry's";
  simulation.refusals["geometry"] = "it is gone";
  simulation.state["geometry"] = 5;
  EXPECT_EQ(response_of("get_entities", json::object())["values"], "it is gone");
}

TEST_F(SimulationEntitiesTest, AreFilteredByTheirNames) {
  EXPECT_THAT(entities({{"filter", "^(table|ba)"}}), ElementsAre("table", "ball"));
  EXPECT_THAT(entities({{"filter", "l+$"}}), ElementsAre("ball"));
  EXPECT_THAT(entities({{"filter", "cup"}}), IsEmpty());
}

TEST_F(SimulationEntitiesTest, CategoriesAndTagsAreThoseThatTheInfoTells) {
  const auto category = [this](const char* name) {
    return call("get_entity_info", {{"entity", name}})["info"]["category"]["category"];
  };
  EXPECT_EQ(category("robot"), 1);
  EXPECT_EQ(category("table"), 5);
  EXPECT_EQ(category("ball"), 0);
  EXPECT_EQ(call("get_entity_info", {{"entity", "crate"}})["info"]["tags"],
            (json{"box", "cylinder", "spawned"}));
  EXPECT_THAT(entities({{"categories", {{{"category", 1}}, {{"category", 0}}}}}),
              ElementsAre("robot", "ball"));
  EXPECT_THAT(entities({{"tags", {{"tags", {"box", "spawned"}}, {"filter_mode", 1}}}}), ElementsAre("crate"));
  EXPECT_THAT(entities({{"tags", {{"tags", {"thing", "spawned"}}}}}), ElementsAre("ball", "crate"));
  EXPECT_THAT(refusal({{"tags", {{"filter_mode", 2}}}}), HasSubstr("filter_mode is 2"));
}

TEST_F(SimulationEntitiesTest, ASphereMeetsWhatItOverlapsWith) {
  const auto within = [this](double x, double y, double z, double radius) {
    return entities(
        {{"bounds", {{"type", 3}, {"points", {{{"x", x}, {"y", y}, {"z", z}}, {{"x", radius}}}}}}});
  };
  EXPECT_THAT(within(1.2, 1.0, 0.05, 0.16), ElementsAre("table")) << "its face is at 1.05";
  EXPECT_THAT(within(1.2, 1.0, 0.05, 0.14), IsEmpty());
  EXPECT_THAT(within(3.0, 0.2, 0.1, 0.16), ElementsAre("ball")) << "where it is now, not where it was";
  EXPECT_THAT(within(3.0, 0.2, 0.1, 0.14), IsEmpty());
  EXPECT_THAT(within(2.1, -1.1, 0.05, 0.1), ElementsAre("crate"));
  EXPECT_THAT(within(2.1, -1.1, 0.05, 0.08), IsEmpty()) << "a cylinder has no corners";
  EXPECT_THAT(within(0.1, 0.2, 0.4, 0.11), ElementsAre("robot"));
  EXPECT_THAT(outcome(call("get_entities", {{"filters", {{"bounds", {{"type", 1}}}}}})),
              Pair(0, HasSubstr("must be 3 (a sphere)")));
  EXPECT_THAT(refusal({{"bounds", {{"type", 3}}}}), HasSubstr("has 0 points"));
  EXPECT_THAT(refusal({{"bounds", {{"type", 7}}}}), HasSubstr("type is 7"));
}

TEST_F(SimulationEntitiesTest, PatternsThatAreWrongOrDearAreRefused) {
  EXPECT_THAT(refusal({{"filter", "(a"}}), AllOf(HasSubstr("(a"), HasSubstr("regular expression")));
  EXPECT_THAT(refusal({{"filter", std::string(129, 'a')}}), HasSubstr("at most 128 bytes"));
  for (const char* const dear : {"(a{99}){99}", "(a)\\1"}) {
    EXPECT_THAT(outcome(call("get_entities", {{"filters", {{"filter", dear}}}})),
                Pair(0, HasSubstr("without intervals")));
    EXPECT_THAT(outcome(call("get_entities_states", {{"filters", {{"filter", dear}}}})).first, 0);
  }
  EXPECT_THAT(entities({{"filter", "\\{"}}), IsEmpty());
}

TEST_F(SimulationEntitiesTest, TheRobotsTwistIsTheMeanBetweenTwoStates) {
  at(10.0, 1.0, 0.5);
  json state = robot_state();
  EXPECT_EQ(state["header"], (json{{"stamp", {{"sec", 10}, {"nanosec", 0}}}, {"frame_id", "world"}}));
  EXPECT_EQ(state["pose"]["position"]["x"], 1.0);
  EXPECT_TRUE(state["twist"]["linear"]["x"].is_null()) << "nothing is known of before";
  at(10.1, 1.02, 0.53);
  state = robot_state();
  EXPECT_NEAR(state["twist"]["linear"]["x"], 0.2, 1e-9);
  EXPECT_NEAR(state["twist"]["angular"]["z"], 0.3, 1e-9);
  EXPECT_NEAR(state["twist"]["angular"]["x"], 0.0, 1e-9);
  EXPECT_TRUE(state["acceleration"]["linear"]["x"].is_null());
  EXPECT_NEAR(robot_state()["twist"]["linear"]["x"], 0.2, 1e-9) << "while it is paused, too";
  at(10.4, 1.1, 0.5);
  EXPECT_TRUE(robot_state()["twist"]["linear"]["x"].is_null()) << "0.3 s are too long for a mean";
  at(10.5, 1.1, 0.5);
  EXPECT_EQ(robot_state()["twist"]["linear"]["x"], 0.0);
  simulation.state["run"] = 2;
  at(10.55, 0.0, 0.0);
  EXPECT_TRUE(robot_state()["twist"]["linear"]["x"].is_null()) << "it was put there";
}

TEST_F(SimulationEntitiesTest, StatesOfThingsAreWhereTheyAreNowAndWhatStandsFastStandsStill) {
  const auto state = [this](const char* name) {
    return call("get_entity_state", {{"entity", name}})["state"];
  };
  EXPECT_EQ(state("ball")["pose"]["position"]["x"], 3.0);
  EXPECT_TRUE(state("ball")["twist"]["linear"]["x"].is_null());
  simulation.state["time_s"] = 2.6;
  simulation.state["things"][0]["pose"][0] = 3.05;
  EXPECT_NEAR(state("ball")["twist"]["linear"]["x"], 0.5, 1e-6);
  EXPECT_EQ(state("table")["pose"]["position"]["y"], 1.0);
  EXPECT_EQ(state("table")["twist"]["linear"]["x"], 0.0);
  EXPECT_EQ(state("table")["acceleration"]["angular"]["z"], 0.0);
  EXPECT_THAT(outcome(call("get_entity_state", {{"entity", "cup"}})),
              Pair(2, HasSubstr("entity is \"cup\"")));
  EXPECT_EQ(outcome(call("get_entity_info", {{"entity", "cup"}})).first, 2);
  const json all = call("get_entities_states", {{"filters", {{"filter", "a"}}}});
  EXPECT_EQ(all["entities"], (json{"table", "ball", "crate"}));
  EXPECT_THAT(all["states"], SizeIs(3));
  EXPECT_NEAR(all["states"][1]["pose"]["position"]["x"], 3.05, 1e-9);
}

TEST_F(SimulationEntitiesTest, StatesOfTooManyAreNotAskedForAtOnce) {
  for (int i = 0; i < 600; ++i) {
    simulation.solids.push_back(RecordedSimulation::solid("", "tile", "box", {0, 0, 0}, false));
  }
  EXPECT_THAT(outcome(call("get_entities_states")), Pair(4, HasSubstr("more than 500 entities")));
  EXPECT_THAT(entities({{"filter", "tile"}}), SizeIs(600));
}

TEST_F(SimulationEntitiesTest, SpawnsByTheEventOfAScenario) {
  json request = spawn_request("cup", "gaitway:cylinder?size=0.08,0.08,0.2&mass=0.3&colour=1,0,0");
  request["initial_pose"]["pose"]["orientation"] = {{"z", std::sqrt(0.5)}, {"w", std::sqrt(0.5)}};
  const json values = call("spawn_entity", request);
  EXPECT_EQ(outcome(values), (Outcome{1, ""}));
  EXPECT_EQ(values["entity_name"], "cup");
  ASSERT_THAT(applied(), SizeIs(1));
  json spawn = applied()[0]["spawn"];
  EXPECT_NEAR(spawn["yaw_deg"], 90.0, 1e-9);
  spawn.erase("yaw_deg");
  EXPECT_EQ(spawn, json::parse(R"({"name": "cup", "shape": "cylinder", "size_m": [0.08, 0.08, 0.2],
                                   "position_m": [1, 2, 0.05], "mass_kg": 0.3, "colour": [1, 0, 0]})"));
  EXPECT_EQ(call("spawn_entity", spawn_request("wall", "gaitway:box"))["entity_name"], "wall");
  EXPECT_FALSE(applied()[1]["spawn"].contains("mass_kg")) << "it stands fast";
}

TEST_F(SimulationEntitiesTest, NamesAreFreeOrMadeSo) {
  EXPECT_EQ(outcome(call("spawn_entity", spawn_request("crate"))).first, 101);
  EXPECT_EQ(outcome(call("spawn_entity", spawn_request("robot"))).first, 101);
  EXPECT_EQ(outcome(call("spawn_entity", spawn_request(""))).first, 102);
  EXPECT_EQ(outcome(call("spawn_entity", spawn_request("a\nb"))).first, 102);
  EXPECT_EQ(outcome(call("spawn_entity", spawn_request(std::string(48, 'a')))).first, 102);
  EXPECT_THAT(applied(), IsEmpty());
  json request = spawn_request("crate");
  request["allow_renaming"] = true;
  EXPECT_EQ(call("spawn_entity", request)["entity_name"], "crate_2");
  request["name"] = "";
  EXPECT_EQ(call("spawn_entity", request)["entity_name"], "box");
}

TEST_F(SimulationEntitiesTest, WhatCannotBeSpawnedIsRefusedByItsCode) {
  const auto code = [this](const json& request) { return outcome(call("spawn_entity", request)).first; };
  EXPECT_EQ(code(spawn_request("a", "")), 104) << "no resource";
  json text = spawn_request("a", "");
  text["entity_resource"]["resource_string"] = "<sdf/>";
  EXPECT_EQ(code(text), 0) << "texts are not supported";
  EXPECT_EQ(code(spawn_request("a", "file:///crate.sdf")), 103);
  EXPECT_THAT(outcome(call("spawn_entity", spawn_request("a", "gaitway:box?mass=-1"))),
              Pair(106, HasSubstr("mass is \"-1\"")));
  json request = spawn_request("a");
  request["entity_namespace"] = "/robot1";
  EXPECT_EQ(code(request), 0);
  request = spawn_request("a");
  request["initial_pose"]["pose"]["position"]["x"] = 50.1;
  EXPECT_EQ(code(request), 109);
  request = spawn_request("a");
  request["initial_pose"]["header"]["frame_id"] = "map";
  EXPECT_EQ(code(request), 109);
  request = spawn_request("a");
  request["initial_pose"]["pose"]["orientation"] = {{"x", 0.1}, {"w", 0.995}};
  EXPECT_EQ(code(request), 109) << "it leans";
  request["initial_pose"]["pose"]["orientation"] = {{"w", 0.0}};
  EXPECT_EQ(code(request), 109);
  EXPECT_THAT(applied(), IsEmpty());
  simulation.refusals["apply"] = "it would stand within the robot";
  EXPECT_EQ(outcome(call("spawn_entity", spawn_request("a"))),
            (Outcome{4, "it would stand within the robot"}));
}

TEST_F(SimulationEntitiesTest, OnlyWhatWasSpawnedIsRemoved) {
  EXPECT_EQ(outcome(call("delete_entity", {{"entity", "crate"}})).first, 1);
  EXPECT_THAT(applied(), ElementsAre(json{{"remove", {{"name", "crate"}}}}));
  EXPECT_EQ(outcome(call("delete_entity", {{"entity", "cup"}})).first, 2);
  EXPECT_THAT(outcome(call("delete_entity", {{"entity", "table"}})), Pair(4, HasSubstr("was spawned")));
  EXPECT_EQ(outcome(call("delete_entity", {{"entity", "robot"}})).first, 4);
  EXPECT_THAT(applied(), SizeIs(1));
}

TEST_F(SimulationEntitiesTest, WhatCanBeMovedIs) {
  const auto set = [this](const char* name, json more = json::object()) {
    json request = {{"entity", name},
                    {"set_pose", true},
                    {"state", {{"pose", {{"position", {{"x", 1.0}, {"y", 0.5}, {"z", 0.05}}}}}}}};
    request.update(more, true);
    return outcome(call("set_entity_state", request));
  };
  EXPECT_EQ(set("ball").first, 1);
  EXPECT_THAT(
      applied(),
      ElementsAre(json::parse(R"({"move": {"name": "ball", "position_m": [1, 0.5, 0.05], "yaw_deg": 0}})")));
  EXPECT_EQ(set("crate").first, 1);
  EXPECT_EQ(set("cup").first, 2);
  EXPECT_THAT(set("table"), Pair(4, HasSubstr("must be one that was spawned or can be pushed")));
  EXPECT_EQ(set("robot").first, 4);
  EXPECT_EQ(set("ball", {{"set_twist", true}}).first, 0) << "velocities cannot be set";
  const json moving = {{"set_twist", true}, {"state", {{"twist", {{"linear", {{"x", 1.0}}}}}}}};
  EXPECT_EQ(set("crate", moving).first, 4) << "it stands fast";
  EXPECT_EQ(set("ball", {{"state", {{"pose", {{"position", {{"z", 99.0}}}}}}}}).first, 101);
  EXPECT_THAT(applied(), SizeIs(2));
  EXPECT_EQ(set("table", {{"set_pose", false}}).first, 1) << "nothing was asked for";
}

TEST_F(SimulationEntitiesTest, SpawnablesAreListedWithoutTheSimulator) {
  const json values = call("get_spawnables", {{"sources", {"https://models"}}});
  EXPECT_THAT(outcome(values), Pair(1, HasSubstr("https://models")));
  ASSERT_THAT(values["spawnables"], SizeIs(3));
  EXPECT_EQ(values["spawnables"][0]["entity_resource"]["uri"], "gaitway:box?size=0.1,0.1,0.1&mass=0.5");
  EXPECT_THAT(simulation.orders, IsEmpty());
}

}  // namespace
}  // namespace gaitway::api
