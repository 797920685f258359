// The velocity that clients have the robot walk with, for those who look on: it is told when it changes, and
// as 0 when it holds no more.
#include <gtest/gtest.h>

#include "test_client.hpp"

namespace gaitway::api {
namespace {

class WalkCommandTest : public HubTest {
 protected:
  std::unique_ptr<TestClient> anna = connect("anna"), bert = connect("bert");
};

TEST_F(WalkCommandTest, IsToldOnceForAllThatSayTheSame) {
  EXPECT_FALSE(hub.take_walk_command()) << "nobody has said anything";
  for (int i = 0; i < 5; ++i) {
    anna->drive(0.1, 0.2);
    pass(100 * kMillisecond_ns);
    const auto told = hub.take_walk_command();
    EXPECT_EQ(told.has_value(), i == 0);
    EXPECT_EQ(told.value_or(Velocity{0.1, 0.0, 0.2}), (Velocity{0.1, 0.0, 0.2}));
  }
  anna->drive(0.05);
  EXPECT_EQ(hub.take_walk_command(), (Velocity{0.05, 0.0, 0.0}));
}

TEST_F(WalkCommandTest, IsZeroWhenNobodySaysItAgain) {
  anna->drive(0.1);
  EXPECT_TRUE(hub.take_walk_command());
  pass(480 * kMillisecond_ns);
  EXPECT_FALSE(hub.take_walk_command());
  pass(50 * kMillisecond_ns);
  EXPECT_EQ(hub.take_walk_command(), Velocity{});
}

TEST_F(WalkCommandTest, IsZeroAfterAStopByAnybodyAndAfterAnotherOrder) {
  anna->drive(0.1);
  EXPECT_TRUE(hub.take_walk_command());
  bert->send({{"op", "call_service"}, {"service", "/stop"}});
  step();
  EXPECT_EQ(hub.take_walk_command(), Velocity{});
  pass(2 * kSecond_ns);
  anna->drive(0.1);
  EXPECT_TRUE(hub.take_walk_command());
  anna->send({{"op", "call_service"}, {"service", "/stand"}});  // answered when it stands
  step();
  EXPECT_EQ(hub.take_walk_command(), Velocity{});
  pass(2 * kSecond_ns);
  anna->drive(0.1);
  EXPECT_TRUE(hub.take_walk_command());
  anna->disconnect();
  step();
  EXPECT_EQ(hub.take_walk_command(), Velocity{});
}

TEST_F(WalkCommandTest, WhatIsRefusedIsNotTold) {
  anna->drive(0.1);
  EXPECT_TRUE(hub.take_walk_command());
  bert->drive(0.3);
  anna->drive(7.0);
  step();
  EXPECT_FALSE(hub.take_walk_command());
}

}  // namespace
}  // namespace gaitway::api
