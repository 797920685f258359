// Speed feedback against a robot that walks faster than its plan.
#include "gaitway/facts/facts.hpp"
#include "gaitway/stability/batch_feedback.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>

#include "test_robot.hpp"

namespace gaitway::stability {
namespace {

using facts::kSlot_s;
using test::kDefaults;

// The plan follows command and offset 0.6 s late; the robot goes by a share faster, and swings with its
// steps.
Eigen::Vector2d speed_after(double seconds, const Eigen::Vector2d& commanded, double faster,
                            double filter_s) {
  BalanceParameters parameters;
  parameters.speed_filter_s = filter_s;
  SpeedFeedback feedback(parameters);
  std::deque<Eigen::Vector2d> delayed(60, Eigen::Vector2d::Zero());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  const int ticks = static_cast<int>(seconds / kSlot_s);
  for (int i = 0; i < ticks; ++i) {
    const Eigen::Vector2d planned = commanded + delayed.front();
    delayed.pop_front();
    const Eigen::Vector2d robot = (1.0 + faster) * planned;
    const double swing = 0.15 * std::sin(2.0 * M_PI * 1.5625 * i * kSlot_s);
    delayed.push_back(feedback.update(planned, robot + Eigen::Vector2d(0.0, swing), true));
    if (i >= ticks / 2) mean += robot / (ticks - ticks / 2);
  }
  return mean;
}

TEST(SpeedFeedback, AFastRobotComesToTheCommandedSpeed) {
  EXPECT_NEAR(speed_after(40.0, {0.2, 0.0}, 0.10, 2.0).x(), 0.2, 0.003);
  EXPECT_NEAR(speed_after(40.0, {0.0, 0.05}, -0.20, 2.0).y(), 0.05, 0.003);
  EXPECT_NEAR(speed_after(40.0, {0.2, 0.0}, 0.10, 0.0).x(), 0.22, 1e-9);  // without feedback
}

TEST(SpeedFeedback, KeepsItsLimitAndFadesWhenTheRobotStands) {
  SpeedFeedback feedback{kDefaults};
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();
  for (int i = 0; i < 3000; ++i) offset = feedback.update({1.0, -1.0}, {0.0, 0.0}, true);
  EXPECT_DOUBLE_EQ(offset.x(), BalanceParameters{}.speed_limit_m_per_s);
  EXPECT_DOUBLE_EQ(offset.y(), -BalanceParameters{}.speed_limit_m_per_s);
  for (int i = 0; i < 1000; ++i) offset = feedback.update({0.0, 0.0}, {0.0, 0.0}, false);
  EXPECT_NEAR(offset.norm(), 0.0, 0.001);
}

}  // namespace
}  // namespace gaitway::stability
