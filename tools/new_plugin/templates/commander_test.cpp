// The simulated robot with the plug-in plugin_name: it walks its square and is back where it began.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gaitway/simulator/simulated_robot.hpp"

TEST(PluginName, WalksASquare) {
  gaitway::SimulatedRobot robot({.with = {GAITWAY_PLUGIN_LIBRARY}});
  double furthest_m = 0.0;
  while (robot.is_upright() && robot.time_s() < 60.0 &&
         robot.whereabouts().heading_rad < 2.0 * std::numbers::pi - 0.1) {
    robot.run_for(0.5);
    furthest_m = std::max(furthest_m, std::hypot(robot.whereabouts().x_m, robot.whereabouts().y_m));
  }
  ASSERT_TRUE(robot.is_upright());
  EXPECT_EQ(robot.faults("plugin_name"), 0U);
  EXPECT_NEAR(robot.whereabouts().heading_rad, 2.0 * std::numbers::pi, 0.3);
  EXPECT_GT(furthest_m, 0.6);
  EXPECT_LT(std::hypot(robot.whereabouts().x_m, robot.whereabouts().y_m), 0.4);
}
