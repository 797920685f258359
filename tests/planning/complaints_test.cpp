// What users of other footstep planners complain about: a start that is "not accessible", a step onto the own
// foot, and turning to and fro before an obstacle when plans are made anew.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "gaitway/facts/random_stream.hpp"
#include "plan_checker.hpp"

namespace gaitway::planning {
namespace {

using testing::IsEmpty;
using world::Kind;

// Feet anywhere between the lattice's places, astride and turned, closer to walls than any plan would come.
TEST(StartIsAccessible, WhereverTheFeetCanStand) {
  const Limits limits = small_humanoid();
  facts::RandomStream random(1, 2);
  for (int trial = 0; trial < 40; ++trial) {
    Scene scene = floor(3.0, 3.0);
    scene.start = {-0.5 + 0.02 * random.uniform(), 0.3 * random.uniform(), 6.28 * random.uniform() - 3.14};
    scene.goal = {1.0, 0.0, 0.0};
    // In a corner of two walls, 25 mm from the body: nearer than its clearance.
    const auto wall = [&](double ahead_m, double left_m, double length_m, double width_m) {
      const Pose at = scene.start.compose({ahead_m, left_m, 0.0});
      scene.world.solids.push_back(upright(Kind::wall, at.x_m, at.y_m, length_m, width_m, 0.5, at.yaw_rad));
    };
    wall(0.09 + 0.025 + 0.01, 0.0, 0.02, 0.3);
    wall(0.0, 0.165 + 0.025 + 0.01, 0.2, 0.02);
    Request request = scene.request();
    // As a walk leaves them: one ahead of the other.
    const double ahead_m = -0.04 * random.uniform();
    request.right = request.right.compose({ahead_m, -0.02 * random.uniform(), -0.2 * random.uniform()});
    const Plan plan = planner().plan(scene.map(), request);
    ASSERT_TRUE(plan.found()) << trial << ": " << plan.explanation;
    EXPECT_THAT(faults_of(plan, scene, request), IsEmpty()) << trial;
  }
}

TEST(StartIsAccessible, OnAnEdgeThatTheFeetStandOnAlready) {
  Scene scene = floor(3.0, 3.0);
  scene.world.solids = {upright(Kind::step, -1.0, 0.0, 0.1, 2.0, 0.008)};
  scene.start = {-1.0, 0.0, 0.0};
  scene.goal = {1.0, 0.0, 0.0};
  const Plan plan = scene.plan();
  ASSERT_TRUE(plan.found()) << plan.explanation;
}

// Turning on the spot and walking in narrow bends is where soles come near each other.
TEST(OwnFoot, IsNeverSteppedOn) {
  const Limits limits = small_humanoid();
  for (int i = -8; i <= 8; ++i) {
    Scene scene = floor(2.0, 2.0);
    scene.start = {0.0, 0.0, 0.1};
    scene.goal = {0.05 * (i % 3), -0.04 * (i % 5), 0.1 + std::numbers::pi / 8.0 * i};
    const Plan plan = scene.plan();
    ASSERT_TRUE(plan.found()) << i << ": " << plan.explanation;
    EXPECT_THAT(faults_of(plan, scene, scene.request()), IsEmpty()) << i;  // soles keep their gap
  }
  // From feet that stand so near to each other that no step could have brought them there.
  Scene scene = floor(2.0, 2.0);
  scene.goal = {0.5, 0.0, 0.0};
  Request request = scene.request();
  request.left.y_m = 0.043;
  request.right.y_m = -0.043;
  const Plan plan = planner().plan(scene.map(), request);
  ASSERT_TRUE(plan.found());
  EXPECT_THAT(faults_of(plan, scene, request), IsEmpty());
}

// On which side of the obstacle the way to the goal goes by: +1 left, -1 right.
int side_of(const Plan& plan) {
  double left_m = 0.0;
  for (const Footstep& step : plan.steps) {
    if (std::abs(step.pose.x_m) < 0.25) left_m += step.pose.y_m;
  }
  return left_m > 0.0 ? 1 : -1;
}

// The obstacle is seen some centimetres to the left and to the right in turn, so that now the one way and now
// the other is a little shorter, and the plan is made anew after each step.
TEST(Replanning, KeepsToTheSideThatItHasChosen) {
  Scene scene = floor(4.0, 4.0);
  scene.start = {-1.2, 0.0, 0.0};
  scene.goal = {1.2, 0.0, 0.0};
  const auto seen = [&](double left_m) {
    Scene one = scene;
    one.world.solids = {upright(Kind::box, 0.0, left_m, 0.3, 0.8, 0.3)};
    return one;
  };
  EXPECT_NE(side_of(seen(0.03).plan()),
            side_of(seen(-0.03).plan()));  // without a memory it would change sides
  Request request = scene.request();
  Plan plan = seen(0.03).plan();
  const int side = side_of(plan);
  int steps = 0;
  for (; steps < 60 && !plan.steps.empty(); ++steps) {
    const Footstep step = plan.steps.front();
    (step.side == Side::left ? request.left : request.right) = step.pose;
    const Scene now = seen(steps % 2 == 0 ? -0.03 : 0.03);
    const std::vector<Footstep> previous = plan.steps;
    request.previous = previous;
    plan = planner().plan(now.map(), request);
    ASSERT_TRUE(plan.found()) << plan.explanation;
    Scene checked = now;
    EXPECT_THAT(faults_of(plan, checked, request), IsEmpty()) << steps;
    if (plan.steps.size() > 12) {
      EXPECT_EQ(side_of(plan), side) << steps;
    }
  }
  EXPECT_TRUE(plan.steps.empty());
  EXPECT_LT(steps, 30);
}

TEST(Replanning, LeavesAPlanThatIsBlockedOrMuchTooLong) {
  Scene scene = floor(4.0, 4.0);
  scene.start = {-1.2, 0.0, 0.0};
  scene.goal = {1.2, 0.0, 0.0};
  scene.world.solids = {upright(Kind::box, 0.0, 0.3, 0.3, 1.0, 0.3)};
  const Plan right = scene.plan();
  EXPECT_EQ(side_of(right), -1);
  Request request = scene.request();
  request.previous = right.steps;
  EXPECT_TRUE(planner().plan(scene.map(), request).kept);
  scene.world.solids = {upright(Kind::box, 0.0, -0.3, 0.3, 1.0, 0.3)};  // where the plan goes along
  const Plan other_way = planner().plan(scene.map(), request);
  ASSERT_TRUE(other_way.found());
  EXPECT_FALSE(other_way.kept);
  EXPECT_EQ(side_of(other_way), 1);
  scene.world.solids.clear();
  const Plan straight = planner().plan(scene.map(), request);
  EXPECT_LT(straight.cost, cost_of(small_humanoid(), request.left, request.right, right.steps));
}

}  // namespace
}  // namespace gaitway::planning
