// The table of services: complete, each with an example that its own type accepts.
#include "gaitway/api/service_table.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "gaitway/api/message_definition.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;

TEST(ServiceTable, HasEachNameOnceAndFindsItWithAndWithoutTheSlash) {
  std::set<std::string_view> names;
  for (const ServiceRow& service : kServices) {
    EXPECT_TRUE(names.insert(service.name).second) << service.name;
    EXPECT_EQ(service.name.front(), '/');
    EXPECT_EQ(find_service(service.name), &service);
    EXPECT_EQ(find_service(service.name.substr(1)), &service);
    EXPECT_FALSE(service.doc.empty()) << service.name;
  }
  EXPECT_EQ(find_service("/none"), nullptr);
}

TEST(ServiceTable, ExamplesNameFieldsOfTheirRequestsOnly) {
  for (const ServiceRow& service : kServices) {
    const json example = json::parse(service.example);
    const json properties =
        json::parse(json_schema(std::string(service.type) + "_Request", Sender::client)).at("properties");
    for (const auto& [name, value] : example.items()) {
      EXPECT_TRUE(properties.contains(name)) << service.name << " " << name;
    }
  }
}

TEST(ServiceTable, EverybodyMayStopTheRobotAndOnlyWhoCommandsMayMoveIt) {
  EXPECT_FALSE(find_service("/emergency_stop")->needs_command);
  EXPECT_FALSE(find_service("/stop")->needs_command);
  for (const std::string_view moves :
       {"/stand", "/move_joint", "/play_motion", "/walk_to", "/walk_to/cancel", "/head/look", "/command/take",
        "/command/let_go", "/behaviour/start", "/behaviour/end", "/behaviour/change", "/plugins/load",
        "/plugins/reload", "/plugins/unload", "/plugins/set_parameter", "/rosapi/set_param"}) {
    EXPECT_TRUE(find_service(moves)->needs_command) << moves;
  }
}

TEST(ServiceTable, WhatIsOfASimulationNeedsNoCommand) {
  for (const ServiceRow& service : kServices) {
    EXPECT_EQ(service.of_simulation, service.name.starts_with("/simulation/")) << service.name;
    EXPECT_FALSE(service.of_simulation && service.needs_command) << service.name;
  }
}

TEST(ServiceTable, EveryServiceOfTheRobotSaysWhetherItWorkedAndWhy) {
  for (const ServiceRow& service : kServices) {
    if (service.name.starts_with("/rosapi/")) {
      continue;
    }
    const std::string response = message_definition(std::string(service.type) + "_Response");
    if (service.type.starts_with("simulation_interfaces/")) {
      EXPECT_TRUE(response.find("simulation_interfaces/Result result\n") != std::string::npos ||
                  service.name == "/simulation/get_simulator_features")
          << service.name;
      continue;
    }
    EXPECT_TRUE(response.starts_with("bool success\nstring message\n")) << service.name;
  }
}

}  // namespace
}  // namespace gaitway::api
