// The real robot whose twin a simulation is: what is published of it, and what clients may have it sent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "simulation_client.hpp"

namespace gaitway::api {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class TwinServicesTest : public SimulationClientTest {
 protected:
  std::string failure(const std::string& service, const json& arguments = json::object()) {
    const json response = response_of(service, arguments);
    EXPECT_EQ(response["result"], false) << response.dump();
    return response["values"].is_string() ? response["values"].get<std::string>() : "";
  }
  static json told() {
    return {{"robot", "ws://10.0.0.7:9090"},
            {"state", "lost"},
            {"text", "nothing has come for 3 s"},
            {"age", nullptr},
            {"activity", "walks"},
            {"commander", "anna"},
            {"follows", true},
            {"follows_text", ""},
            {"base", {1.0, 2.0, 0.3, 0.0, 0.0, 0.0, 1.0}},
            {"joints", {0.1, -0.2}},
            {"lag", 0.04},
            {"channels", {"left_knee", "roll"}},
            {"units", {"rad", "rad"}},
            {"measured", {0.5, nullptr}},
            {"simulated", {0.4, nullptr}},
            {"difference", {0.1, nullptr}},
            {"limits", {0.05, 0.03}},
            {"told_times", {12.5}},
            {"told_texts", {"left_knee by 5.7 deg"}},
            {"sending", "trying"},
            {"sending_what", "motion kick"},
            {"sending_text", ""},
            {"passed", 0},
            {"tried", 0},
            {"picture", 2}};
  }
};

TEST_F(TwinServicesTest, WhatIsNotKnownIsNoNumber) {
  twin.twin_state = told();
  pass(200 * kMillisecond_ns);
  const auto state = hub.take_twin_state();
  ASSERT_TRUE(state);
  EXPECT_FALSE(hub.take_twin_state()) << "each once";
  EXPECT_EQ(state->text, "nothing has come for 3 s");
  EXPECT_TRUE(std::isnan(state->age));
  EXPECT_EQ(state->difference[0], 0.1);
  EXPECT_TRUE(std::isnan(state->difference[1]));
  client->subscribe("/simulation/twin");
  hub.publish(Topic::twin_state, *state);
  const json message = client->receive_one()["msg"];
  EXPECT_EQ(message, told());
}

TEST_F(TwinServicesTest, ComesTenTimesASecondAndIsAskedForOnceASecondWhereThereIsNone) {
  step();
  twin.twin_orders = 0;
  pass(5 * kSecond_ns);
  EXPECT_LE(twin.twin_orders, 6);
  EXPECT_FALSE(hub.take_twin_state());
  twin.twin_state = told();
  pass(kSecond_ns + 100 * kMillisecond_ns);
  int states = 0;
  for (int i = 0; i < 100; ++i) {
    pass(10 * kMillisecond_ns);
    states += hub.take_twin_state() ? 1 : 0;
  }
  EXPECT_NEAR(states, 10, 1);
}

TEST_F(TwinServicesTest, AFieldThatIsMissingIsNoState) {
  twin.twin_state = told();
  twin.twin_state->erase("lag");
  pass(kSecond_ns);
  EXPECT_FALSE(hub.take_twin_state());
}

TEST_F(TwinServicesTest, WhatIsSentIsPassedOnWithAllOfIt) {
  EXPECT_EQ(call("twin/send", {{"walk", {0.1, 0.0, 0.2}}, {"duration", 5.0}}),
            (json{{"success", true}, {"message", ""}}));
  EXPECT_EQ(call("twin/send", {{"motion", "kick"},
                               {"settings", {"trajectory.com_height=0.3 m"}},
                               {"reason", "held by its crane"}})["success"],
            true);
  for (json& order : twin.orders) {
    // Whoever is told after this that it was not done can rely on it.
    EXPECT_NEAR(order.at("until_ns").get<double>(), static_cast<double>(now_ns + 2 * kSecond_ns), 1e8);
    order.erase("until_ns");
  }
  EXPECT_THAT(twin.orders, ElementsAre(json{{"order", "twin_send"},
                                            {"walk", {0.1, 0.0, 0.2}},
                                            {"duration_s", 5.0},
                                            {"motion", ""},
                                            {"goal", json::array()},
                                            {"settings", json::array()},
                                            {"reason", ""}},
                                       json{{"order", "twin_send"},
                                            {"walk", json::array()},
                                            {"duration_s", 0.0},
                                            {"motion", "kick"},
                                            {"goal", json::array()},
                                            {"settings", {"trajectory.com_height=0.3 m"}},
                                            {"reason", "held by its crane"}}));
  EXPECT_EQ(hub.statistics().commander, "") << "it is not the simulated robot's command";
}

TEST_F(TwinServicesTest, WhatNoRobotCouldDoIsRefusedByName) {
  EXPECT_THAT(failure("twin/send"), HasSubstr("nothing to send"));
  EXPECT_THAT(failure("twin/send", {{"walk", {0.1}}}), HasSubstr("walk has 1 numbers"));
  EXPECT_THAT(failure("twin/send", {{"goal", {0.1, 0.2}}}), HasSubstr("goal has 2 numbers"));
  EXPECT_THAT(failure("twin/send", {{"motion", "kick"}, {"goal", {1, 0, 0}}}), HasSubstr("one of them"));
  EXPECT_THAT(failure("twin/send", {{"walk", {0.1, 0, 0}}, {"duration", -1}}), HasSubstr("duration is -1"));
  EXPECT_THAT(failure("twin/send", {{"motion", "kick"}, {"duration", 601}}), HasSubstr("from 0.5 to 599 s"));
  EXPECT_THAT(failure("twin/send", {{"settings", {std::string(3001, 'x')}}}), HasSubstr("too long"));
  EXPECT_THAT(twin.orders, IsEmpty());
}

TEST_F(TwinServicesTest, FollowingStoppingAndConnectingAreOrders) {
  EXPECT_EQ(call("twin/follow", {{"data", false}})["success"], true);
  EXPECT_EQ(call("twin/stop")["success"], true);
  EXPECT_EQ(call("twin/reconnect")["success"], true);
  EXPECT_THAT(twin.orders, ElementsAre(json{{"order", "twin_follow"}, {"follow", false}},
                                       json{{"order", "twin_stop"}}, json{{"order", "twin_reconnect"}}));
  twin.refusals["twin_send"] = "the robot there is lost: no route";
  EXPECT_EQ(call("twin/send", {{"motion", "kick"}}),
            (json{{"success", false}, {"message", "the robot there is lost: no route"}}));
}

class NoTwinTest : public HubTest {
 protected:
  NoTwinTest()
      : plain(robot, {.limits = {}, .is_token = {}, .parameters = {}, .simulation = {&simulation, nullptr}}) {
  }
  Hub plain;
};

TEST_F(NoTwinTest, ASimulationOfNoRobotSaysHowToHaveOne) {
  TestClient anna(plain, now_ns, "anna");
  const json answer = anna.call("/simulation/twin/stop")["values"];
  EXPECT_EQ(answer["success"], false);
  EXPECT_THAT(answer["message"].get<std::string>(), HasSubstr("--robot ws://HOST:PORT"));
  plain.step(now_ns);
  EXPECT_FALSE(plain.take_twin_state());
}

TEST_F(TwinServicesTest, APictureComesInParts) {
  EXPECT_EQ(call("twin/picture", {{"first", 48000}}),
            (json{{"success", true}, {"message", ""}, {"total", 5}, {"data", "aGVsbG8="}}));
  EXPECT_THAT(twin.orders, ElementsAre(json{{"order", "twin_picture"}, {"from", 48000}}));
}

}  // namespace
}  // namespace gaitway::api
