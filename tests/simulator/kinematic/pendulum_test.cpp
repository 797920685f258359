// A pendulum's torque, and what its limits make of it.
#include <gtest/gtest.h>

#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "hand_made_robot.hpp"

namespace gaitway::kinematic {
namespace {

constexpr double kMass_kg = 1.5, kLength_m = 0.3, kInertia_kg_m2 = 0.02;
constexpr double kSwing_rad = 0.8, kRate_rad_per_s = 4.0;

struct Swing {
  double angle, speed, acceleration;
};
Swing swing_at(double time_s) {
  const double phase = kRate_rad_per_s * time_s;
  return {kSwing_rad * std::sin(phase), kSwing_rad * kRate_rad_per_s * std::cos(phase),
          -kSwing_rad * kRate_rad_per_s * kRate_rad_per_s * std::sin(phase)};
}

urdf::RobotModel pendulum() {
  urdf::RobotModel robot = test::standing_base();
  urdf::Joint& hinge = test::add_pendulum(robot, {0.0, 0.0, 0.7}, kMass_kg, kLength_m, kInertia_kg_m2);
  hinge.motor.armature_kg_m2 = 0.01;
  hinge.motor.damping_Nms_per_rad = 0.2;
  return robot;
}

Trajectory swinging(const urdf::RobotModel& robot) {
  Trajectory trajectory = test::standing_on_base(robot, 300);
  for (std::size_t row = 0; row < 300; ++row)
    test::angle(trajectory, row, 0) = swing_at(trajectory.time_s(row)).angle;
  return trajectory;
}

double torque_at(double time_s) {
  const Swing at = swing_at(time_s);
  return (kInertia_kg_m2 + kMass_kg * kLength_m * kLength_m + 0.01) * at.acceleration + 0.2 * at.speed +
         kMass_kg * facts::kGravity_m_per_s2 * kLength_m * std::sin(at.angle);
}

TEST(Pendulum, NeedsTheTorqueOfItsEquationOfMotion) {
  const urdf::RobotModel robot = pendulum();
  const Trajectory trajectory = swinging(robot);
  const Course course = play(robot, trajectory, {});
  for (std::size_t row = 0; row < trajectory.rows(); ++row) {
    const double time_s = trajectory.time_s(row);
    // At its ends the parabola of the three rows there is taken, whose bend is that of the row next to it.
    const bool end = row == 0 || row + 1 == trajectory.rows();
    EXPECT_NEAR(course.speed_rad_per_s[row], swing_at(time_s).speed, end ? 5e-3 : 2e-3) << time_s;
    EXPECT_NEAR(course.torque_Nm[row], torque_at(time_s), end ? 0.1 : 5e-3) << time_s;
  }
}

TEST(Pendulum, TellsWhenItsMotorIsTooWeakAndByHowMuch) {
  urdf::RobotModel robot = pendulum();
  const Trajectory trajectory = swinging(robot);
  Checks checks;
  checks.zmp = false;  // such a swing would tip it over
  const Course strong = play(robot, trajectory, checks);
  EXPECT_TRUE(strong.findings.empty());
  // The limit lies a little below the largest torque; it fades by speed in the driving direction alone.
  const double largest = strong.joints[0].largest_torque_Nm;
  robot.joints[0].motor.torque_limit_Nm = 0.98 * largest;
  robot.joints[0].motor.speed_limit_rad_per_s = 1e6;
  robot.joints[0].velocity_limit_rad_per_s = 1e6;
  const auto found = test::of_rule(play(robot, trajectory, checks).findings, Rule::torque);
  ASSERT_FALSE(found.empty());
  double worst = 0.0;
  for (const Finding& finding : found) {
    EXPECT_EQ(finding.what, "hinge0");
    EXPECT_NEAR(finding.value, std::abs(torque_at(finding.at_s)), 5e-3);
    EXPECT_NEAR(finding.limit, 0.98 * largest, 1e-3 * largest);
    worst = std::max(worst, finding.value);
  }
  EXPECT_DOUBLE_EQ(worst, largest);
}

TEST(Pendulum, HasNoTorqueWhereNothingStands) {
  const urdf::RobotModel robot = pendulum();
  Trajectory trajectory = swinging(robot);
  for (std::size_t row = 100; row < 120; ++row) trajectory.contact[row] = motion::Contact::none;
  const Course course = play(robot, trajectory, {});
  EXPECT_TRUE(std::isnan(course.torque_Nm[110]));
  EXPECT_TRUE(std::isnan(course.of(ZmpSource::all_masses).margin_m[110]));
  EXPECT_FALSE(std::isnan(course.torque_Nm[130]));
}

}  // namespace
}  // namespace gaitway::kinematic
