// Which word is told for what the robot's parts publish.
#include "gaitway/api/robot_activity.hpp"

#include <gtest/gtest.h>

#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

class RobotActivityTest : public testing::Test {
 protected:
  [[nodiscard]] Activity told() const {
    return activity_of({.network = &network,
                        .estimate = &estimate,
                        .planned = &planned,
                        .motion = &motion,
                        .heartbeat_age_ns = heartbeat_age_ns});
  }

  NetworkState network{};
  Estimate estimate{};
  PlannedState planned{};
  gaitway::MotionState motion{};
  std::int64_t heartbeat_age_ns = 0;
};

TEST_F(RobotActivityTest, StandsOnBothFeet) {
  EXPECT_EQ(told(), Activity::stands);
  network.mode = network_state::mode::holding;
  planned.walks = 1;
  EXPECT_EQ(told(), Activity::stands) << "it waits for a batch, whatever was planned";
}

TEST_F(RobotActivityTest, WalksAsItIsPlannedTo) {
  planned.walks = 1;
  EXPECT_EQ(told(), Activity::walks);
}

TEST_F(RobotActivityTest, WhatIsWorseIsToldFirst) {
  motion.state = 1;
  EXPECT_EQ(told(), Activity::plays);
  network.mode = network_state::mode::safe_tail;
  EXPECT_EQ(told(), Activity::stops);
  estimate.fall = estimate::fall::falls;
  EXPECT_EQ(told(), Activity::falls);
  estimate.fall = estimate::fall::lies;
  EXPECT_EQ(told(), Activity::fallen);
  network.mode = network_state::mode::emergency_stop;
  EXPECT_EQ(told(), Activity::stopped);
  heartbeat_age_ns = facts::kSecond_ns;
  EXPECT_EQ(told(), Activity::gone);
}

TEST_F(RobotActivityTest, NothingKnownIsGone) {
  EXPECT_EQ(activity_of({}), Activity::gone);
}

// A module that has just come back has the mode before the plan.
TEST_F(RobotActivityTest, DoesNotStandWhileNobodyKnowsWhatIsPlanned) {
  EXPECT_EQ(activity_of({.network = &network, .estimate = &estimate}), Activity::gone);
  network.mode = network_state::mode::holding;
  EXPECT_EQ(activity_of({.network = &network, .estimate = &estimate}), Activity::stands);
}

TEST_F(RobotActivityTest, HasAWordForEach) {
  EXPECT_EQ(robot_state_of(Activity::stands, 0).state, "stands");
  const ros::RobotState gone = robot_state_of(Activity::gone, facts::kSecond_ns);
  EXPECT_EQ(gone.state, "gone");
  EXPECT_EQ(gone.header.stamp.sec, 1);
}

}  // namespace
}  // namespace gaitway::api
