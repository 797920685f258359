// A client that calls services which the simulator has a part in.
#pragma once

#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <vector>

#include "test_client.hpp"

namespace gaitway::api {

class SimulationClientTest : public HubTest {
 protected:
  // The whole response.
  json response_of(const std::string& service, const json& arguments = json::object()) {
    client->send({{"op", "call_service"}, {"service", "/simulation/" + service}, {"args", arguments}});
    std::vector<json> messages = client->receive();
    for (int i = 0; i < 20 && messages.empty(); ++i, messages = client->receive()) {
      step();
    }
    EXPECT_THAT(messages, testing::SizeIs(1)) << service;
    return messages.empty() ? json() : messages.front();
  }
  json call(const std::string& service, const json& arguments = json::object()) {
    const json response = response_of(service, arguments);
    EXPECT_EQ(response["result"], true) << response.dump();
    return response["values"];
  }

  std::unique_ptr<TestClient> client = connect("anna");
};

}  // namespace gaitway::api
