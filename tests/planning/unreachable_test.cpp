// What cannot be reached is told, with the reason, and soon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "plan_checker.hpp"

namespace gaitway::planning {
namespace {

using testing::HasSubstr;
using world::Kind;

// A floor of 4 m x 3 m, from one end to the other.
Scene room() {
  Scene scene = floor(4.0, 3.0);
  scene.start = {-1.5, 0.0, 0.0};
  scene.goal = {1.5, 0.0, 0.0};
  return scene;
}
void expect_reason(const Scene& scene, Reason reason, const std::string& part) {
  const Plan plan = scene.plan();
  EXPECT_STREQ(name(plan.reason), name(reason)) << plan.explanation;
  EXPECT_THAT(plan.explanation, HasSubstr(part));
  EXPECT_TRUE(plan.steps.empty());
}

TEST(Unreachable, StartAndGoalOnTheMap) {
  Scene scene = room();
  scene.goal.x_m = 2.5;
  expect_reason(scene, Reason::goal_outside_map,
                "the goal (2.50, 0.00) m is not on the map, which has x from -2.00");
  scene = room();
  scene.start.y_m = -7.0;
  expect_reason(scene, Reason::start_outside_map, "(-1.50, -7.00) m are not on the map");
  scene.start.y_m = 1e12;
  expect_reason(scene, Reason::start_outside_map, "are not on the map");
}

TEST(Unreachable, StartAndGoalInObstacles) {
  Scene scene = room();
  scene.world.solids = {upright(Kind::box, 1.5, 0.05, 0.3, 0.3, 0.2)};
  expect_reason(scene, Reason::goal_in_obstacle, "the goal (1.50, 0.00) m is inside of an obstacle");
  scene.world.solids = {upright(Kind::box, -1.5, 0.05, 0.3, 0.3, 0.2)};
  expect_reason(scene, Reason::start_in_obstacle, "the robot at (-1.50, 0.00) m is inside of an obstacle");
  scene.world.solids = {upright(Kind::wall, -1.5, 0.14, 1.0, 0.05, 1.0)};  // beside the feet, in the arm
  expect_reason(scene, Reason::start_in_obstacle, "inside of an obstacle");
}

TEST(Unreachable, GoalsWhereOneCannotStand) {
  Scene scene = room();
  scene.world.solids = {upright(Kind::box, 1.5, 0.2, 0.05, 0.05, 0.4)};
  expect_reason(scene, Reason::goal_without_room, "the body has no room");
  scene.world.solids = {upright(Kind::step, 1.5, 0.05, 0.4, 0.08, 0.008)};
  expect_reason(scene, Reason::goal_without_footing, "has an edge");
  scene.world.solids = {upright(Kind::step, 1.5, 0.0, 0.8, 0.8, 0.05)};
  expect_reason(scene, Reason::goal_too_high, "lies at 50 mm, and no steps of at most 10 mm");
}

TEST(Unreachable, WaysThatAreClosed) {
  Scene scene = room();
  scene.world.solids = {upright(Kind::wall, 0.0, 0.0, 0.1, 3.2, 1.0)};
  expect_reason(scene, Reason::enclosed, "obstacles enclose");
  scene.world.solids = {upright(Kind::wall, 0.0, -0.85, 0.1, 1.6, 1.0),
                        upright(Kind::wall, 0.0, 0.85, 0.1, 1.6, 1.0)};
  expect_reason(scene, Reason::too_narrow, "too narrow for the body");
  // Wider than the body is deep, and narrower than it is with its clearance, along 1 m.
  scene.world.solids = {upright(Kind::wall, 0.0, -0.82, 1.0, 1.5, 1.0),
                        upright(Kind::wall, 0.0, 0.82, 1.0, 1.5, 1.0)};
  expect_reason(scene, Reason::too_narrow, "too narrow for the body");
  scene.world.solids = {upright(Kind::wall, 0.0, 0.0, 0.1, 3.2, 0.5, 0.0, 0.7)};
  expect_reason(scene, Reason::enclosed, "obstacles enclose");
}

TEST(Unreachable, SomethingHangsTooLow) {
  Scene scene = room();
  scene.world.solids = {upright(Kind::wall, 0.0, 0.0, 0.1, 3.2, 0.5, 0.0, 0.7)};
  const GroundMap map = ground_map(scene.world, scene.grid, 0.5);  // what begins at 0.7 m hangs
  EXPECT_STREQ(name(planner().plan(map, scene.request()).reason), "too_low");
}

TEST(Unreachable, StepsThatAreTooHighAndGapsThatAreTooWide) {
  Scene scene = room();
  scene.world.solids = {upright(Kind::step, 0.0, 0.0, 1.0, 3.2, 0.05)};
  expect_reason(scene, Reason::too_high, "has a step of more than 10 mm");
  scene.world.solids = {upright(Kind::step, 0.0, 0.0, 1.0, 3.2, 0.015)};  // too low to be in anything's way
  expect_reason(scene, Reason::too_high, "has a step of more than 10 mm");
  scene.world.solids = {upright(Kind::box, 0.0, 0.0, 0.6, 3.2, 0.015)};  // low, and not to be stood on
  expect_reason(scene, Reason::no_footing, "too wide to step over");
}

TEST(Unreachable, LittleSearchIsToldAsSuch) {
  Scene scene = random_scene(0);
  Request request = scene.request();
  request.budget.expansions = 10;
  const Plan plan = planner().plan(scene.map(), request);
  EXPECT_EQ(plan.reason, Reason::out_of_budget);
  EXPECT_THAT(plan.explanation, HasSubstr("in 10 expansions"));
}

TEST(Unreachable, NonsenseIsRefused) {
  Scene scene = room();
  Request request = scene.request();
  request.goal.yaw_rad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)planner().plan(scene.map(), request), std::invalid_argument);
  GroundMap map = scene.map();
  map.surface_m.pop_back();
  EXPECT_THROW((void)planner().plan(map, scene.request()), std::invalid_argument);
  scene.grid.cell_m = 0.02;
  EXPECT_THROW((void)planner().plan(scene.map(), scene.request()), std::invalid_argument);
  Limits limits = small_humanoid();
  limits.bands[0].outline_m[0] = {0.2, 0.2};
  EXPECT_THROW(Planner(limits, kCell_m), std::invalid_argument);
  limits = small_humanoid();
  limits.max_step_turn_rad = -0.1;
  EXPECT_THROW(Planner(limits, kCell_m), std::invalid_argument);
  EXPECT_THROW(Planner(small_humanoid(), 0.05), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::planning
