// A client's order all the way through the sessions and the simulator's socket: answers at once and later,
// long ones, the state ten times a second; and a simulator that takes pushes alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/api/simulator_port.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/simulation/control_server.hpp"
#include "test_client.hpp"

namespace gaitway::api {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class OrderPathTest : public ::testing::Test {
 protected:
  OrderPathTest() { start(true); }

  void start(bool takes_orders) {
    server_.reset();
    server_ = std::make_unique<simulation::ControlServer>(
        socket_, [](const simulation::Ticket&, const simulation::Push&) { return true; },
        takes_orders ? simulation::ControlServer::OnOrder(
                           [this](const simulation::Ticket& ticket, std::string_view order) {
                             return carry_out(ticket, json::parse(order));
                           })
                     : nullptr);
  }
  std::optional<std::string> carry_out(const simulation::Ticket& ticket, const json& order) {
    if (order["order"] == "seek") {
      seeks_.push_back(ticket);
      return std::nullopt;
    }
    if (order["order"] == "geometry") {
      return geometry_from(order["from"]).dump();
    }
    if (order["order"] == "state") {
      ++state_orders_;
      return RecordedSimulation().state.dump();
    }
    throw std::invalid_argument("order is '" + order["order"].get<std::string>() +
                                "', but must be another one");
  }
  // As much as an answer holds.
  static json geometry_from(std::size_t from) {
    constexpr std::size_t kTotal = 2000, kPart = 200;
    auto solids = json::array();
    for (std::size_t i = from; i < std::min(kTotal, from + kPart); ++i) {
      solids.push_back(
          RecordedSimulation::solid("a solid with a name of some length, number " + std::to_string(i), "tile",
                                    "box", {1.0 / 3.0, 2.0 / 3.0, 0.1}, false));
    }
    return {{"geometry", 3},      {"world", "w"},    {"total", kTotal}, {"floor_colour", {0.5, 0.5, 0.5}},
            {"start", {0, 0, 0}}, {"solids", solids}};
  }
  void pass_a_millisecond() {
    server_->step();
    now_ns_ += kMillisecond_ns;
    port_.step(now_ns_);
    hub_.step(now_ns_);
  }
  std::vector<json> pass(int milliseconds) {
    for (int ms = 0; ms < milliseconds; ++ms) {
      pass_a_millisecond();
    }
    return client_.receive();
  }
  void call(const std::string& service, const json& arguments = json::object()) {
    client_.send({{"op", "call_service"}, {"service", "/simulation/" + service}, {"args", arguments}});
  }

  const process::PrivateFolder folder_{"gaitway_order_path_test"};
  const std::filesystem::path socket_ = folder_.path() / "simulation.sock";
  std::unique_ptr<simulation::ControlServer> server_;
  std::vector<simulation::Ticket> seeks_;
  int state_orders_ = 0;
  SimulatorPort port_{socket_};
  RecordedRobot robot_;
  Hub hub_{robot_, {.limits = {}, .is_token = {}, .parameters = {}, .simulation = &port_}};
  std::int64_t now_ns_ = kSecond_ns;
  TestClient client_{hub_, now_ns_, "client"};
};

TEST_F(OrderPathTest, TheStateComesTenTimesASecond) {
  int states = 0;
  for (int ms = 0; ms < 1000; ++ms) {
    pass_a_millisecond();
    states += hub_.take_simulation_state() ? 1 : 0;
  }
  EXPECT_NEAR(states, 10, 1);
}

TEST_F(OrderPathTest, AnAnswerMayTakeLongerThanAPushs) {
  call("seek", {{"time", 3.5}});
  EXPECT_THAT(pass(5000), SizeIs(0)) << "it is simulated up to there";
  ASSERT_THAT(seeks_, SizeIs(1));
  server_->answer(seeks_[0], true, R"({"time_s": 3.5})");
  const auto answers = pass(5);
  ASSERT_THAT(answers, SizeIs(1));
  EXPECT_EQ(answers[0]["values"], (json{{"success", true}, {"message", ""}, {"time", 3.5}}));
}

TEST_F(OrderPathTest, AWorldOfManySolidsComesWhole) {
  call("get_entities");
  const auto answers = pass(60);
  ASSERT_THAT(answers, SizeIs(1));
  EXPECT_THAT(answers[0]["values"]["entities"], SizeIs(2001));
  for (int i = 0; i < 4; ++i) {
    call("geometry", {{"first", 200 * i}});
  }
  const auto parts = pass(60);
  ASSERT_THAT(parts, SizeIs(4)) << "more at once than a socket holds";
  for (const json& part : parts) {
    EXPECT_THAT(part["values"]["solids"], SizeIs(200));
  }
}

TEST_F(OrderPathTest, RefusalsAreToldAsTheyAre) {
  call("set_speed", {{"speed", 2}});
  const auto answers = pass(5);
  ASSERT_THAT(answers, SizeIs(1));
  EXPECT_EQ(answers[0]["values"],
            (json{{"success", false}, {"message", "order is 'speed', but must be another one"}}));
}

TEST_F(OrderPathTest, ASimulatorOfPushesAloneSaysWhoTakesOrders) {
  start(false);
  for (int ms = 0; ms < 3000; ++ms) {
    pass_a_millisecond();
    EXPECT_FALSE(hub_.take_simulation_state());
  }
  call("seek", {{"time", 1}});
  const auto answers = pass(5);
  ASSERT_THAT(answers, SizeIs(1));
  EXPECT_THAT(answers[0]["values"]["message"], HasSubstr("`gaitway simulator` takes orders, too"));
  call("push", {{"link", "trunk"}, {"force", {{"x", 5}}}, {"duration", 0.1}});
  EXPECT_EQ(pass(5).at(0)["values"]["message"], "the push begins");
  start(true);
  pass(1500);
  EXPECT_TRUE(hub_.take_simulation_state()) << "another one is there now";
}

}  // namespace
}  // namespace gaitway::api
