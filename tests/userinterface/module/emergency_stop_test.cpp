// Clients of the API and the simulated robot: a flood of stops and of orders, what an emergency stop leaves
// possible, its release, and a joint that is moved by hand while the robot keeps its balance.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "gaitway/api/link_robot_port.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "linked_robot.hpp"
#include "test_client.hpp"

namespace gaitway::api {
namespace {

using msgcontroller::Mode;
using ::testing::HasSubstr;

simulator::CosimulationOptions options_of(const std::string& configuration) {
  const std::filesystem::path source = GAITWAY_SOURCE_DIR;
  simulator::CosimulationOptions result;
  result.people_outside = true;
  result.main_controller.configuration = source / "core" / "config" / configuration;
  result.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
  return result;
}

class EmergencyStopTest : public ::testing::Test {
 protected:
  EmergencyStopTest() {
    for (int i = 0; i < kClients; ++i) {
      clients_.push_back(std::make_unique<TestClient>(hub_, now_ns_, "client " + std::to_string(i)));
    }
  }
  void run_for(double seconds) {
    const std::int64_t end_ns = run_.now_ns() + static_cast<std::int64_t>(seconds * 1e9);
    while (run_.now_ns() < end_ns) {
      run_.advance_millisecond();
      now_ns_ = run_.now_ns() + kSecond_ns;
      linked_.pass_millisecond(now_ns_ - kMillisecond_ns);
      port_.observe(now_ns_);
      if (run_.now_ns() % (10 * kMillisecond_ns) == 0) {
        hub_.step(now_ns_);
        for (std::size_t i = 0; i < clients_.size(); ++i) {
          for (const json& message : clients_[i]->receive()) {
            answers_[i].push_back(message);
          }
        }
      }
    }
  }
  void call(int client, const std::string& service, const json& arguments = json::object()) {
    clients_[static_cast<std::size_t>(client)]->send(
        {{"op", "call_service"}, {"service", service}, {"args", arguments}});
  }
  // The values of the answer to one call.
  json answer_to(int client, const std::string& service, const json& arguments = json::object()) {
    auto& answers = answers_[static_cast<std::size_t>(client)];
    answers.clear();
    call(client, service, arguments);
    run_for(0.3);
    EXPECT_EQ(answers.size(), 1U) << service;
    return answers.empty() ? json::object() : answers.front().value("values", json::object());
  }
  [[nodiscard]] int neck_yaw() const {
    const auto found = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                    [](const urdf::Joint& joint) { return joint.name == "neck_yaw"; });
    return static_cast<int>(found - robot_.joints.begin());
  }
  [[nodiscard]] Mode mode() const { return run_.message_controller().mode(); }

  static constexpr int kClients = 17;
  const urdf::RobotModel robot_ =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  simulator::Cosimulation run_{robot_, options_of("walk.yaml")};
  test::LinkedRobot linked_{run_.client(), robot_, test::Line::socket};
  LinkRobotPort port_{linked_.link, robot_, nullptr};
  Hub hub_{port_, {}};
  std::int64_t now_ns_ = kSecond_ns;
  std::vector<std::unique_ptr<TestClient>> clients_;
  std::array<std::vector<json>, kClients> answers_;
};

TEST_F(EmergencyStopTest, EveryStopOfAFloodIsDoneAndAnswered) {
  constexpr int kRounds = 20, kStopsOfARound = 5;
  run_for(0.5);
  for (int round = 0; round < kRounds; ++round) {
    for (int client = 0; client < kClients; ++client) {
      for (int i = 0; i < kStopsOfARound; ++i) {
        call(client, client == 3 ? "/emergency_stop" : "/stop");
      }
    }
    run_for(0.05);
    if (round == 0) {
      EXPECT_EQ(mode(), Mode::emergency_stop) << "at once";
    }
  }
  run_for(0.1);
  for (std::size_t client = 0; client < answers_.size(); ++client) {
    EXPECT_EQ(answers_[client].size(), std::size_t{kRounds * kStopsOfARound}) << "client " << client;
    for (const json& answer : answers_[client]) {
      EXPECT_TRUE(answer["result"]) << answer.dump();
      const bool said = answer["values"]["success"] ||
                        answer["values"]["message"].get<std::string>().find("/release") != std::string::npos;
      EXPECT_TRUE(said) << answer.dump();
    }
  }
}

TEST_F(EmergencyStopTest, StopsFindTheirWayWhereNoOtherOrderDoes) {
  run_for(0.5);
  for (int order = 0; order < 500; ++order) {
    port_.move_joint(neck_yaw(), 0.0, 0.5, 0);
  }
  EXPECT_TRUE(port_.stop());
  EXPECT_TRUE(port_.emergency_stop(false));
  linked_.exchange(now_ns_);
  run_.advance_millisecond();
  EXPECT_EQ(mode(), Mode::emergency_stop);
}

TEST_F(EmergencyStopTest, AStopIsDoneWhateverElseIsWrongInItsMessage) {
  run_for(0.5);
  for (const json& wrong :
       {json{{"timeout", -1}}, json{{"compression", "png"}}, json{{"fragment_size", 1}}, json{{"id", 1.5}}}) {
    answers_[0].clear();
    json message = wrong;
    message.update({{"op", "call_service"}, {"service", "/emergency_stop"}, {"args", json{{"data", false}}}});
    clients_[0]->send(message);
    run_for(0.3);
    EXPECT_EQ(mode(), Mode::emergency_stop) << wrong.dump();
    EXPECT_TRUE(std::any_of(answers_[0].begin(), answers_[0].end(), [](const json& answer) {
      return answer["op"] == "service_response" && answer["values"]["success"];
    })) << json(answers_[0]).dump();
    EXPECT_TRUE(answer_to(0, "/release")["success"]) << wrong.dump();
    run_for(1.0);
  }
}

// More answers come than their stream holds before anybody looks for one.
TEST_F(EmergencyStopTest, NoAnswerIsLostHoweverLateItIsTaken) {
  run_for(0.5);
  std::set<std::uint32_t> unanswered;
  for (int ms = 0; ms < 60; ++ms) {
    const auto order = port_.move_joint(neck_yaw(), 0.0, 0.5, 0);
    ASSERT_TRUE(order) << ms;
    unanswered.insert(*order);
    run_.advance_millisecond();
    linked_.pass_millisecond(run_.now_ns() + kSecond_ns - kMillisecond_ns);
  }
  for (int ms = 0; ms < 300; ++ms) {
    run_.advance_millisecond();
    linked_.pass_millisecond(run_.now_ns() + kSecond_ns - kMillisecond_ns);
  }
  port_.observe(run_.now_ns() + kSecond_ns);
  while (const auto result = port_.take_result()) {
    unanswered.erase(result->number);
  }
  EXPECT_THAT(unanswered, ::testing::IsEmpty());
}

TEST_F(EmergencyStopTest, NothingMovesTheRobotUntilItIsReleasedAndThenItWalks) {
  run_for(1.0);
  EXPECT_TRUE(answer_to(0, "/emergency_stop", {{"data", false}})["success"]);
  EXPECT_EQ(mode(), Mode::emergency_stop);
  for (const char* const service : {"/stand", "/stop"}) {
    const json refused = answer_to(0, service);
    EXPECT_FALSE(refused["success"]);
    EXPECT_THAT(refused["message"].get<std::string>(), HasSubstr("/release"));
  }
  const json released = answer_to(0, "/release");
  EXPECT_TRUE(released["success"]) << released.dump();
  run_for(2.0);
  EXPECT_EQ(mode(), Mode::batches);
  EXPECT_FALSE(run_.plant().fallen());
  const double before_m = run_.plant().truth().com_m.x();
  for (int i = 0; i < 40; ++i) {
    clients_[0]->drive(0.2);
    run_for(0.1);
  }
  EXPECT_GT(run_.plant().truth().com_m.x() - before_m, 0.4);
  EXPECT_FALSE(run_.plant().fallen());
  EXPECT_THAT(answer_to(0, "/release")["message"].get<std::string>(), HasSubstr("not in emergency stop"));
}

TEST_F(EmergencyStopTest, ARobotThatHasCollapsedHoldsWhereItLies) {
  run_for(1.0);
  EXPECT_TRUE(answer_to(0, "/emergency_stop", {{"data", true}})["success"]);
  run_for(2.0);
  EXPECT_TRUE(run_.plant().fallen());
  EXPECT_TRUE(answer_to(0, "/release")["success"]);
  run_for(1.0);
  EXPECT_NE(mode(), Mode::emergency_stop);
}

// What a plan leaves undone when a joint is moved by hand: a plan with its tail is some 0.3 s long.
TEST_F(EmergencyStopTest, ARobotThatStandsSwaysFarLessThanWhatCountsAsStanding) {
  run_for(2.0);
  constexpr std::size_t kWindow_ms = 300;
  std::vector<std::vector<double>> references_rad(robot_.joints.size());
  for (int ms = 0; ms < 3000; ++ms) {
    run_for(0.001);
    for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
      references_rad[joint].push_back(run_.message_controller().expected_count(static_cast<int>(joint)) *
                                      robot_.joints[joint].count_rad);
    }
  }
  ASSERT_EQ(mode(), Mode::batches);
  double sway_rad = 0.0;
  for (const std::vector<double>& reference : references_rad) {
    for (std::size_t at = 0; at + kWindow_ms <= reference.size(); at += 10) {
      const auto from = reference.begin() + static_cast<std::ptrdiff_t>(at);
      const auto [least, most] = std::minmax_element(from, from + kWindow_ms);
      sway_rad = std::max(sway_rad, *most - *least);
    }
  }
  RecordProperty("sway_rad", std::to_string(sway_rad));
  EXPECT_LT(sway_rad, msgcontroller::kStandingSway_rad / 2);
}

TEST_F(EmergencyStopTest, AJointMovesWhileTheRobotKeepsItsBalance) {
  const auto move = [this](double position_rad) {
    return answer_to(0, "/move_joint",
                     {{"joint", "neck_yaw"}, {"position", position_rad}, {"duration", 0.5}});
  };
  run_for(2.0);
  ASSERT_EQ(mode(), Mode::batches);
  for (int trial = 0; trial < 5; ++trial) {
    const double target_rad = trial % 2 == 0 ? 0.2 : 0.0;
    const json moved = move(target_rad);
    EXPECT_TRUE(moved["success"]) << moved.dump();
    run_for(1.0);
    EXPECT_NEAR(run_.message_controller().expected_count(neck_yaw()) *
                    robot_.joints[static_cast<std::size_t>(neck_yaw())].count_rad,
                target_rad, 0.002)
        << "trial " << trial;
  }
  EXPECT_FALSE(run_.plant().fallen());
}

}  // namespace
}  // namespace gaitway::api
