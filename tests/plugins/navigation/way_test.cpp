// Numbers of steps, what is told of them, what is left.
#include "gaitway/navigation/way.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <numbers>

namespace gaitway::navigation {
namespace {

using planning::Footstep;
using planning::Side;

std::vector<Footstep> straight(int count, double from_m, Side first = Side::left) {
  std::vector<Footstep> steps;
  for (int i = 0; i < count; ++i) {
    const Side side = i % 2 == 0 ? first : planning::other(first);
    steps.push_back({side, {from_m + 0.1 * i, planning::sign_of(side) * 0.06, 0.0}, 0.0});
  }
  return steps;
}

TEST(Way, NumbersGoOnAfterTheStepThatItIsContinuedFrom) {
  Way way;
  EXPECT_TRUE(way.empty());
  EXPECT_EQ(way.last(), 0U);
  way.go_on(4, straight(10, 0.0));
  EXPECT_EQ(way.last(), 14U);
  EXPECT_EQ(way.find(4), nullptr);
  EXPECT_EQ(way.find(5)->pose.x_m, 0.0);
  EXPECT_EQ(way.find(15), nullptr);
  way.go_on(7, straight(3, 5.0, Side::right));
  EXPECT_EQ(way.last(), 10U);
  EXPECT_EQ(way.find(7)->pose.x_m, 0.2) << "what was walked, or is in flight, stays";
  EXPECT_EQ(way.find(8)->pose.x_m, 5.0);
  way.clear();
  way.go_on(10, straight(2, 0.0));
  EXPECT_EQ(way.find(10), nullptr);
  EXPECT_EQ(way.last(), 12U);
}

TEST(Way, TellsTheNextStepsInTheFrameOdometry) {
  Way way;
  way.go_on(0, straight(20, 0.0));
  const planning::Pose odometry{1.0, 2.0, std::numbers::pi / 2.0};
  FootstepPlan plan{};
  way.tell(3, odometry, plan);
  EXPECT_EQ(plan.first, 3U);
  EXPECT_EQ(plan.step_count, static_cast<std::uint32_t>(kMaxPlannedSteps));
  EXPECT_EQ(plan.ends, 0U);
  EXPECT_EQ(plan.side[0], 0U);
  EXPECT_EQ(plan.side[1], 1U);
  // (0.2, 0.06) as seen from (1, 2), where x points along the world's y.
  EXPECT_NEAR(plan.step[0][0], 0.06 - 2.0, 1e-12);
  EXPECT_NEAR(plan.step[0][1], -(0.2 - 1.0), 1e-12);
  EXPECT_NEAR(plan.step[0][2], -std::numbers::pi / 2.0, 1e-12);
  way.tell(15, odometry, plan);
  EXPECT_EQ(plan.step_count, 6U);
  EXPECT_EQ(plan.ends, 1U);
  way.tell(21, odometry, plan);
  EXPECT_EQ(plan.step_count, 0U);
}

TEST(Way, ToldBeforeItsFirstStepItBeginsWithThat) {
  Way way;
  way.go_on(43, straight(4, 0.0));
  FootstepPlan plan{};
  way.tell(28, {}, plan);
  EXPECT_EQ(plan.first, 44U);
  EXPECT_EQ(plan.step_count, 4U);
}

TEST(Way, TellsWhatIsLeft) {
  Way way;
  way.go_on(0, straight(11, 0.1));
  const auto rest = std::make_unique<NavigationWay>();
  way.tell_rest(5, *rest);
  EXPECT_EQ(rest->first, 6U);
  EXPECT_EQ(rest->step_count, 6U);
  EXPECT_FLOAT_EQ(rest->step[0][0], 0.6F);
  EXPECT_EQ(rest->side[0], 1);
  EXPECT_NEAR(way.distance_left_m(5, {0.55, 0.0, 0.0}), 1.05 - 0.55, 1e-9)
      << "to the middle of the last feet";
}

}  // namespace
}  // namespace gaitway::navigation
