// A stand is answered when the robot stands, or with the reason why it does not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "test_client.hpp"

namespace gaitway::api {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class StandServiceTest : public HubTest {
 protected:
  StandServiceTest() {
    robot.does = "walks";
    robot.time_ns = 100 * kSecond_ns;
  }
  void call_stand(TestClient& by, const json& more = json::object()) {
    json call{{"op", "call_service"}, {"service", "/stand"}};
    call.update(more);
    by.send(call);
  }
  // Both clocks go on.
  void pass_time(std::int64_t duration_ns) {
    robot.time_ns += duration_ns;
    pass(duration_ns);
  }
  json answer() { return client->receive_one()["values"]; }

  std::unique_ptr<TestClient> client = connect("anna"), watcher = connect("watcher");
};

TEST_F(StandServiceTest, IsAnsweredWhenTheRobotStands) {
  call_stand(*client);
  EXPECT_EQ(robot.told.back(), "stand");
  pass_time(kSecond_ns);
  EXPECT_THAT(client->receive(), IsEmpty());
  robot.does = "stands";
  step();
  EXPECT_EQ(answer(), (json{{"success", true}, {"message", "stands"}}));
  pass_time(kSecond_ns);
  EXPECT_THAT(client->receive(), IsEmpty()) << "once";
}

TEST_F(StandServiceTest, OfARobotThatStandsIsAnsweredAtOnce) {
  robot.does = "stands";
  call_stand(*client);
  EXPECT_EQ(answer()["success"], true);
}

TEST_F(StandServiceTest, AWalkThatHasNotBegunYetIsNoStand) {
  robot.does = "stands";
  client->drive(0.1);
  call_stand(*client);
  pass_time(200 * kMillisecond_ns);
  EXPECT_THAT(client->receive(), IsEmpty()) << "it may still begin";
  pass_time(400 * kMillisecond_ns);
  EXPECT_EQ(answer()["success"], true);
}

TEST_F(StandServiceTest, ThatComesTooLateSaysWhatTheRobotDoes) {
  call_stand(*client, {{"timeout", 2.0}});
  pass_time(2 * kSecond_ns - 10 * kMillisecond_ns);
  EXPECT_THAT(client->receive(), IsEmpty());
  pass_time(10 * kMillisecond_ns);
  const json late = client->receive_one();
  EXPECT_EQ(late["result"], false);
  EXPECT_THAT(late["values"], AllOf(HasSubstr("within 2"), HasSubstr("it walks")));
  call_stand(*client);
  pass_time(10 * kSecond_ns);
  EXPECT_EQ(client->receive_one()["result"], false) << "without a time of its own after the usual one";
}

TEST_F(StandServiceTest, WhatPreventsItIsSaidAtOnce) {
  for (const auto& [does, why] :
       {std::pair("stopped", "emergency stop"), {"falls", "falls"}, {"fallen", "has fallen"}}) {
    robot.does = "walks";
    call_stand(*client);
    robot.does = does;
    step();
    const json values = answer();
    EXPECT_EQ(values["success"], false);
    EXPECT_THAT(values["message"], HasSubstr(why));
  }
}

TEST_F(StandServiceTest, AStopInBetweenIsSaid) {
  call_stand(*client);
  watcher->send({{"op", "call_service"}, {"service", "/stop"}});
  step();
  const json values = answer();
  EXPECT_EQ(values["success"], false);
  EXPECT_THAT(values["message"], HasSubstr("a stop came meanwhile"));
  call_stand(*client);
  client->receive();
  pass_time(2 * kSecond_ns);  // its stick is let go
  client->receive();
  call_stand(*client);
  hub.stopped_by_datagram();
  step();
  EXPECT_THAT(answer()["message"], HasSubstr("a stop came meanwhile"));
}

TEST_F(StandServiceTest, ALostLinkIsSaid) {
  call_stand(*client);
  hub.robot_lost();
  EXPECT_THAT(answer()["message"], HasSubstr("the link to the robot was lost meanwhile"));
  pass_time(2 * kSecond_ns);
  call_stand(*client);
  robot.is_connected = false;
  step();
  EXPECT_THAT(answer()["message"], HasSubstr("not there any more"));
}

TEST_F(StandServiceTest, OneClientWaitsForFew) {
  for (int i = 0; i < 100; ++i) {
    call_stand(*client);
  }
  EXPECT_THAT(client->receive(), SizeIs(92)) << "refused at once";
  robot.does = "stands";
  step();
  EXPECT_THAT(client->receive(), SizeIs(8));
}

TEST_F(StandServiceTest, WhoHasGoneIsAnsweredNoMore) {
  call_stand(*client);
  client->disconnect();
  robot.does = "stands";
  step();
  EXPECT_THAT(watcher->receive(), IsEmpty());
}

}  // namespace
}  // namespace gaitway::api
