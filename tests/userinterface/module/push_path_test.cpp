// A client's push all the way: through the sessions, the simulator's socket and its desk to the robot; and a
// simulator that comes and goes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

#include "gaitway/api/service_table.hpp"
#include "gaitway/api/simulator_port.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/simulator/simulation_desk.hpp"
#include "simulation.hpp"
#include "test_client.hpp"

namespace gaitway::api {
namespace {

using ::testing::HasSubstr;

class PushPathTest : public ::testing::Test {
 protected:
  PushPathTest() { start_simulator(); }

  void start_simulator() {
    desk_ = std::make_unique<simulator::SimulationDesk>(run_, socket_, [](const auto&) {});
  }
  void pass_a_millisecond() {
    if (desk_) {
      desk_->step();
    }
    run_.advance_millisecond();
    now_ns_ += kMillisecond_ns;
    port_.step(now_ns_);
    hub_.step(now_ns_);
  }
  // Of the call's answer.
  json push(const std::string& link, double forward_N) {
    client_.send({{"op", "call_service"},
                  {"service", "/simulation/push"},
                  {"args", {{"link", link}, {"force", {{"x", forward_N}}}, {"duration", 0.1}}}});
    for (int ms = 0; ms < 5; ++ms) {
      pass_a_millisecond();
      for (const json& message : client_.receive()) {
        return message["values"];
      }
    }
    return json::object();
  }
  [[nodiscard]] double velocity_m_per_s() const { return run_.plant().velocities()[0]; }

  const urdf::RobotModel robot_model_ =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  simulator::Cosimulation run_{robot_model_, served_walk()};
  const process::PrivateFolder folder_{"gaitway_push_test"};
  const std::filesystem::path socket_ = folder_.path() / "simulation.sock";
  std::unique_ptr<simulator::SimulationDesk> desk_;
  SimulatorPort port_{socket_};
  RecordedRobot robot_;
  Hub hub_{robot_, {.limits = {}, .is_token = {}, .parameters = {}, .simulation = &port_}};
  std::int64_t now_ns_ = kSecond_ns;
  TestClient client_{hub_, now_ns_, "client"};
};

TEST_F(PushPathTest, MovesTheRobotWithinMillisecondsOfTheCall) {
  for (int ms = 0; ms < 500; ++ms) {
    pass_a_millisecond();
  }
  const double before = velocity_m_per_s();
  EXPECT_EQ(push("pelvis", 20.0), (json{{"success", true}, {"message", "the push begins"}}));
  for (int ms = 0; ms < 50; ++ms) {
    pass_a_millisecond();
  }
  EXPECT_GT(velocity_m_per_s(), before + 0.02);
}

TEST_F(PushPathTest, TellsWhatTheSimulatorAndItsRulesRefuse) {
  EXPECT_THAT(push("hed", 20.0)["message"], HasSubstr("Did you mean 'head'?"));
  EXPECT_THAT(push("head", 201.0), HasSubstr("must be from 0.1 to 200.0 N"));
}

TEST_F(PushPathTest, GoesOnWithASimulatorThatWasStartedAgain) {
  EXPECT_EQ(push("head", 1.0)["success"], true);
  desk_.reset();
  const json refused = push("head", 1.0);
  EXPECT_EQ(refused["success"], false);
  EXPECT_THAT(refused["message"], HasSubstr("the simulator is not there"));
  start_simulator();
  EXPECT_EQ(push("head", 1.0)["success"], true);
}

TEST(SimulatorSocket, IsAUnixSocketAndNothingElse) {
  EXPECT_EQ(simulator_socket("unix:/run/simulation.sock"), "/run/simulation.sock");
  for (const char* const wrong : {"", "unix:", "/run/simulation.sock", "serial:/dev/ttyS1:1000000"}) {
    try {
      static_cast<void>(simulator_socket(wrong));
      ADD_FAILURE() << wrong;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr("'" + std::string(wrong) + "': must be unix:PATH"));
    }
  }
}

// The rooms that say so know nothing of each other.
TEST(PushService, ItsReferenceHasTheSimulatorsBounds) {
  const auto number = [](double value) {
    std::ostringstream text;
    text << value;
    return text.str();
  };
  const std::string doc(find_service("/simulation/push")->doc);
  EXPECT_THAT(doc, HasSubstr(number(simulation::kLeastForce_N) + " to " +
                             number(simulation::kLargestForce_N) + " in size"));
  EXPECT_THAT(doc,
              HasSubstr(number(simulation::kShortestPush_s) + " to " + number(simulation::kLongestPush_s)));
}

}  // namespace
}  // namespace gaitway::api
