// The table of services: complete, each with an example that its own type accepts.
#include "gaitway/api/service_table.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "gaitway/api/message_definition.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;

TEST(ServiceTable, HasARowForEachServiceAtItsPlaceAndEachNameOnce) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kServiceCount; ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kServices[i].service), i) << kServices[i].name;
    EXPECT_EQ(&row(kServices[i].service), &kServices[i]);
    EXPECT_TRUE(names.insert(kServices[i].name).second) << kServices[i].name;
    EXPECT_EQ(kServices[i].name.front(), '/');
    EXPECT_FALSE(kServices[i].doc.empty()) << kServices[i].name;
  }
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
  EXPECT_FALSE(row(Service::emergency_stop).needs_command);
  EXPECT_FALSE(row(Service::stop).needs_command);
  for (const Service moves :
       {Service::stand, Service::move_joint, Service::play_motion, Service::load_plugin,
        Service::reload_plugin, Service::unload_plugin, Service::set_parameter, Service::rosapi_set_param}) {
    EXPECT_TRUE(row(moves).needs_command) << row(moves).name;
  }
}

TEST(ServiceTable, EveryServiceOfTheRobotSaysWhetherItWorkedAndWhy) {
  for (const ServiceRow& service : kServices) {
    if (service.name.starts_with("/rosapi/")) {
      continue;
    }
    const std::string response = message_definition(std::string(service.type) + "_Response");
    EXPECT_TRUE(response.starts_with("bool success\nstring message\n")) << service.name;
  }
}

}  // namespace
}  // namespace gaitway::api
