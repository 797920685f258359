// The simulated robot with the plug-in plugin_name: it walks with the new gait, and lifts its feet higher.
#include <gtest/gtest.h>

#include <algorithm>

#include "gaitway/simulator/simulated_robot.hpp"

TEST(PluginName, WalksWithHighSteps) {
  gaitway::SimulatedRobot robot({.with = {GAITWAY_PLUGIN_LIBRARY}});
  robot.run_for(1.0);
  robot.walk(0.12);
  double highest_m = 0.0;
  while (robot.is_upright() && robot.time_s() < 11.0) {
    robot.run_for(0.08);
    const auto plan = robot.topic<gaitway::MotionPlan>("motion_plan");
    highest_m = std::max({highest_m, plan.foot_position[0][0][2], plan.foot_position[0][1][2]});
  }
  ASSERT_TRUE(robot.is_upright());
  EXPECT_EQ(robot.faults("plugin_name"), 0U);
  EXPECT_GT(robot.whereabouts().x_m, 0.8);
  EXPECT_GT(highest_m, 0.04);
}
