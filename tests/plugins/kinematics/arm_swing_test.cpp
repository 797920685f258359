// The arms of a joint plan: each against the leg of its side, as far as the motion plan asks, and still where
// it does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "gaitway/facts/facts.hpp"
#include "gaitway/kinematics/batch_solver.hpp"
#include "gaitway/urdf/arm_swing.hpp"
#include "walking_plan.hpp"

namespace gaitway::kinematics {
namespace {

class ArmsOfAJointPlan : public ::testing::Test {
 protected:
  // Of the side's arm, rad back from home.
  [[nodiscard]] double back_rad(int point, std::size_t side) const {
    const int joint = arms_.joint[side];
    const double home_rad = robot_.joints[static_cast<std::size_t>(joint)].home_rad;
    return arms_.sign[side] * (static_cast<double>(joint_plan_->position[point][joint]) - home_rad);
  }
  // By which the side's foot is ahead of the other, along the base.
  [[nodiscard]] static double foot_ahead_m(const MotionPlan& plan, int point, std::size_t side) {
    const double* const foot = plan.foot_position[point][side];
    const double* const other = plan.foot_position[point][1 - side];
    return std::cos(plan.base_yaw[point]) * (foot[0] - other[0]) +
           std::sin(plan.base_yaw[point]) * (foot[1] - other[1]);
  }
  // Batches of a walk on an arc that swings the arms so far.
  template <class Look>
  void walk(double arm_swing_rad_per_m, const Look& look) {
    BatchSolver solver(robot_, SolverChoice::automatic);
    const test::WalkingPlan walk(0.25, 0.3);
    for (std::uint32_t sequence = 1; sequence <= 40; ++sequence) {
      MotionPlan plan = walk.batch(sequence);
      plan.arm_swing = arm_swing_rad_per_m;
      const BatchOutcome outcome = solver.solve(plan, {}, *joint_plan_);
      ASSERT_TRUE(outcome.solved()) << solver.describe(outcome);
      look(plan, kBatchPoints + static_cast<int>(plan.tail_count));
    }
  }

  urdf::RobotModel robot_ = urdf::load_robot(GAITWAY_HUMANOID22_DIRECTORY);
  urdf::ArmSwing arms_ = *urdf::arm_swing(robot_, urdf::ForwardKinematics(robot_));
  std::unique_ptr<JointPlan> joint_plan_ = std::make_unique<JointPlan>();
};

TEST_F(ArmsOfAJointPlan, GoAgainstTheLegs) {
  constexpr double kSwing_rad_per_m = 2.0;
  double farthest_rad = 0.0;
  walk(kSwing_rad_per_m, [&](const MotionPlan& plan, int points) {
    for (int point = 0; point < points; ++point) {
      for (const std::size_t side : {0U, 1U}) {
        ASSERT_NEAR(back_rad(point, side), kSwing_rad_per_m * foot_ahead_m(plan, point, side), 1e-6);
        farthest_rad = std::max(farthest_rad, std::abs(back_rad(point, side)));
      }
    }
  });
  EXPECT_GT(farthest_rad, 0.1);
}

TEST_F(ArmsOfAJointPlan, HangStillWhereThePlanSwingsNone) {
  walk(0.0, [&](const MotionPlan&, int points) {
    for (int point = 0; point < points; ++point) {
      for (const std::size_t side : {0U, 1U}) ASSERT_NEAR(back_rad(point, side), 0.0, 1e-7);
    }
  });
}

TEST_F(ArmsOfAJointPlan, KeepToTheirLimitsWhateverIsAsked) {
  urdf::Joint& left = robot_.joints[static_cast<std::size_t>(arms_.joint[0])];
  left.lower_rad = left.home_rad - 0.3;
  walk(100.0, [&](const MotionPlan&, int points) {
    for (int point = 0; point < points; ++point) {
      for (const std::size_t side : {0U, 1U}) ASSERT_LT(std::abs(back_rad(point, side)), 0.3);
    }
  });
}

// A batch is not to be refused because a step is quicker than the shoulders are.
TEST_F(ArmsOfAJointPlan, KeepToTheirSpeedWhateverIsAsked) {
  constexpr double kSlow_rad_per_s = 0.6;
  for (const int joint : arms_.joint)
    robot_.joints[static_cast<std::size_t>(joint)].velocity_limit_rad_per_s = kSlow_rad_per_s;
  std::array<double, 2> before_rad{};
  double quickest = 0.0;
  walk(5.0, [&](const MotionPlan&, int points) {
    std::array<double, 2> last_rad = before_rad;
    for (int point = 0; point < points; ++point) {
      for (const std::size_t side : {0U, 1U}) {
        const double step_rad = std::abs(back_rad(point, side) - last_rad[side]);
        ASSERT_LE(step_rad, kSlow_rad_per_s * facts::kSlot_s) << "point " << point;
        quickest = std::max(quickest, step_rad);
        last_rad[side] = back_rad(point, side);
        if (point == kBatchPoints - 1) before_rad[side] = last_rad[side];
      }
    }
  });
  EXPECT_GT(quickest, 0.7 * kSlow_rad_per_s * facts::kSlot_s);
}

}  // namespace
}  // namespace gaitway::kinematics
