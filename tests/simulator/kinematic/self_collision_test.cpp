// Two balls on arms meet when they must; neighbours and what overlaps at home are left alone.
#include "gaitway/kinematic/self_collision.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hand_made_robot.hpp"

namespace gaitway::kinematic {
namespace {

constexpr double kApart_m = 0.5, kArm_m = 0.3, kBall_m = 0.1;

urdf::Shape ball(double diameter_m, double down_m) {
  urdf::Shape shape;
  shape.kind = urdf::Shape::Kind::sphere;
  shape.size_m.setConstant(diameter_m);
  shape.pose.translation().z() = -down_m;
  return shape;
}

// Both hang, and swing towards each other by positive angles of the first, negative ones of the second.
urdf::RobotModel two_arms() {
  urdf::RobotModel robot = test::standing_base();
  robot.links[0].collision.push_back(ball(0.05, -0.1));
  for (const double x : {0.5 * kApart_m, -0.5 * kApart_m}) {
    test::add_pendulum(robot, {x, 0.0, 0.7}, 0.2, kArm_m, 0.001);
    robot.links.back().collision.push_back(ball(kBall_m, kArm_m));
  }
  return robot;
}

TEST(SelfCollision, OfTwoBallsBeginsWhenTheyAreADiameterApart) {
  const urdf::RobotModel robot = two_arms();
  Trajectory trajectory = test::standing_on_base(robot, 120);
  for (std::size_t row = 0; row < 120; ++row) {
    const double angle = 0.01 * static_cast<double>(row);
    test::angle(trajectory, row, 0) = angle;
    test::angle(trajectory, row, 1) = -angle;
  }
  Checks checks;
  checks.collision_depth_m = 1e-4;
  const Course course = play(robot, trajectory, checks);
  EXPECT_EQ(course.collision_pairs, 1U) << "the base is a neighbour of both";
  const auto found = test::of_rule(course.findings, Rule::self_collision);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].what, "bob1 in bob2");
  const auto depth = [](double angle) {
    return kBall_m - std::abs(kApart_m - 2.0 * kArm_m * std::sin(angle));
  };
  std::size_t first = 0;
  while (depth(0.01 * static_cast<double>(first)) <= 1e-4) ++first;
  EXPECT_NEAR(found[0].from_s, 0.01 * static_cast<double>(first), 0.011);
  EXPECT_LE(found[0].value, 1e3 * depth(found[0].at_s) + 0.01) << "mm";
  EXPECT_GE(found[0].value, 0.95 * 1e3 * depth(found[0].at_s)) << "mm";
  EXPECT_NEAR(depth(found[0].at_s), kBall_m, 0.05 * kBall_m)
      << "it is told where they pass through each other";
}

TEST(SelfCollision, LeavesAloneALimbsNextTwoLinksButNotTheThird) {
  urdf::RobotModel robot = test::standing_base();
  robot.links[0].collision.push_back(ball(0.02, -0.1));
  for (int i = 0; i < 3; ++i) {
    urdf::Joint& hinge = test::add_pendulum(robot, {0.0, 0.0, i == 0 ? 0.1 : -0.1}, 0.2, 0.05, 0.001);
    hinge.parent_link = i;
    robot.links.back().collision.push_back(ball(0.02, 0.1));
  }
  EXPECT_EQ(SelfCollision(robot).pairs(), 1U) << "the base and the third link";
}

TEST(SelfCollision, LeavesAloneWhatOverlapsAtHome) {
  urdf::RobotModel robot = two_arms();
  for (urdf::Link& link : robot.links) {
    if (!link.collision.empty() && link.parent_joint >= 0) link.collision[0] = ball(0.6, kArm_m);
  }
  const SelfCollision collision(robot);
  EXPECT_EQ(collision.pairs(), 0U);
  ASSERT_EQ(collision.overlapping_at_home().size(), 1U);
  EXPECT_EQ(collision.overlapping_at_home()[0], (std::pair{1, 2}));
}

TEST(SelfCollision, OfTheHumanoidFindsFeetThatAreTurnedIntoEachOther) {
  const urdf::RobotModel& robot = test::humanoid22();
  SelfCollision collision(robot);
  EXPECT_TRUE(collision.overlapping_at_home().empty());
  urdf::ForwardKinematics kinematics(robot);
  EXPECT_TRUE(collision.find(kinematics).empty());
  std::vector<double> posture;
  for (const urdf::Joint& joint : robot.joints) posture.push_back(joint.home_rad);
  // About the hips, 0.34 m above the soles: the feet come 0.34 * sin(0.2) = 68 mm nearer on each side.
  posture[static_cast<std::size_t>(robot.joint_index("left_hip_roll"))] -= 0.2;
  posture[static_cast<std::size_t>(robot.joint_index("right_hip_roll"))] += 0.2;
  kinematics.compute(posture);
  bool feet = false;
  for (const LinkContact& contact : collision.find(kinematics)) {
    feet = feet || (contact.one == robot.feet[0].link && contact.other == robot.feet[1].link);
    EXPECT_GT(contact.depth_m, 0.0);
  }
  EXPECT_TRUE(feet);
}

}  // namespace
}  // namespace gaitway::kinematic
