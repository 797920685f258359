// Counts: rounding never accumulates, and what a byte cannot hold is refused with joint and point.
#include "gaitway/msgcontroller/playback.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace gaitway::msgcontroller {
namespace {

constexpr double kCount_rad = 0.05 * 3.14159265358979 / 180.0;

class CountPlanTest : public ::testing::Test {
 protected:
  static constexpr int kJoints = 3;
  CountPlanTest() {
    hand_over_->sequence = 4;
    hand_over_->joint_count = kJoints;
    hand_over_->point_count = 28;
  }
  CountPlanProblem convert() { return to_counts(*hand_over_, count_rad_, start_, *plan_); }
  void set_all(double angle) {
    for (int point = 0; point < 28; ++point) {
      for (int joint = 0; joint < kJoints; ++joint) {
        hand_over_->set_position(point, joint, static_cast<float>(angle));
      }
    }
  }

  std::unique_ptr<msgclient::HandOver> hand_over_ = std::make_unique<msgclient::HandOver>();
  std::unique_ptr<CountPlan> plan_ = std::make_unique<CountPlan>();
  std::vector<double> count_rad_ = std::vector<double>(kJoints, kCount_rad);
  std::vector<std::int32_t> start_ = std::vector<std::int32_t>(kJoints, 0);
};

TEST_F(CountPlanTest, EveryPointIsWithinHalfACountOfItsAngle) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> step(-0.1, 0.1);
  double angle = 0.0;
  std::vector<double> wanted;
  for (int point = 0; point < 28; ++point) {
    angle += step(random);
    wanted.push_back(angle);
    for (int joint = 0; joint < kJoints; ++joint) {
      hand_over_->set_position(point, joint, static_cast<float>(angle));
    }
  }
  ASSERT_EQ(convert().reason, msgclient::Reason::none);
  for (std::size_t point = 0; point < wanted.size(); ++point) {
    EXPECT_LE(std::abs(plan_->count[point][1] * kCount_rad - wanted[point]), 0.5001 * kCount_rad) << point;
  }
  EXPECT_EQ(plan_->sequence, 4U);
  EXPECT_EQ(plan_->point_count, 28);
}

TEST_F(CountPlanTest, RefusesABatchThatDoesNotBeginWhereTheJointIs) {
  set_all(0.0);
  start_[2] = 128;
  const CountPlanProblem problem = convert();
  EXPECT_EQ(problem.reason, msgclient::Reason::jump);
  EXPECT_EQ(problem.joint, 2);
  EXPECT_EQ(problem.counts, -128.0);
  start_[2] = 127;
  EXPECT_EQ(convert().reason, msgclient::Reason::none);
}

TEST_F(CountPlanTest, RefusesAChangeThatAByteCannotHoldEvenInTheTail) {
  set_all(0.0);
  for (int point = 20; point < 28; ++point) {
    hand_over_->set_position(point, 1, static_cast<float>(128 * kCount_rad));
  }
  const CountPlanProblem problem = convert();
  EXPECT_EQ(problem.reason, msgclient::Reason::too_fast);
  EXPECT_EQ(problem.joint, 1);
  EXPECT_EQ(problem.point, 20);
}

TEST_F(CountPlanTest, RefusesWhatIsNoNumberAndWhatHasAnotherSize) {
  set_all(0.0);
  hand_over_->set_position(5, 0, std::nanf(""));
  EXPECT_EQ(convert().reason, msgclient::Reason::not_finite);
  set_all(0.0);
  count_rad_.push_back(kCount_rad);
  EXPECT_EQ(convert().reason, msgclient::Reason::wrong_size);
}

}  // namespace
}  // namespace gaitway::msgcontroller
