// The shipped motions on other bodies: planned, performed, or refused by name.
#include "gaitway/motion/motion_adaptation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "motion_fixture.hpp"
#include "performance.hpp"
#include "robots/robot_variants.hpp"

namespace gaitway::motion {
namespace {

using test::RobotVariant;
using ::testing::HasSubstr;

// Through its text, as the robot gets it.
Motion adapted(const std::string& name, const urdf::RobotModel& robot) {
  const AdaptedMotion made = adapt_motion(humanoid22(), shipped(name), robot);
  return parse_motion(motion_text(made.motion, robot, made.changes), name + ".yaml", robot);
}

std::string refusal_of(const std::string& name, const urdf::RobotModel& robot) {
  try {
    static_cast<void>(adapt_motion(humanoid22(), shipped(name), robot));
  } catch (const MotionError& error) {
    return error.what();
  }
  return "nothing";
}

void expect_same_keys(const Motion& motion, const Motion& original) {
  ASSERT_EQ(motion.keys.size(), original.keys.size());
  for (std::size_t i = 0; i < motion.keys.size(); ++i) {
    ASSERT_EQ(motion.keys[i].joints.size(), original.keys[i].joints.size());
    for (std::size_t j = 0; j < motion.keys[i].joints.size(); ++j) {
      EXPECT_NEAR(motion.keys[i].joints[j].angle_rad, original.keys[i].joints[j].angle_rad, 2e-4);
    }
  }
}

class ScaledBodies : public ::testing::TestWithParam<double> {};

TEST_P(ScaledBodies, StandOnOneFootAndKick) {
  RobotVariant variant;
  variant.scale(GetParam());
  const urdf::RobotModel robot = urdf::load_robot(variant.folder());
  const PlannedMotion planned = plan_motion(robot, adapted("kick", robot), {});
  for (const LimitUse& use : planned.report.uses) EXPECT_LE(use.excess, 0.0) << describe(use);
  const Performance performance = perform(robot, planned.plan);
  EXPECT_FALSE(performance.fallen);
  EXPECT_LT(performance.tilt_at_end_rad, 0.02);
  double highest_m = 0.0;
  for (const Key& key : adapted("kick", robot).keys) {
    if (key.foot[1]) highest_m = std::max(highest_m, key.foot[1]->position_m.z());
  }
  EXPECT_NEAR(highest_m, 0.06 * GetParam(), 1e-4) << "the foot is lifted with the body's size";
}

TEST_P(ScaledBodies, GetUpByTheSameAnglesInTimesThatGrowWithTheRootOfTheSize) {
  RobotVariant variant;
  variant.scale(GetParam());
  const urdf::RobotModel robot = urdf::load_robot(variant.folder());
  for (const std::string name : {"get_up_front", "get_up_back"}) {
    const Motion motion = adapted(name, robot);
    expect_same_keys(motion, shipped(name));
    EXPECT_NEAR(motion.keys[1].min_time_s, shipped(name).keys[1].min_time_s * std::sqrt(GetParam()), 1e-3);
    const MotionPlan plan = plan_motion(robot, motion, {}).plan;
    simulator::Plant plant(robot, {.mismatch = 0.0, .sensor_noise = false});
    fall(plant, robot, name == "get_up_front" ? 1.0 : -1.0, plan.reference(0));
    play(plant, robot, plan, 1.0);
    EXPECT_LT(plant.truth().trunk_tilt_rad, 0.05) << name;
    EXPECT_GT(plant.truth().base.translation().z(), 0.95 * robot.hip_height_m) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(SmallAndLarge, ScaledBodies, ::testing::Values(0.7, 1.4));

TEST(MotionAdaptation, GoesByNoNameAndByNoOrderOfTheHip) {
  RobotVariant variant;
  variant.reorder(test::kHip, {2, 0, 1});  // pitch, yaw, roll
  variant.rename();
  const urdf::RobotModel robot = urdf::load_robot(variant.folder());
  const Motion motion = adapted("get_up_back", robot);
  expect_same_keys(motion, shipped("get_up_back"));
  const auto angle_deg = [&](std::size_t key, const std::string& joint) {
    for (const JointAngle& angle : motion.keys.at(key).joints) {
      if (angle.joint == robot.joint_index(RobotVariant::renamed(joint))) return angle.angle_rad / kDegree;
    }
    return 999.0;
  };
  EXPECT_NEAR(angle_deg(1, "left_hip_yaw"), -92.0, 0.02) << "it is called yaw and pitches";
  EXPECT_NEAR(angle_deg(1, "left_knee"), 100.0, 0.02);
  EXPECT_NEAR(angle_deg(1, "right_shoulder_pitch"), -165.0, 0.02);
}

// What counts is how the limb hangs, not how its zero is chosen.
TEST(MotionAdaptation, TakesAnglesAgainstTheLimbAtHome) {
  urdf::RobotModel robot = humanoid22();
  urdf::Joint& elbow = robot.joints[static_cast<std::size_t>(robot.joint_index("left_elbow"))];
  const double shift_rad = 0.3;  // its zero is elsewhere
  elbow.origin.rotate(Eigen::AngleAxisd(-shift_rad, elbow.axis));
  elbow.home_rad += shift_rad;
  elbow.lower_rad += shift_rad;
  elbow.upper_rad += shift_rad;
  const AdaptedMotion made = adapt_motion(humanoid22(), shipped("wave"), robot);
  for (const JointAngle& angle : made.motion.keys.at(0).joints) {
    if (angle.joint != robot.joint_index("left_elbow")) continue;
    EXPECT_NEAR(angle.angle_rad, shift_rad - 60.0 * kDegree, 1e-6);
  }
}

TEST(MotionAdaptation, WithoutArmsNamesWhatIsMissingOrDoesWithout) {
  RobotVariant variant;
  variant.remove_arms();
  const urdf::RobotModel robot = urdf::load_robot(variant.folder());
  EXPECT_THAT(refusal_of("wave", robot), HasSubstr("key 'raise' turns the left shoulder pitch"));
  EXPECT_THAT(refusal_of("wave", robot), HasSubstr("has no left shoulder pitch"));
  EXPECT_THAT(refusal_of("get_up_front", robot), HasSubstr("has no left shoulder pitch"));
  const AdaptedMotion kick = adapt_motion(humanoid22(), shipped("kick"), robot);
  EXPECT_THAT(kick.changes, ::testing::Contains(HasSubstr("left shoulder roll: left out")));
  EXPECT_NO_THROW(static_cast<void>(plan_motion(robot, adapted("kick", robot), {})));
}

TEST(MotionAdaptation, TakesTheStopOrNamesIt) {
  urdf::RobotModel robot = humanoid22();
  urdf::Joint& knee = robot.joints[static_cast<std::size_t>(robot.joint_index("left_knee"))];
  knee.upper_rad = 125.0 * kDegree;  // the key 'push' wants 129
  const AdaptedMotion made = adapt_motion(humanoid22(), shipped("get_up_back"), robot);
  EXPECT_THAT(made.changes, ::testing::Contains(HasSubstr("'left_knee' would be at 129.0 deg")));
  knee.upper_rad = 110.0 * kDegree;
  EXPECT_THAT(refusal_of("get_up_back", robot), HasSubstr("'left_knee' would be at 129.0 deg"));
}

}  // namespace
}  // namespace gaitway::motion
