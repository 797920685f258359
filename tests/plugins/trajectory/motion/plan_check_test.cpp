// The dense check notices each limit that is broken, at its joint and time.
#include "gaitway/motion/motion_limits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/stance_map.hpp"
#include "motion_fixture.hpp"

namespace gaitway::motion {
namespace {

// The robot stands in the posture of a key for some points.
MotionPlan standing(const std::string& key, std::size_t points) {
  const urdf::RobotModel& robot = humanoid22();
  const KeyPosture posture = key_postures(robot, of_keys(key), {}).at(1);
  MotionPlan plan{.name = "still", .joint_count = robot.joints.size()};
  for (std::size_t i = 0; i < points; ++i) {
    plan.joint_rad.insert(plan.joint_rad.end(), posture.joint_rad.begin(), posture.joint_rad.end());
    plan.contact.push_back(Contact::both);
    plan.pelvis.push_back(pose_at(*posture.stance, StanceMap::kPelvis));
  }
  return plan;
}

double& angle(MotionPlan& plan, std::size_t point, const std::string& joint) {
  return plan.joint_rad[point * plan.joint_count + static_cast<std::size_t>(humanoid22().joint_index(joint))];
}

LimitUse use_of(const MotionPlan& plan, LimitKind kind, const MotionLimits& limits = {}) {
  for (const LimitUse& use : check_plan(humanoid22(), plan, limits).uses) {
    if (use.kind == kind) return use;
  }
  return {};
}

const std::string kHome = "  - {name: a, from: home}\n";

TEST(PlanCheck, StandingStillBreaksNothing) {
  const PlanReport report = check_plan(humanoid22(), standing(kHome, 20), {});
  EXPECT_EQ(report.broken(), nullptr);
  EXPECT_EQ(report.uses.size(), 8U);
}

TEST(PlanCheck, OfOneJointThatJumpsTellsJointTimeValueAndLimit) {
  MotionPlan plan = standing(kHome, 20);
  for (std::size_t i = 10; i < 20; ++i) angle(plan, i, "neck_yaw") += 0.08;
  const LimitUse speed = use_of(plan, LimitKind::speed);
  EXPECT_EQ(speed.what, "neck_yaw");
  EXPECT_DOUBLE_EQ(speed.time_s, 0.10);
  EXPECT_NEAR(speed.value, 8.0, 1e-9);
  EXPECT_NEAR(speed.limit, 7.2, 1e-9);
  EXPECT_THAT(describe(speed), ::testing::HasSubstr("neck_yaw: speed 8 rad/s at 0.10 s, limit 7.2 rad/s"));
  EXPECT_GT(use_of(plan, LimitKind::acceleration).excess, 0.0);
  EXPECT_GT(use_of(plan, LimitKind::torque).excess, 0.0);
}

TEST(PlanCheck, TheWireLimitsSpeedWhereMotorsAreFaster) {
  urdf::RobotModel robot = humanoid22();
  for (urdf::Joint& joint : robot.joints)
    joint.motor.speed_limit_rad_per_s = joint.velocity_limit_rad_per_s = 30.0;
  const double most = JointLimits(robot, {}).speed_rad_per_s[0];
  EXPECT_NEAR(most * facts::kSlot_s / robot.joints[0].count_rad, 126.0, 1e-9);
}

TEST(PlanCheck, NoticesStopsFeetAndBalance) {
  MotionPlan plan = standing(kHome, 20);
  angle(plan, 5, "left_elbow") = 0.0;
  EXPECT_EQ(use_of(plan, LimitKind::position).what, "left_elbow");
  EXPECT_GT(use_of(plan, LimitKind::position).excess, 0.0);

  plan = standing(kHome, 20);
  angle(plan, 7, "right_ankle_roll") += 0.02;  // the sole's edge goes 0.85 mm into the ground
  EXPECT_EQ(use_of(plan, LimitKind::foot_place).what, "right sole");
  EXPECT_NEAR(use_of(plan, LimitKind::foot_place).time_s, 0.07, 1e-9);
  EXPECT_GT(use_of(plan, LimitKind::foot_place).excess, 0.0);

  plan = standing("  - {name: a, pelvis: {hip_height_m: 0.34, forward_m: 0.05}}\n", 20);
  EXPECT_NEAR(use_of(plan, LimitKind::zmp).value, 17.5, 0.01);  // half a sole of 135 mm, less 50 mm
  EXPECT_GT(use_of(plan, LimitKind::zmp, {.zmp_margin_m = 0.02}).excess, 0.0);
}

TEST(PlanCheck, TheMotorsTorqueFadesWithSpeedWhenItDrivesAlone) {
  const JointLimits limits(humanoid22(), {.torque_share = 1.0});
  EXPECT_DOUBLE_EQ(limits.torque_Nm(0, 0.0, 5.0), 8.0);
  EXPECT_DOUBLE_EQ(limits.torque_Nm(0, 4.0, 5.0), 4.0);
  EXPECT_DOUBLE_EQ(limits.torque_Nm(0, 4.0, -5.0), 8.0);
  EXPECT_DOUBLE_EQ(limits.torque_Nm(0, 9.0, 5.0), 0.0);
}

}  // namespace
}  // namespace gaitway::motion
