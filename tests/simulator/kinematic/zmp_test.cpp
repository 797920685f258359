// ZMPs that are known: of a cart that accelerates, of a bob that swings, of the planner's own motions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/body_load.hpp"
#include "gaitway/motion/motion_planner.hpp"
#include "hand_made_robot.hpp"

namespace gaitway::kinematic {
namespace {

constexpr double kGravity = facts::kGravity_m_per_s2;

// Slides along a parabola: an acceleration that is known, and no sole is asked.
Trajectory accelerating(const urdf::RobotModel& robot, const Eigen::Vector2d& acceleration_m_per_s2) {
  Trajectory trajectory = test::standing_on_base(robot, 101);
  for (std::size_t row = 0; row < trajectory.rows(); ++row) {
    const double t = trajectory.time_s(row) - 0.5;
    trajectory.base[row].translation().head<2>() = 0.5 * t * t * acceleration_m_per_s2;
  }
  return trajectory;
}

TEST(Zmp, OfACartThatAcceleratesLiesBehindItsCoM) {
  const urdf::RobotModel robot = test::standing_base();
  urdf::RobotModel cart = robot;
  test::add_pendulum(cart, {0.0, 0.0, 0.5}, 1.0, 0.1, 0.0);
  const Eigen::Vector2d acceleration(0.9, -0.4);
  Checks checks;
  checks.soles = false;
  const Course course = play(cart, accelerating(cart, acceleration), checks);
  EXPECT_TRUE(course.planned_is_computed);
  for (std::size_t row = 1; row < 100; ++row) {
    const Eigen::Vector3d com = course.com_m[row];
    EXPECT_NEAR(com.z(), 0.4, 1e-12);
    const Eigen::Vector2d expected = com.head<2>() - com.z() / kGravity * acceleration;
    EXPECT_LT((course.of(ZmpSource::planned).at_m[row] - expected).norm(), 1e-9) << row;
    EXPECT_LT((course.of(ZmpSource::all_masses).at_m[row] - expected).norm(), 1e-9) << row;
    // The support is 0.2 m long and 0.3 m wide around the base.
    const Eigen::Vector2d inside =
        (expected - Eigen::Vector2d(0.5 * std::pow(0.01 * static_cast<double>(row) - 0.5, 2) * acceleration));
    const double margin = std::min(0.1 - std::abs(inside.x()), 0.15 - std::abs(inside.y()));
    EXPECT_NEAR(course.of(ZmpSource::all_masses).margin_m[row], margin, 1e-9);
  }
}

TEST(Zmp, OutsideIsFoundWithItsInstantAndWorstMargin) {
  urdf::RobotModel robot = test::standing_base();
  test::add_pendulum(robot, {0.0, 0.0, 0.5}, 1.0, 0.1, 0.0);
  Trajectory trajectory = test::standing_on_base(robot, 100);
  trajectory.zmp[index_of(ZmpSource::planned)].assign(100, {0.0, 0.0});
  trajectory.zmp[index_of(ZmpSource::planned)][40] = {0.103, 0.0};
  trajectory.zmp[index_of(ZmpSource::planned)][41] = {0.110, 0.0};
  trajectory.zmp[index_of(ZmpSource::planned)][42] = {0.099, 0.0};
  const Course course = play(robot, trajectory, {});
  ASSERT_EQ(course.findings.size(), 1U);
  const Finding& finding = course.findings[0];
  EXPECT_EQ(finding.rule, Rule::zmp);
  EXPECT_EQ(finding.what, "ZMP (planned)");
  EXPECT_DOUBLE_EQ(finding.from_s, 0.40);
  EXPECT_DOUBLE_EQ(finding.at_s, 0.41);
  EXPECT_DOUBLE_EQ(finding.to_s, 0.41);
  EXPECT_NEAR(finding.value, -10.0, 1e-9);
  EXPECT_DOUBLE_EQ(course.of(ZmpSource::planned).least_at_s, 0.41);
  EXPECT_FALSE(course.of(ZmpSource::cells).known());
  EXPECT_FALSE(course.of(ZmpSource::solver).known());
}

// The cart-table takes all masses for one; a bob that turns has an angular momentum that only all masses
// have.
TEST(Zmp, OfABobThatSwingsHasItsAngularMomentum) {
  urdf::RobotModel robot = test::standing_base();
  test::add_pendulum(robot, {0.0, 0.0, 0.5}, 1.0, 0.0, 0.05);  // turns about its own CoM
  Trajectory trajectory = test::standing_on_base(robot, 200);
  for (std::size_t row = 0; row < 200; ++row)
    test::angle(trajectory, row, 0) = 0.5 * std::sin(6.0 * trajectory.time_s(row));
  const Course course = play(robot, trajectory, {});
  const double weight_N = 3.0 * kGravity;
  for (std::size_t row = 2; row < 198; ++row) {
    const double acceleration = -0.5 * 36.0 * std::sin(6.0 * trajectory.time_s(row));
    const double com_x = course.com_m[row].x();
    EXPECT_NEAR(course.of(ZmpSource::planned).at_m[row].x(), com_x, 1e-9);
    EXPECT_NEAR(course.of(ZmpSource::all_masses).at_m[row].x(), com_x - 0.05 * acceleration / weight_N, 1e-4);
  }
}

TEST(Zmp, OfAPlannedMotionIsThePlannersToTheLastDigits) {
  const urdf::RobotModel& robot = test::humanoid22();
  const auto file = std::filesystem::path(GAITWAY_ROBOT) / "motions" / "kick.yaml";
  const motion::MotionPlan plan = motion::plan_motion(robot, motion::read_motion(file, robot), {}).plan;
  Trajectory trajectory{.name = "kick", .kind = "test", .joint_count = plan.joint_count};
  trajectory.joint_rad = plan.joint_rad;
  trajectory.reference_rad = plan.reference_rad;
  trajectory.contact = plan.contact;
  trajectory.base = plan.pelvis;
  trajectory.points_of_wire = true;
  const Course course = play(robot, trajectory, {});
  EXPECT_TRUE(course.findings.empty()) << describe(course.findings.at(0));
  motion::PlanLoads loads(robot, plan);
  for (std::size_t row = 1; row + 1 < plan.point_count(); ++row) {
    const motion::BodyLoad& load = loads.at(row);
    EXPECT_LT((course.of(ZmpSource::all_masses).at_m[row] - load.zmp_m).norm(), 1e-9) << row;
    for (std::size_t j = 0; j < plan.joint_count; ++j)
      EXPECT_NEAR(course.torque_Nm[row * plan.joint_count + j], load.torque_Nm[static_cast<Eigen::Index>(j)],
                  1e-6);
  }

  // Without its base, what stands carries it: the same places, and nearly the same ground.
  trajectory.base.clear();
  const Course carried = play(robot, trajectory, {});
  for (std::size_t row = 0; row < plan.point_count(); ++row) {
    EXPECT_LT((carried.base[row].translation() - plan.pelvis[row].translation()).norm(), 1e-3) << row;
    EXPECT_LT(
        (carried.of(ZmpSource::all_masses).at_m[row] - course.of(ZmpSource::all_masses).at_m[row]).norm(),
        2e-3)
        << row;
  }
}

}  // namespace
}  // namespace gaitway::kinematic
