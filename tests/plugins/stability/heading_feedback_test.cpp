// Heading feedback against a robot whose feet slip.
#include "gaitway/facts/facts.hpp"
#include "gaitway/stability/batch_feedback.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "test_robot.hpp"

namespace gaitway::stability {
namespace {

using facts::kSlot_s;
using test::kDefaults;

constexpr double kDegree = 3.14159265358979 / 180.0;

TEST(HeadingFeedback, TurnsAgainstTheErrorAndNoFasterThanItsLimit) {
  for (const double sign : {-1.0, 1.0}) {
    HeadingFeedback feedback{kDefaults};
    feedback.update(0.0, 0.0, true);
    double measured = 0.0, turn_rate = 0.0;
    for (int i = 0; i < 50; ++i) turn_rate = feedback.update(measured += sign * 0.001, 0.0, true);
    EXPECT_LT(sign * turn_rate, -0.01);
    EXPECT_GT(sign * turn_rate, -0.05);
    for (int i = 0; i < 100; ++i) turn_rate = feedback.update(measured += sign * 0.02, 0.0, true);
    EXPECT_DOUBLE_EQ(turn_rate, -sign * BalanceParameters{}.heading_limit_rad_per_s);
  }
}

TEST(HeadingFeedback, HeadingsThatAgreeNeedNoCorrection) {
  HeadingFeedback feedback{kDefaults};
  for (int i = 0; i < 500; ++i) {
    EXPECT_NEAR(feedback.update(1.3 + 0.005 * i, 0.2 + 0.005 * i, true), 0.0, 1e-9);  // turns as planned
  }
}

// The plan turns as commanded plus the correction of 0.6 s ago (footsteps are fixed by then); the feet slip
// by 3 degrees/s.
double heading_after(double seconds, double commanded_rad_per_s, double gain_per_s) {
  BalanceParameters parameters;
  parameters.heading_gain_per_s = gain_per_s;
  HeadingFeedback feedback(parameters);
  std::deque<double> delayed(60, 0.0);
  double planned = 0.0, slipped = 0.0, worst_late = 0.0;
  for (int i = 0; i < static_cast<int>(seconds / kSlot_s); ++i) {
    const double t = i * kSlot_s;
    planned += (commanded_rad_per_s + delayed.front()) * kSlot_s;
    delayed.pop_front();
    slipped += 2.1 * kDegree * kSlot_s;
    const double swing = 1.0 * kDegree * std::sin(2.0 * M_PI * 1.25 * t);  // the trunk's, with the steps
    const double heading = planned + slipped;
    const double commanded = commanded_rad_per_s * (t + kSlot_s);
    delayed.push_back(feedback.update(heading + swing, commanded, true));
    if (t > 10.0) worst_late = std::max(worst_late, std::abs(heading - commanded));
  }
  return worst_late;
}

TEST(HeadingFeedback, SlippingRobotKeepsItsHeadingWithinFiveDegrees) {
  EXPECT_LT(heading_after(60.0, 0.0, 1.0), 5.0 * kDegree);
  EXPECT_LT(heading_after(60.0, 0.3, 1.0), 5.0 * kDegree);
  EXPECT_GT(heading_after(60.0, 0.0, 0.0), 100.0 * kDegree);  // without feedback
}

TEST(HeadingFeedback, WhileStandingTheErrorIsRememberedNotCorrected) {
  HeadingFeedback feedback{kDefaults};
  double measured = 0.0;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(feedback.update(measured += 0.001, 0.0, false), 0.0);
  EXPECT_LT(feedback.update(measured, 0.0, true), -0.02);
}

TEST(HeadingFeedback, APlanPlacedAnewOrAGapIsNoSlip) {
  HeadingFeedback feedback{kDefaults};
  feedback.update(0.0, 0.0, true);
  feedback.update(0.0, 1.5, true);
  EXPECT_EQ(feedback.error_rad(), 0.0);
  feedback.pause();
  feedback.update(0.15, 1.5, true);
  EXPECT_EQ(feedback.error_rad(), 0.0);
}

}  // namespace
}  // namespace gaitway::stability
