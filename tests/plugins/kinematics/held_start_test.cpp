// A plan that begins elsewhere than the joints are held goes on from there, within their speed.
#include "gaitway/kinematics/held_start.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "test_robot.hpp"

namespace gaitway::kinematics {
namespace {

class HeldStartTest : public ::testing::Test {
 protected:
  // A plan in which every joint stays at this angle.
  JointPlan& still(double angle_rad) {
    plan_->joint_count = static_cast<std::uint32_t>(robot_.joints.size());
    plan_->tail_count = kHeldTail;
    for (auto& row : plan_->position)
      std::fill(std::begin(row), std::end(row), static_cast<float>(angle_rad));
    return *plan_;
  }
  // Of the plan's first points, going on from `before_rad`, the fastest; returns where it ends.
  double go_through(double before_rad, std::size_t joint, std::size_t points) {
    for (std::size_t point = 0; point < points; ++point) {
      const double angle_rad = static_cast<double>(plan_->position[point][joint]);
      fastest_rad_per_s_ = std::max(fastest_rad_per_s_, std::abs(angle_rad - before_rad) / facts::kSlot_s);
      before_rad = angle_rad;
    }
    return before_rad;
  }

  static constexpr std::uint32_t kHeldTail = 60;
  static urdf::RobotModel with_speeds() {
    urdf::RobotModel robot = test::make_robot();
    for (urdf::Joint& joint : robot.joints) joint.velocity_limit_rad_per_s = 8.0;
    return robot;
  }
  const urdf::RobotModel robot_ = with_speeds();
  HeldStart start_{robot_};
  HeldStart::Detour detour_;
  std::unique_ptr<JointPlan> plan_ = std::make_unique<JointPlan>();
  std::vector<double> held_rad_ = std::vector<double>(robot_.joints.size(), 0.0);
  double fastest_rad_per_s_ = 0.0;
};

TEST_F(HeldStartTest, APlanThatBeginsWhereTheJointsAreIsLeftAsItIs) {
  EXPECT_FALSE(start_.apply(held_rad_, still(0.01), detour_));
  EXPECT_FLOAT_EQ(plan_->position[0][3], 0.01F);
}

TEST_F(HeldStartTest, LeadsThereOverSeveralBatchesAndInTheTailOfEach) {
  held_rad_[3] = 0.15;
  ASSERT_TRUE(start_.apply(held_rad_, still(0.0), detour_));
  EXPECT_EQ(detour_.joint, 3U);
  EXPECT_NEAR(detour_.way_rad, 0.15, 1e-6);
  EXPECT_NEAR(go_through(0.15, 3, kBatchPoints + kHeldTail), 0.0, 1e-6) << "its tail comes to rest there";
  double reached_rad = 0.15;
  for (int batch = 0; batch < 8; ++batch) {
    if (batch > 0) {
      EXPECT_FALSE(start_.apply({}, still(0.0), detour_)) << "told once";
    }
    reached_rad = go_through(reached_rad, 3, kBatchPoints);
  }
  EXPECT_NEAR(reached_rad, 0.0, 1e-6);
  EXPECT_LT(fastest_rad_per_s_, 0.51 * robot_.body_scale().factor("rad/s"));
  EXPECT_FLOAT_EQ(plan_->position[0][4], 0.0F) << "of a joint that is where it belongs";
}

TEST_F(HeldStartTest, ABatchThatWasRefusedIsBegunAgain) {
  held_rad_[3] = 0.15;
  ASSERT_TRUE(start_.apply(held_rad_, still(0.0), detour_));
  const float second = [&] {
    static_cast<void>(start_.apply({}, still(0.0), detour_));
    return plan_->position[0][3];
  }();
  start_.take_back();
  static_cast<void>(start_.apply({}, still(0.0), detour_));
  EXPECT_EQ(plan_->position[0][3], second);
}

}  // namespace
}  // namespace gaitway::kinematics
