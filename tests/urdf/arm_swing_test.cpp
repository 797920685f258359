// Arms are found by what they do, and weigh against the legs as their masses lie.
#include "gaitway/urdf/arm_swing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "robots/robot_variants.hpp"

namespace gaitway::urdf {
namespace {

RobotModel robot_of(const gaitway::test::RobotVariant& variant) {
  return load_robot(variant.folder());
}

// Sum of mass x velocity ahead x distance to the left, per radian, by moving the joints.
double moment_by_motion_kg_m2(const RobotModel& robot, const ArmSwing& swing) {
  constexpr double kStep_rad = 1e-4;
  std::vector<double> angles;
  for (const Joint& joint : robot.joints) angles.push_back(joint.home_rad);
  const ForwardKinematics home(robot);
  ForwardKinematics moved(robot);
  angles[static_cast<std::size_t>(swing.joint[0])] -= swing.sign[0] * kStep_rad;  // the left arm ahead
  angles[static_cast<std::size_t>(swing.joint[1])] += swing.sign[1] * kStep_rad;
  moved.compute(angles);
  double moment = 0.0;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const int link = static_cast<int>(i);
    const Eigen::Vector3d before = home.link_pose(link) * robot.links[i].com_m;
    const Eigen::Vector3d after = moved.link_pose(link) * robot.links[i].com_m;
    moment += robot.links[i].mass_kg * (after.x() - before.x()) * before.y();
  }
  return moment / kStep_rad;
}

TEST(ArmSwing, IsOfTheShouldersThatPitch) {
  const RobotModel robot = load_robot(GAITWAY_URDF_DIR "/humanoid22");
  const auto swing = arm_swing(robot, ForwardKinematics(robot));
  ASSERT_TRUE(swing);
  EXPECT_EQ(robot.joints[static_cast<std::size_t>(swing->joint[0])].name, "left_shoulder_pitch");
  EXPECT_EQ(robot.joints[static_cast<std::size_t>(swing->joint[1])].name, "right_shoulder_pitch");
  EXPECT_GT(swing->moment_kg_m2, 0.0);
  EXPECT_NEAR(swing->moment_kg_m2, moment_by_motion_kg_m2(robot, *swing), 1e-4 * swing->moment_kg_m2);
}

TEST(ArmSwing, IsTheSameWhateverTheJointsAreCalled) {
  gaitway::test::RobotVariant renamed;
  renamed.rename();
  const RobotModel robot = robot_of(gaitway::test::RobotVariant()), other = robot_of(renamed);
  const auto swing = arm_swing(robot, ForwardKinematics(robot));
  const auto swing_of_other = arm_swing(other, ForwardKinematics(other));
  ASSERT_TRUE(swing && swing_of_other);
  EXPECT_EQ(swing->moment_kg_m2, swing_of_other->moment_kg_m2);
  EXPECT_EQ(swing->joint, swing_of_other->joint);
}

TEST(ArmSwing, KeepsWithinTheNarrowerLimits) {
  RobotModel robot = load_robot(GAITWAY_URDF_DIR "/humanoid22");
  const auto usual = arm_swing(robot, ForwardKinematics(robot));
  ASSERT_TRUE(usual);
  Joint& right = robot.joints[static_cast<std::size_t>(usual->joint[1])];
  right.lower_rad = right.home_rad - 0.2;
  right.velocity_limit_rad_per_s = 1.0;
  const auto narrow = arm_swing(robot, ForwardKinematics(robot));
  ASSERT_TRUE(narrow);
  EXPECT_LE(narrow->most_rad, 0.2);
  EXPECT_EQ(narrow->most_rad_per_s, 1.0);
  right.lower_rad = right.home_rad;
  EXPECT_FALSE(arm_swing(robot, ForwardKinematics(robot))) << "an arm at its limit goes one way only";
}

TEST(ArmSwing, NeedsBothArms) {
  gaitway::test::RobotVariant without;
  without.remove_arms();
  const RobotModel robot = robot_of(without);
  EXPECT_FALSE(arm_swing(robot, ForwardKinematics(robot)));
}

// As asked while there is room; then less and less, without a jump of place or speed.
TEST(ArmSwing, LimitsWithoutAJerk) {
  ArmSwing swing;
  swing.most_rad = 0.5;
  EXPECT_EQ(swing.limited_rad(0.3), 0.3);
  EXPECT_EQ(swing.limited_rad(-0.3), -0.3);
  EXPECT_LE(swing.limited_rad(100.0), 0.5);
  EXPECT_GE(swing.limited_rad(-100.0), -0.5);
  constexpr double kStep_rad = 1e-3;
  double slope = 1.0;
  for (double asked_rad = 0.0; asked_rad < 1.5; asked_rad += kStep_rad) {
    const double next = (swing.limited_rad(asked_rad + kStep_rad) - swing.limited_rad(asked_rad)) / kStep_rad;
    EXPECT_LE(next, slope + 1e-9);
    EXPECT_GE(next, slope - 0.02);
    slope = next;
  }
}

}  // namespace
}  // namespace gaitway::urdf
