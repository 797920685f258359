// Two robots that do the same, one of them later, or not quite.
#include "tools/twin/comparison.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "gaitway/facts/facts.hpp"

#include "twin_robot.hpp"

namespace gaitway::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// Swings of a walk: each joint with a phase of its own, two frequencies, so that no shift but one fits.
double swing(std::size_t joint, double time_s) {
  const double phase = 0.7 * static_cast<double>(joint);
  return 0.2 * std::sin(2.0 * std::numbers::pi * 1.3 * time_s + phase) +
         0.05 * std::sin(2.0 * std::numbers::pi * 0.31 * time_s + 2.0 * phase);
}

class ComparisonTest : public testing::Test {
 protected:
  static constexpr double kPeriod_s = 0.02;
  static constexpr double kClockOfReal_s = 1000.0;

  // Both robots' messages of the next time, and looks at them.
  void run(double seconds) {
    for (const double end_s = now_s_ + seconds; now_s_ < end_s; now_s_ += kPeriod_s) {
      joints(Comparison::Robot::real, kClockOfReal_s, 0.0, transport_s_);
      if (simulated_comes_) joints(Comparison::Robot::simulated, simulated_clock_s_, lag_s_, 0.001);
      comparison_.look(now_s_);
      if (std::string news = comparison_.take_news(); !news.empty()) news_.push_back(std::move(news));
    }
  }
  void joints(Comparison::Robot robot, double clock_s, double behind_s, double transport_s) {
    MeasuredPoint point{Measurement::joints, now_s_ + clock_s, {}};
    for (std::size_t i = 0; i < twin_robot().joints.size(); ++i) {
      const double instant_s = now_s_ - behind_s;
      const double moves =
          stands_ ? 0.0
          : stride_s_ > 0
              ? 0.2 * std::sin(2.0 * std::numbers::pi * instant_s / stride_s_ + static_cast<double>(i))
              : swing(i, instant_s);
      const bool is_off = robot == Comparison::Robot::real && i == off_joint_;
      point.values.push_back(moves + (is_off ? off_rad_ : 0.0));
    }
    // Messages are under way for a while, some longer.
    const double jitter_s = (static_cast<int>(now_s_ / kPeriod_s) % 7 == 0) ? 0.015 : 0.0;
    comparison_.take(robot, {point, now_s_ + transport_s + jitter_s});
  }
  [[nodiscard]] double difference(std::size_t channel) const {
    return comparison_.values()[channel].difference;
  }

  Comparison comparison_{twin_robot()};
  double now_s_ = 50.0, lag_s_ = 0.0, transport_s_ = 0.0;
  double simulated_clock_s_ = 3.0;
  double stride_s_ = 0.0;  // 0: no motion repeats itself
  bool stands_ = false, simulated_comes_ = true;
  std::size_t off_joint_ = 3;
  double off_rad_ = 0.0;
  std::vector<std::string> news_;
};

TEST_F(ComparisonTest, TheLagIsFoundAndTakenOut) {
  for (const double lag_s : {0.0, 0.04, 0.17, 0.43, -0.25}) {
    comparison_ = Comparison(twin_robot());
    lag_s_ = lag_s;
    run(6.0);
    ASSERT_TRUE(comparison_.lag_s());
    EXPECT_NEAR(*comparison_.lag_s(), lag_s, 0.0101);
    for (std::size_t i = 0; i < twin_robot().joints.size(); ++i) EXPECT_LT(difference(i), 0.02) << i;
  }
  EXPECT_THAT(news_, testing::IsEmpty());
}

// Half a second later or earlier a walk looks the same.
TEST_F(ComparisonTest, OfLagsThatFitAsWellTheLeastIsMeant) {
  stride_s_ = 0.5;
  lag_s_ = 0.4;
  run(6.0);
  EXPECT_NEAR(comparison_.lag_s().value_or(9.0), -0.1, 0.0101);
}

// A way there of 0.2 s looks like a simulated robot that is early, and costs nothing else.
TEST_F(ComparisonTest, TheWayOfTheMessagesIsPartOfTheLag) {
  transport_s_ = 0.2;
  run(6.0);
  EXPECT_NEAR(comparison_.lag_s().value_or(9.0), -0.2, 0.0101);
  EXPECT_LT(difference(5), 0.02);
}

TEST_F(ComparisonTest, AJointThatIsOffIsToldOnceAndAgainAfterItWasWell) {
  run(6.0);
  off_rad_ = 6.0 * facts::kRadPerDegree;
  run(2.0);
  EXPECT_THAT(news_, testing::IsEmpty()) << "it may be a lag that has changed";
  run(6.0);
  ASSERT_EQ(news_.size(), 1U);
  EXPECT_THAT(news_[0], AllOf(HasSubstr(twin_robot().joints[3].name + " by 6.0 deg (more than 3.0 deg)"),
                              Not(HasSubstr("others"))));
  EXPECT_NEAR(difference(3), off_rad_, 0.01);
  off_rad_ = 0.0;
  run(5.0);
  off_rad_ = 6.0 * facts::kRadPerDegree;
  run(7.0);
  EXPECT_EQ(news_.size(), 2U);
}

TEST_F(ComparisonTest, AStandHasNoLagAndStillADifference) {
  stands_ = true;
  off_rad_ = 4.0 * facts::kRadPerDegree;
  run(6.0);
  EXPECT_FALSE(comparison_.lag_s());
  EXPECT_NEAR(difference(3), off_rad_, 1e-6);
  EXPECT_EQ(news_.size(), 1U);
}

TEST_F(ComparisonTest, WhatComesNoMoreIsNotKnown) {
  run(6.0);
  EXPECT_TRUE(std::isfinite(difference(3)));
  simulated_comes_ = false;
  run(1.0);
  EXPECT_FALSE(std::isfinite(difference(3)));
  EXPECT_FALSE(comparison_.lag_s());
  simulated_comes_ = true;
  run(6.0);
  EXPECT_TRUE(std::isfinite(difference(3)));
}

TEST_F(ComparisonTest, AClockThatIsSetAnewBeginsAnew) {
  run(6.0);
  MeasuredPoint early{Measurement::joints, 1.0, std::vector<double>(twin_robot().joints.size(), 1.0)};
  comparison_.take(Comparison::Robot::real, {early, now_s_});
  comparison_.look(now_s_ + 0.3);
  EXPECT_FALSE(std::isfinite(difference(3))) << "nothing of its former life";
  run(6.0);
  EXPECT_LT(difference(3), 0.02);
}

// A computer that is too slow lets the simulated robot's time fall behind now and then.
TEST_F(ComparisonTest, ASimulationThatFallsBehindIsStillCompared) {
  for (int fall = 0; fall < 8; ++fall) {
    run(5.0);
    simulated_clock_s_ -= 0.2;
  }
  run(7.0);
  EXPECT_LT(difference(3), 0.02);
  EXPECT_THAT(news_, testing::IsEmpty());
}

TEST_F(ComparisonTest, APlaceHoldsUntilTheNext) {
  const std::size_t channel = comparison_.channels().size() - 3;
  ASSERT_EQ(comparison_.channels()[channel].name, "place x");
  // Latched: it comes with the stamp of long ago.
  comparison_.take(Comparison::Robot::real, {{Measurement::place, 0.07, {1.0, 2.0, 3.1}}, now_s_});
  comparison_.take(Comparison::Robot::simulated, {{Measurement::place, 0.07, {1.1, 2.0, -3.1}}, now_s_});
  run(6.0);
  EXPECT_NEAR(difference(channel), 0.1, 1e-9);
  EXPECT_NEAR(difference(channel + 1), 0.0, 1e-9);
  EXPECT_NEAR(difference(channel + 2), 2.0 * std::numbers::pi - 6.2, 1e-9) << "the shorter way round";
  EXPECT_LT(difference(3), 0.02) << "the old stamp has nothing to do with the joints";
}

TEST_F(ComparisonTest, WhatARobotDoesNotKnowIsNotCompared) {
  off_rad_ = std::nan("");
  run(6.0);
  EXPECT_FALSE(std::isfinite(difference(3)));
  EXPECT_LT(difference(4), 0.02);
  EXPECT_NEAR(comparison_.lag_s().value_or(9.0), 0.0, 0.0101);
}

}  // namespace
}  // namespace gaitway::tools
