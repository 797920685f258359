// The step out of a bow: the joints must be quick enough for what the walking pattern plans.
#include <gtest/gtest.h>

#include <memory>
#include <tuple>
#include <vector>

#include "gaitway/core/joint_plan_check.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/kinematics/batch_solver.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::kinematics {
namespace {

using facts::kCycle_ns;

// A standing robot that bows, and is stepped with when its DCM leaves the soles, as the plug-ins do it.
// The bow, rad, and by how much the body falls to its left, m.
class RecoveryStep : public ::testing::TestWithParam<std::tuple<double, double>> {
 protected:
  // The next batch, with the bow that is reached at its end and the body's DCM off the plan by so much.
  void plan_batch(double bow_rad, const Eigen::Vector2d& deviation_m) {
    ++sequence;
    Correction correction{};
    correction.bow[1] = bow_rad;
    pattern.plan(sequence, sequence * kCycle_ns, {}, correction, *plan, deviation_m);
    BaseOffset offset;
    offset.bow[1].angle_rad = bow_rad;
    const BatchOutcome outcome = solver.solve(*plan, offset, *joint_plan);
    ASSERT_TRUE(outcome.solved()) << solver.describe(outcome);
    std::vector<char> text(200);
    const core::JointPlanVerdict verdict = check.check(*joint_plan, last_rad);
    EXPECT_TRUE(verdict.accepted()) << check.describe(verdict, text);
    const float* last = joint_plan->position[kBatchPoints - 1];
    last_rad.assign(last, last + robot.joints.size());
  }
  void bow_to(double bow_rad) {
    constexpr int kBatches = 4;
    for (int i = 1; i <= kBatches; ++i) plan_batch(bow_rad * i / kBatches, Eigen::Vector2d::Zero());
    for (int i = 0; i < 3; ++i) plan_batch(bow_rad, Eigen::Vector2d::Zero());
    ASSERT_EQ(plan->footstep_count, 0U);
  }

  urdf::RobotModel robot = urdf::load_robot(GAITWAY_HUMANOID22_DIRECTORY);
  trajectory::GaitParameters parameters = trajectory::gait_of(robot);
  trajectory::WalkingPattern pattern{parameters};
  BatchSolver solver{robot, SolverChoice::closed_form, true};
  core::JointPlanCheck check{robot};
  std::unique_ptr<MotionPlan> plan = std::make_unique<MotionPlan>();
  std::unique_ptr<JointPlan> joint_plan = std::make_unique<JointPlan>();
  std::vector<double> last_rad;
  std::uint32_t sequence = 0;
};

TEST_P(RecoveryStep, OutOfABowIsOneThatTheJointsAllow) {
  const auto [bow_rad, aside_m] = GetParam();
  bow_to(bow_rad);
  // It goes on falling ahead in the step, and is caught by it.
  plan_batch(bow_rad, {0.10, aside_m});
  ASSERT_GT(plan->footstep_count, 0U);
  plan_batch(bow_rad, {0.06, aside_m});
  for (int i = 0; i < 30; ++i) plan_batch(bow_rad, Eigen::Vector2d::Zero());
  EXPECT_EQ(plan->footstep_count, 0U);
}

// By how far the hips are behind the CoM, seen from the sole.
TEST_P(RecoveryStep, FindsTheHipsWhereTheParameterHasThem) {
  const auto hips_behind_m = [this] {
    urdf::ForwardKinematics now(robot);
    const float* last = joint_plan->position[kBatchPoints - 1];
    now.compute(std::vector<double>(last, last + robot.joints.size()));
    const Eigen::Isometry3d sole_from_base = now.sole_pose(urdf::Side::left).inverse();
    return (sole_from_base * now.com_m() - sole_from_base * hip_centre(robot, urdf::Side::left)).x();
  };
  const double bow_rad = std::get<0>(GetParam());
  bow_to(0.0);
  const double upright_m = hips_behind_m();
  bow_to(bow_rad);
  EXPECT_NEAR(hips_behind_m() - upright_m, parameters.hips_in_bow_m_per_rad * bow_rad, 0.005);
}

INSTANTIATE_TEST_SUITE_P(BowsAndSides, RecoveryStep,
                         ::testing::Combine(::testing::Values(0.0, 0.2, 0.4, 0.6),
                                            ::testing::Values(0.0, 0.02, -0.02)));

}  // namespace
}  // namespace gaitway::kinematics
