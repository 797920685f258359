// The simulated robot with the plug-in plugin_name: it walks, and withstands a push from the side.
#include <gtest/gtest.h>

#include "gaitway/simulator/simulated_robot.hpp"

TEST(PluginName, KeepsTheWalkUpright) {
  gaitway::SimulatedRobot robot({.with = {GAITWAY_PLUGIN_LIBRARY}});
  robot.run_for(1.0);
  robot.walk(0.12);
  robot.run_for(6.0);
  robot.push("trunk", {0.0, 0.4, 0.0});
  robot.run_for(6.0);
  ASSERT_TRUE(robot.is_upright());
  EXPECT_EQ(robot.faults("plugin_name"), 0U);
  EXPECT_GT(robot.whereabouts().x_m, 1.0);
}
