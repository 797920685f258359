// What the gait's choice takes the legs' joints to turn at is what the kinematics turns them at.
#include "gaitway/trajectory/joint_pace.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "gaitway/facts/facts.hpp"
#include "gaitway/kinematics/batch_solver.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"

namespace gaitway::kinematics {
namespace {

using trajectory::GaitParameters;
using urdf::LegJoint;

const urdf::RobotModel& walker() {
  static const urdf::RobotModel robot = urdf::load_robot(GAITWAY_HUMANOID22_DIRECTORY);
  return robot;
}

// Of both knees over the batches and tails of a walk.
double fastest_knee_rad_per_s(const GaitParameters& gait, double speed_m_per_s) {
  const urdf::RobotModel& robot = walker();
  trajectory::WalkingPattern pattern(gait);
  BatchSolver solver(robot, SolverChoice::closed_form);
  const auto plan = std::make_unique<MotionPlan>();
  const auto joint_plan = std::make_unique<JointPlan>();
  WalkCommand walk{};
  walk.walk = 1;
  walk.velocity[0] = speed_m_per_s;
  double fastest = 0.0;
  for (std::uint32_t batch = 1; batch <= 60; ++batch) {
    pattern.plan(batch, facts::kCycle_ns * std::int64_t{batch}, walk, Correction{}, *plan);
    const BatchOutcome outcome = solver.solve(*plan, BaseOffset{}, *joint_plan);
    if (!outcome.solved()) {
      ADD_FAILURE() << solver.describe(outcome);
      return 0.0;
    }
    for (const urdf::Side side : urdf::kSides) {
      const int knee = urdf::LegJoints(robot, urdf::ForwardKinematics(robot), side)[LegJoint::knee];
      for (std::size_t i = 1; i < kBatchPoints + plan->tail_count; ++i) {
        const double turned =
            static_cast<double>(joint_plan->position[i][knee] - joint_plan->position[i - 1][knee]);
        fastest = std::max(fastest, std::abs(turned) / facts::kSlot_s);
      }
    }
  }
  return fastest;
}

TEST(JointPace, IsThatOfTheKinematics) {
  const GaitParameters gait = trajectory::gait_of(walker());
  const double limit_rad_per_s = walker().joints[3].velocity_limit_rad_per_s;
  for (const double speed_m_per_s : {0.1, 0.2, 0.3, 0.4}) {
    const trajectory::JointPace pace = fastest_joint(gait, walker(), speed_m_per_s);
    EXPECT_EQ(pace.joint, LegJoint::knee);
    const double solved_rad_per_s = fastest_knee_rad_per_s(gait, speed_m_per_s);
    EXPECT_NEAR(pace.share * limit_rad_per_s, solved_rad_per_s, 0.05 * solved_rad_per_s)
        << speed_m_per_s << " m/s";
  }
}

}  // namespace
}  // namespace gaitway::kinematics
