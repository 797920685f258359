// The checker itself: it finds each kind of fault that is put into a plan.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan_checker.hpp"

namespace gaitway::planning {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class PlanChecker : public ::testing::Test {
 protected:
  PlanChecker() : scene_(floor(3.0, 3.0)) {
    scene_.start = {-1.0, 0.0, 0.0};
    scene_.goal = {1.0, 0.0, 0.0};
    plan_ = scene_.plan();
  }
  std::vector<std::string> faults() { return faults_of(plan_, scene_, scene_.request()); }

  Scene scene_;
  Plan plan_;
};

TEST_F(PlanChecker, HasNothingAgainstAGoodPlan) {
  ASSERT_GT(plan_.steps.size(), 12U);
  EXPECT_THAT(faults(), IsEmpty());
}

TEST_F(PlanChecker, SeesStepsBeyondTheLimits) {
  plan_.steps[4].pose.x_m += 0.1;
  EXPECT_THAT(faults(), Contains(HasSubstr("m ahead")));
  plan_.steps[4].pose.x_m -= 0.1;
  plan_.steps[4].pose.yaw_rad += 0.6;
  EXPECT_THAT(faults(), Contains(HasSubstr("turned by")));
}

TEST_F(PlanChecker, SeesSolesThatComeTooNear) {
  Footstep& step = plan_.steps[4];
  step.pose.y_m -= 0.02 * sign_of(step.side);
  EXPECT_THAT(faults(), Contains(HasSubstr("soles")));
}

TEST_F(PlanChecker, SeesObstaclesEdgesAndHeights) {
  scene_.world.solids = {upright(world::Kind::box, 0.0, 0.0, 0.05, 0.4, 0.005)};
  EXPECT_THAT(faults(), Contains(HasSubstr("on an obstacle")));
  scene_.world.solids = {upright(world::Kind::step, 0.0, 0.0, 0.05, 0.4, 0.008)};
  EXPECT_THAT(faults(), Contains(HasSubstr("the ground differs")));
  scene_.world.solids = {upright(world::Kind::step, 0.0, 0.0, 0.6, 0.6, 0.04)};
  for (Footstep& step : plan_.steps) {
    if (std::abs(step.pose.x_m) < 0.3) step.height_m = 0.04;
  }
  EXPECT_THAT(faults(), Contains(HasSubstr("up or down")));
  scene_.world.solids = {upright(world::Kind::box, 0.0, 0.0, 0.02, 1.0, 0.2)};
  EXPECT_THAT(faults(), Contains(HasSubstr("the swing foot meets something")));
  scene_.world.solids = {upright(world::Kind::box, 0.0, 0.2, 0.02, 0.05, 0.5)};
  EXPECT_THAT(faults(), Contains(HasSubstr("the body comes")));
}

TEST_F(PlanChecker, SeesAGoalThatIsMissed) {
  plan_.steps.pop_back();
  EXPECT_THAT(faults(), Contains(HasSubstr("does not stand at the goal")));
}

}  // namespace
}  // namespace gaitway::planning
