// The simulated robot with the plug-in plugin_name: it walks as without it, and the plug-in tells of its
// steps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gaitway/simulator/simulated_robot.hpp"

TEST(PluginName, CountsSteps) {
  gaitway::SimulatedRobot robot({.with = {GAITWAY_PLUGIN_LIBRARY}});
  robot.run_for(1.0);
  robot.walk(0.15);
  robot.run_for(10.0);
  ASSERT_TRUE(robot.is_upright());
  EXPECT_EQ(robot.faults("plugin_name"), 0U);
  EXPECT_THAT(robot.events(), testing::Contains(testing::StartsWith("plugin_name: 20 steps")));
}
