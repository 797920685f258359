// The simulated robot with the plug-in plugin_name: it steps aside and back, and its mission has succeeded.
#include <gtest/gtest.h>

#include <algorithm>

#include "gaitway/simulator/simulated_robot.hpp"

TEST(PluginName, StepsAsideAndBack) {
  gaitway::SimulatedRobot robot({.with = {GAITWAY_PLUGIN_LIBRARY}});
  robot.run_for(1.0);
  double furthest_m = 0.0;
  while (robot.is_upright() && robot.time_s() < 30.0 &&
         robot.topic<gaitway::BehaviourState>("behaviour_state").state !=
             gaitway::behaviour_state::state::succeeded) {
    robot.run_for(0.5);
    furthest_m = std::max(furthest_m, robot.whereabouts().y_m);
  }
  ASSERT_TRUE(robot.is_upright());
  EXPECT_EQ(robot.faults("plugin_name"), 0U);
  EXPECT_EQ(robot.topic<gaitway::BehaviourState>("behaviour_state").state,
            gaitway::behaviour_state::state::succeeded);
  EXPECT_GT(furthest_m, 0.15);
  EXPECT_LT(robot.whereabouts().y_m, 0.1);
}
