// Orders that may be too old are refused by name; the others go to the robot with their age.
#include <gmock/gmock.h>

#include "test_client.hpp"

namespace gaitway::api {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class OrderAgeTest : public HubTest {
 protected:
  std::unique_ptr<TestClient> anna = connect("anna"), bert = connect("bert");
};

TEST_F(OrderAgeTest, AVelocityMayBe200MillisecondsOld) {
  anna->age_ns = 200 * kMillisecond_ns;
  anna->drive(0.1);
  EXPECT_THAT(robot.ages_ns, ElementsAre(200 * kMillisecond_ns)) << "the robot's side judges what is left";
  anna->age_ns += kMillisecond_ns;
  anna->drive(0.1);
  EXPECT_THAT(anna->receive_one()["msg"],
              HasSubstr("late: it may have been sent 201 ms ago, and is carried out for 200 ms"));
  EXPECT_THAT(robot.told, ElementsAre("walk"));
}

TEST_F(OrderAgeTest, OtherOrdersMayBeASecondOld) {
  for (const std::int64_t age_ns : {kSecond_ns, kSecond_ns + kMillisecond_ns}) {
    anna->age_ns = age_ns;
    const bool late = age_ns > kSecond_ns;
    robot.told.clear();
    for (const auto& [service, arguments] :
         {std::pair{"/move_joint", json{{"joint", "neck_yaw"}, {"position", 0.1}, {"duration", 1.0}}},
          {"/play_motion", json{{"motion", "wave"}}},
          {"/walk_to", json{{"x", 1.0}, {"y", 0.0}, {"yaw", 0.0}}},
          {"/stand", json::object()},
          {"/release", json::object()}}) {
      anna->send({{"op", "call_service"}, {"service", service}, {"args", arguments}});
      const auto answers = anna->receive();
      EXPECT_EQ(late, !answers.empty() && answers[0].dump().find("late: ") != std::string::npos) << service;
    }
    EXPECT_EQ(robot.told.empty(), late);
  }
}

TEST_F(OrderAgeTest, AStopIsNeverTooOld) {
  anna->age_ns = 3600 * kSecond_ns;
  for (const char* const service : {"/stop", "/emergency_stop"}) {
    anna->send({{"op", "call_service"}, {"service", service}, {"args", {{"data", false}}}});
  }
  EXPECT_THAT(robot.told, ElementsAre("stop", "stand", "emergency_stop hold", "stand"));
}

TEST_F(OrderAgeTest, WhoseVelocityIsLateDoesNotGetTheCommand) {
  anna->age_ns = kSecond_ns;
  anna->drive(0.1);
  EXPECT_EQ(hub.statistics().commander, "");
  EXPECT_THAT(robot.told, IsEmpty());
}

// A stick that is held over a bad link does not undo somebody's stop as soon as the link is better.
TEST_F(OrderAgeTest, WhoseVelocitiesAreLateHasNotLetGo) {
  anna->drive(0.1);
  bert->send({{"op", "call_service"}, {"service", "/stop"}});
  anna->age_ns = 300 * kMillisecond_ns;
  for (int tenth = 0; tenth < 20; ++tenth) {
    now_ns += 100 * kMillisecond_ns;
    anna->drive(0.1);
  }
  anna->receive();
  anna->age_ns = 0;
  now_ns += 100 * kMillisecond_ns;
  anna->drive(0.1);
  EXPECT_THAT(anna->receive_one()["msg"], HasSubstr("let go"));
}

// The robot's side refuses it, by its own clock.
TEST_F(OrderAgeTest, WhatTheRobotsSideRefusesIsTold) {
  anna->drive(0.1);
  robot.results.push_back({robot.last_velocity, false, "late: this velocity is older than 200 ms"});
  hub.answer(now_ns);
  const json status = anna->receive_one();
  EXPECT_EQ(status["level"], "error");
  EXPECT_THAT(status["msg"], HasSubstr("late: this velocity"));
}

}  // namespace
}  // namespace gaitway::api
