// The simulated robot with the plug-in plugin_name: its mission runs, and orders a step aside.
#include <gtest/gtest.h>

#include "gaitway/simulator/simulated_robot.hpp"

TEST(PluginName, OrdersAStepAside) {
  gaitway::SimulatedRobot robot({.with = {GAITWAY_PLUGIN_LIBRARY}});
  robot.run_for(3.0);
  ASSERT_TRUE(robot.is_upright());
  EXPECT_EQ(robot.faults("plugin_name"), 0U);
  EXPECT_EQ(robot.topic<gaitway::BehaviourState>("behaviour_state").state,
            gaitway::behaviour_state::state::runs);
  const auto walk = robot.topic<gaitway::WalkCommand>("behaviour_walk");
  EXPECT_EQ(walk.walk, 1U);
  EXPECT_GT(walk.velocity[1], 0.0);
}
