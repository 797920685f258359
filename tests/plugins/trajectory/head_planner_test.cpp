// The head goes where it is told, within the neck's limits, without passing its goal and without a jerk.
#include "gaitway/trajectory/head_planner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "gaitway/facts/facts.hpp"

namespace gaitway::trajectory {
namespace {

constexpr double kLowestPitch_rad = -0.6, kHighestPitch_rad = 0.8, kHighestYaw_rad = 1.4;  // of humanoid22

class HeadPlannerTest : public testing::Test {
 protected:
  HeadPlannerTest() {
    plan_->tail_count = 100;
    std::ranges::fill(plan_->hip_height, 0.36);
  }
  void look(HeadCommand command) {
    command.stamp_ns = ++stamp_;
    head_.obey(command);
  }
  static HeadCommand direction(double yaw_rad, double pitch_rad) {
    HeadCommand command{};
    command.mode = head_command::mode::direction;
    command.direction[0] = yaw_rad;
    command.direction[1] = pitch_rad;
    return command;
  }
  // Goes on by so many batches; keeps all points.
  void batches(int count, bool allowed = true) {
    for (int i = 0; i < count; ++i) {
      head_.plan(allowed, estimate_known_ ? &estimate_ : nullptr, *plan_);
      for (int point = 0; point < kBatchPoints; ++point) {
        yaw_.push_back(plan_->head[point][0]);
        pitch_.push_back(plan_->head[point][1]);
      }
    }
  }
  [[nodiscard]] static double most_change(const std::vector<double>& angle_rad) {
    double most = 0.0;
    for (std::size_t i = 1; i < angle_rad.size(); ++i)
      most = std::max(most, std::abs(angle_rad[i] - angle_rad[i - 1]));
    return most / facts::kSlot_s;
  }
  [[nodiscard]] static double most_acceleration(const std::vector<double>& angle_rad) {
    double most = 0.0;
    for (std::size_t i = 2; i < angle_rad.size(); ++i) {
      most = std::max(most, std::abs(angle_rad[i] - 2.0 * angle_rad[i - 1] + angle_rad[i - 2]));
    }
    return most / (facts::kSlot_s * facts::kSlot_s);
  }

  const urdf::RobotModel robot_ = urdf::load_robot(GAITWAY_URDF_DIR "/humanoid22");
  HeadPlanner head_{robot_};
  std::unique_ptr<MotionPlan> plan_ = std::make_unique<MotionPlan>();
  Estimate estimate_{};
  bool estimate_known_ = false;
  std::int64_t stamp_ = 0;
  std::vector<double> yaw_{0.0}, pitch_{0.0};
};

TEST_F(HeadPlannerTest, LooksAheadUntilItIsToldSomethingElse) {
  batches(10);
  EXPECT_EQ(*std::ranges::max_element(yaw_), 0.0);
  EXPECT_EQ(plan_->head[kBatchPoints + 99][1], 0.0);
}

TEST_F(HeadPlannerTest, GoesToADirectionAndDoesNotPassIt) {
  look(direction(0.8, 0.3));
  batches(15);
  EXPECT_NEAR(yaw_.back(), 0.8, 1e-9);
  EXPECT_NEAR(pitch_.back(), 0.3, 1e-9);
  EXPECT_LE(*std::ranges::max_element(yaw_), 0.8 + 1e-9);
  EXPECT_TRUE(std::ranges::is_sorted(yaw_));
  EXPECT_LE(most_change(yaw_), 2.0 + 1e-9);
  EXPECT_LE(most_acceleration(yaw_), 12.0 + 1e-6);
}

TEST_F(HeadPlannerTest, StaysWithinTheNecksLimits) {
  look(direction(3.0, 3.0));
  batches(30);
  EXPECT_LT(yaw_.back(), kHighestYaw_rad);
  EXPECT_GT(yaw_.back(), kHighestYaw_rad - 0.05);
  EXPECT_LT(pitch_.back(), kHighestPitch_rad);
  look(direction(-3.0, -3.0));
  batches(40);
  EXPECT_GT(pitch_.back(), kLowestPitch_rad);
}

TEST_F(HeadPlannerTest, KeepsToASpeedThatIsAskedFor) {
  HeadCommand slow = direction(0.8, 0.0);
  slow.speed = 0.4;
  look(slow);
  batches(40);
  EXPECT_LE(most_change(yaw_), 0.4 + 1e-9);
  EXPECT_NEAR(yaw_.back(), 0.8, 1e-9);
}

TEST_F(HeadPlannerTest, ScansFromSideToSide) {
  HeadCommand scan = direction(0.2, 0.1);
  scan.mode = head_command::mode::scan;
  scan.extent = 0.6;
  scan.period = 4.0;
  look(scan);
  batches(150);
  EXPECT_NEAR(*std::ranges::max_element(yaw_), 0.8, 0.03);
  EXPECT_NEAR(*std::ranges::min_element(yaw_), -0.4, 0.03);
  EXPECT_NEAR(pitch_.back(), 0.1, 1e-6);
  HeadCommand hold{};
  hold.mode = head_command::mode::hold;
  const double here = yaw_.back();
  look(hold);
  batches(20);
  EXPECT_NEAR(yaw_.back(), here, 0.1);
  EXPECT_EQ(yaw_.back(), yaw_[yaw_.size() - 10]);
}

// Where the point is seen from the neck: by the same geometry, worked out by hand.
TEST_F(HeadPlannerTest, LooksAtAPlaceInOdometry) {
  estimate_known_ = true;
  estimate_.odometry_base[0] = 1.0;
  estimate_.odometry_base[1] = 2.0;
  estimate_.odometry_base[2] = 0.5;
  HeadCommand at{};
  at.mode = head_command::mode::point;
  at.point[0] = 1.0 + 2.0 * std::cos(0.5 + 0.7);
  at.point[1] = 2.0 + 2.0 * std::sin(0.5 + 0.7);
  at.point[2] = 0.0;
  look(at);
  batches(20);
  EXPECT_NEAR(yaw_.back(), 0.7, 0.02);
  EXPECT_GT(pitch_.back(), std::atan2(0.5, 2.0)) << "a neck is some 0.6 m above the ground";
  EXPECT_LT(pitch_.back(), std::atan2(0.75, 2.0));
}

TEST_F(HeadPlannerTest, ComesToRestInTheTailFromAnySpeed) {
  look(direction(1.2, 0.5));
  batches(3);  // in full swing
  double last = yaw_.back(), speed = 0.0;
  for (int point = kBatchPoints; point < kBatchPoints + 100; ++point) {
    speed = (plan_->head[point][0] - last) / facts::kSlot_s;
    last = plan_->head[point][0];
  }
  EXPECT_EQ(speed, 0.0);
  EXPECT_LT(last, 1.2) << "it does not go on to its goal without a plan";
}

TEST_F(HeadPlannerTest, GoesBackAheadForAMotion) {
  look(direction(0.8, 0.0));
  batches(15);
  batches(15, false);
  EXPECT_NEAR(yaw_.back(), 0.0, 1e-9);
  batches(15);
  EXPECT_NEAR(yaw_.back(), 0.8, 1e-9) << "and afterwards where it was told to look";
}

TEST_F(HeadPlannerTest, AfterASafeTailItGoesOnFromWhereThatEnds) {
  look(direction(1.2, 0.0));
  batches(3);  // in full swing
  const double rest = plan_->head[kBatchPoints + plan_->tail_count - 1][0];
  head_.begin_after_tail();
  batches(1);
  EXPECT_GT(rest, yaw_[8 * 3]);
  EXPECT_NEAR(plan_->head[0][0], rest, 0.01);
}

TEST_F(HeadPlannerTest, WhateverIsAskedTheWayHasNoJerkAndKeepsItsLimits) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  for (int i = 0; i < 500; ++i) {
    HeadCommand command = direction(any(random), any(random));
    command.mode = static_cast<std::uint32_t>(random() % 5);
    command.extent = std::abs(any(random));
    command.period = 1.0 + std::abs(any(random));
    look(command);
    batches(1 + static_cast<int>(random() % 12), random() % 8 != 0);
  }
  EXPECT_LE(most_change(yaw_), 2.0 + 1e-9);
  EXPECT_LE(most_acceleration(yaw_), 12.0 + 1e-6);
  EXPECT_LE(most_acceleration(pitch_), 12.0 + 1e-6);
  EXPECT_LT(*std::ranges::max_element(pitch_), kHighestPitch_rad);
  EXPECT_GT(*std::ranges::min_element(pitch_), kLowestPitch_rad);
}

}  // namespace
}  // namespace gaitway::trajectory
