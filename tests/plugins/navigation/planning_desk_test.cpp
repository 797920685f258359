// When plans are handed out, and which are not.
#include "gaitway/navigation/planning_desk.hpp"

#include <gtest/gtest.h>

#include <atomic>

namespace gaitway::navigation {
namespace {

constexpr std::int64_t kCycle_ns = 80'000'000;

planning::Plan plan_of(int expansions) {
  planning::Plan plan;
  plan.expansions = expansions;
  return plan;
}

TEST(PlanningDesk, InTheStepAPlanIsHandedOutOneCycleLaterAndOnce) {
  PlanningDesk desk(PlanningDesk::Where::in_step);
  EXPECT_FALSE(desk.take(0));
  desk.submit([] { return plan_of(7); }, 1000);
  EXPECT_TRUE(desk.waits());
  EXPECT_FALSE(desk.take(1000 + kCycle_ns - 1));
  const auto plan = desk.take(1000 + kCycle_ns);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->expansions, 7);
  EXPECT_FALSE(desk.waits());
  EXPECT_FALSE(desk.take(1000 + 2 * kCycle_ns));
}

TEST(PlanningDesk, BesideTheStepsNobodyWaitsForAJob) {
  std::atomic<bool> may_go_on = false, is_done = false;
  PlanningDesk desk(PlanningDesk::Where::beside);
  desk.submit(
      [&] {
        may_go_on.wait(false);
        is_done = true;
        is_done.notify_one();
        return plan_of(3);
      },
      0);
  EXPECT_FALSE(desk.take(kCycle_ns));
  may_go_on = true;
  may_go_on.notify_one();
  is_done.wait(false);
  auto plan = desk.take(kCycle_ns);
  while (!plan) plan = desk.take(kCycle_ns);
  EXPECT_EQ(plan->expansions, 3);
}

TEST(PlanningDesk, APlanThatNobodyWantsAnyMoreIsNeverHandedOut) {
  std::atomic<int> done = 0;
  PlanningDesk desk(PlanningDesk::Where::beside);
  const auto job = [&done](int number) {
    return [&done, number] {
      ++done;
      done.notify_one();
      return plan_of(number);
    };
  };
  desk.submit(job(1), 0);
  done.wait(0);
  desk.forget();
  EXPECT_FALSE(desk.take(0));
  desk.submit(job(2), 0);
  auto plan = desk.take(0);
  while (!plan) plan = desk.take(0);
  EXPECT_EQ(plan->expansions, 2) << "the first one's was thrown away";
}

TEST(PlanningDesk, EndsWhileAJobIsUnderWay) {
  std::atomic<bool> began = false;
  {
    PlanningDesk desk(PlanningDesk::Where::beside);
    desk.submit(
        [&] {
          began = true;
          began.notify_one();
          return plan_of(1);
        },
        0);
    began.wait(false);
  }
  SUCCEED() << "its thread was joined";
}

}  // namespace
}  // namespace gaitway::navigation
