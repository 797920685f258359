// A limited command is told once, with the rule and its value.
#include "gaitway/trajectory/footstep_planner.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gaitway/trajectory/walking_pattern.hpp"

namespace gaitway::trajectory {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

WalkCommand walk(double forward_m_per_s) {
  WalkCommand command{};
  command.walk = 1;
  command.velocity[0] = forward_m_per_s;
  return command;
}

TEST(LimitReport, TellsARuleOnceForEachCommand) {
  LimitReport report(GaitParameters{});
  EXPECT_EQ(report.news(walk(1.0), StepLimit::speed), StepLimit::speed);
  EXPECT_EQ(report.news(walk(1.0), StepLimit::speed), StepLimit::none);
  EXPECT_EQ(report.news(walk(1.0), StepLimit::speed | StepLimit::turn), StepLimit::turn);
  EXPECT_EQ(report.news(walk(1.0), StepLimit::none), StepLimit::none);
  EXPECT_EQ(report.news(walk(0.9), StepLimit::speed), StepLimit::speed);
}

TEST(LimitReport, ACommandPublishedAgainIsNoNews) {
  LimitReport report(GaitParameters{});
  WalkCommand command = walk(1.0);
  EXPECT_EQ(report.news(command, StepLimit::speed), StepLimit::speed);
  command.stamp_ns += 10'000'000;
  EXPECT_EQ(report.news(command, StepLimit::speed), StepLimit::none);
}

TEST(LimitReport, NamesCommandRuleAndValue) {
  LimitReport report(GaitParameters{});
  (void)report.news(walk(1.0), StepLimit::speed);
  EXPECT_THAT(report.text(StepLimit::speed),
              AllOf(HasSubstr("walk 1, 0 m/s, 0 rad/s"), HasSubstr("rule speed"),
                    HasSubstr("at most 0.469 forward, 0.312 backward")));
  EXPECT_THAT(report.text(StepLimit::length),
              AllOf(HasSubstr("rule length"), HasSubstr("max_step_forward 0.15 m")));
  EXPECT_THAT(report.text(StepLimit::spacing), HasSubstr("max_foot_spacing 0.2 m"));
  EXPECT_THAT(report.text(StepLimit::turn), HasSubstr("max_step_turn 0.5 rad"));
  EXPECT_THAT(report.text(StepLimit::sole_gap), HasSubstr("min_sole_gap 0.008 m"));
  EXPECT_THAT(report.text(StepLimit::acceleration), HasSubstr("at most 0.25, 0.1 m/s^2, 1 rad/s^2"));
}

TEST(LimitReport, EveryLineFitsAnEvent) {
  constexpr std::size_t kLongestEvent = 160;
  LimitReport report(GaitParameters{});
  WalkCommand command = walk(-0.123456);
  command.velocity[1] = -0.0456789;
  command.turn_rate = -1.23456;
  (void)report.news(command, StepLimit::none);
  for (const StepLimit rule : kStepLimits) {
    EXPECT_LE(std::string_view(report.text(rule)).size(), kLongestEvent) << report.text(rule);
  }
}

TEST(LimitReport, AWalkTooFastIsToldByThePattern) {
  WalkingPattern pattern(GaitParameters{});
  LimitReport report(GaitParameters{});
  MotionPlan plan{};
  pattern.plan(1, 0, walk(1.0), Correction{}, plan);
  EXPECT_TRUE(has(report.news(walk(1.0), pattern.applied_limits()), StepLimit::speed));
  WalkingPattern slow(GaitParameters{});
  slow.plan(1, 0, walk(0.05), Correction{}, plan);
  EXPECT_EQ(report.news(walk(0.05), slow.applied_limits()), StepLimit::none);
}

}  // namespace
}  // namespace gaitway::trajectory
