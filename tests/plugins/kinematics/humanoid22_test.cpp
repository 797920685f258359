// The robot that comes with the project: its legs have the closed form, and it walks through the batch
// solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "gaitway/kinematics/batch_solver.hpp"
#include "test_robot.hpp"
#include "walking_plan.hpp"

namespace gaitway::kinematics {
namespace {

using test::home_posture;
using test::sole_pose;

urdf::RobotModel humanoid22() {
  return urdf::load_robot(GAITWAY_HUMANOID22_DIRECTORY);
}

TEST(Humanoid22, HasLegsWithAClosedForm) {
  const urdf::RobotModel model = humanoid22();
  for (const urdf::Side side : urdf::kSides) {
    const LegRecognition recognition = recognise_leg(model, side);
    EXPECT_TRUE(recognition.geometry) << recognition.reason;
  }
}

TEST(Humanoid22, StandsAtItsHipHeight) {
  const urdf::RobotModel model = humanoid22();
  for (const urdf::Side side : urdf::kSides) {
    const Eigen::Isometry3d sole = sole_pose(model, side, home_posture(model));
    EXPECT_NEAR((hip_centre(model, side) - sole.translation()).z(), model.hip_height_m, 1e-3);
    EXPECT_NEAR(sole.linear()(2, 2), 1.0, 1e-6);
  }
}

TEST(Humanoid22, WalksWithBothSolversAlike) {
  const urdf::RobotModel model = humanoid22();
  BatchSolver closed_form(model, SolverChoice::closed_form);
  BatchSolver general(model, SolverChoice::kdl);
  const test::WalkingPlan walk(0.25, 0.2);
  const auto expected = std::make_unique<JointPlan>();
  const auto joint_plan = std::make_unique<JointPlan>();
  for (std::uint32_t sequence = 1; sequence <= 30; ++sequence) {
    const MotionPlan plan = walk.batch(sequence);
    const BatchOutcome outcome = closed_form.solve(plan, {}, *expected);
    ASSERT_TRUE(outcome.solved()) << closed_form.describe(outcome);
    ASSERT_TRUE(general.solve(plan, {}, *joint_plan).solved());
    for (int point = 0; point < kBatchPoints + static_cast<int>(plan.tail_count); ++point) {
      for (std::size_t i = 0; i < model.joints.size(); ++i) {
        ASSERT_NEAR(joint_plan->position[point][i], expected->position[point][i], 1e-5F)
            << model.joints[i].name;
        ASSERT_LE(expected->position[point][i], model.joints[i].upper_rad + 2e-6) << model.joints[i].name;
        ASSERT_GE(expected->position[point][i], model.joints[i].lower_rad - 2e-6) << model.joints[i].name;
      }
    }
  }
}

}  // namespace
}  // namespace gaitway::kinematics
