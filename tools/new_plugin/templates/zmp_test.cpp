// The simulated robot with the plug-in plugin_name: it walks on its estimate; a strong push tips a foot.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gaitway/simulator/simulated_robot.hpp"

TEST(PluginName, EstimatesAndTellsOfATippingFoot) {
  gaitway::SimulatedRobot robot({.with = {GAITWAY_PLUGIN_LIBRARY}});
  robot.run_for(1.0);
  robot.walk(0.12);
  robot.run_for(8.0);
  ASSERT_TRUE(robot.is_upright());
  EXPECT_EQ(robot.faults("plugin_name"), 0U);
  EXPECT_GT(robot.whereabouts().x_m, 0.7);
  robot.push("trunk", {0.0, 3.0, 0.0});
  robot.run_for(1.0);
  EXPECT_THAT(robot.events(), testing::Contains(testing::EndsWith("foot at its edge")));
}
