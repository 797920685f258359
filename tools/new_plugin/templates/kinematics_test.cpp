// The simulated robot with the plug-in plugin_name: it walks, and its arms swing in turn.
#include <gtest/gtest.h>

#include <algorithm>

#include "gaitway/simulator/simulated_robot.hpp"

TEST(PluginName, SwingsTheArms) {
  gaitway::SimulatedRobot robot({.with = {GAITWAY_PLUGIN_LIBRARY}});
  robot.run_for(1.0);
  const double home_rad = robot.joint_position("left_shoulder_pitch");
  robot.walk(0.15);
  double forward_rad = 0.0, back_rad = 0.0;
  while (robot.is_upright() && robot.time_s() < 9.0) {
    robot.run_for(0.05);
    const double swing_rad = robot.joint_position("left_shoulder_pitch") - home_rad;
    forward_rad = std::max(forward_rad, -swing_rad);
    back_rad = std::max(back_rad, swing_rad);
  }
  ASSERT_TRUE(robot.is_upright());
  EXPECT_EQ(robot.faults("plugin_name"), 0U);
  EXPECT_GT(robot.whereabouts().x_m, 0.8);
  EXPECT_GT(forward_rad, 0.1);
  EXPECT_GT(back_rad, 0.1);
}
