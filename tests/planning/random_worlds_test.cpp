// Every property of a plan on many random worlds, and that the same input gives the same plan to the bit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "plan_checker.hpp"

namespace gaitway::planning {
namespace {

using testing::IsEmpty;

TEST(RandomWorlds, PlansBreakNoRule) {
  int found = 0, steps = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Scene scene = random_scene(seed);
    const Plan plan = scene.plan();
    if (!plan.found()) {
      EXPECT_FALSE(plan.explanation.empty());
      EXPECT_TRUE(plan.steps.empty());
      continue;
    }
    ++found;
    steps += static_cast<int>(plan.steps.size());
    EXPECT_THAT(faults_of(plan, scene, scene.request()), IsEmpty()) << "seed " << seed;
    EXPECT_NEAR(cost_of(small_humanoid(), scene.request().left, scene.request().right, plan.steps), plan.cost,
                1e-6);
    EXPECT_GE(plan.bound, 1.0);
  }
  EXPECT_GE(found, 25);
  EXPECT_GE(steps, 500);
}

// Steps of 10 mm, side by side and one above the other, low beams to step over, and walls.
Scene terraces(std::uint64_t seed) {
  Scene scene = random_scene(seed, 4.0, 10);
  std::erase_if(scene.world.solids,
                [](const world::Solid& solid) { return std::abs(solid.pose.translation().x()) < 1.0; });
  for (int i = 0; i < 3; ++i) {
    scene.world.solids.push_back(upright(world::Kind::step, 0.0, 0.0, 1.6 - 0.5 * i, 3.9, 0.01 * (i + 1)));
  }
  scene.world.solids.push_back(upright(world::Kind::box, -1.3, 0.3, 0.03, 2.0, 0.015));
  scene.start = {-1.7, 0.2 * static_cast<double>(seed % 5) - 0.4, 0.3};
  scene.goal = {1.7, 0.1, -0.4};
  std::erase_if(scene.world.solids, [&](const world::Solid& solid) {
    const double x = std::abs(solid.pose.translation().x());
    return solid.kind == world::Kind::box && x > 1.35;
  });
  return scene;
}

TEST(RandomWorlds, StepsAreClimbedAndLowBeamsSteppedOver) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Scene scene = terraces(seed);
    const Plan plan = scene.plan();
    ASSERT_TRUE(plan.found()) << plan.explanation;
    EXPECT_THAT(faults_of(plan, scene, scene.request()), IsEmpty()) << "seed " << seed;
    double highest_m = 0.0;
    for (const Footstep& step : plan.steps) highest_m = std::max(highest_m, step.height_m);
    EXPECT_NEAR(highest_m, 0.03, 1e-6);
  }
}

TEST(RandomWorlds, TheSameInputGivesTheSamePlanToTheBit) {
  const Planner another(small_humanoid(), kCell_m);
  for (const std::uint64_t seed : {0U, 1U, 4U, 12U}) {
    const Scene scene = random_scene(seed);
    const Plan first = scene.plan(), second = another.plan(scene.map(), scene.request());
    ASSERT_TRUE(first.found());
    ASSERT_EQ(first.steps.size(), second.steps.size());
    EXPECT_EQ(std::memcmp(&first.cost, &second.cost, sizeof first.cost), 0);
    EXPECT_EQ(std::memcmp(&first.bound, &second.bound, sizeof first.bound), 0);
    for (std::size_t i = 0; i < first.steps.size(); ++i) {
      EXPECT_EQ(std::memcmp(&first.steps[i].pose, &second.steps[i].pose, sizeof(Pose)), 0);
    }
  }
}

TEST(RandomWorlds, MoreSearchGivesNoWorsePlans) {
  for (const std::uint64_t seed : {0U, 5U, 12U}) {
    const Scene scene = random_scene(seed);
    Request request = scene.request();
    double before = std::numeric_limits<double>::infinity();
    for (const int improvements : {0, 300, 3000}) {
      request.budget.improvements = improvements;
      const Plan plan = planner().plan(scene.map(), request);
      ASSERT_TRUE(plan.found());
      EXPECT_LE(plan.cost, before);
      before = plan.cost;
    }
    int asked = 0;
    request.budget.stop = [&asked] { return ++asked > 2; };
    EXPECT_LT(planner().plan(scene.map(), request).expansions, 64 * 4);
  }
}

}  // namespace
}  // namespace gaitway::planning
