// The simulated robot with the plug-in plugin_name: it walks a curve and looks into it.
#include <gtest/gtest.h>

#include "gaitway/simulator/simulated_robot.hpp"

TEST(PluginName, LooksIntoTheCurve) {
  gaitway::SimulatedRobot robot({.with = {GAITWAY_PLUGIN_LIBRARY}});
  robot.run_for(1.0);
  robot.walk(0.1, 0.0, 0.2);
  robot.run_for(4.0);
  EXPECT_NEAR(robot.joint_position("neck_yaw"), 0.4, 0.05);  // 2 s ahead, to the left
  robot.walk(0.1, 0.0, -0.2);
  robot.run_for(4.0);
  EXPECT_NEAR(robot.joint_position("neck_yaw"), -0.4, 0.05);
  ASSERT_TRUE(robot.is_upright());
  EXPECT_EQ(robot.faults("plugin_name"), 0U);
}
