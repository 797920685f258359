// Every shipped motion is planned within all limits, and the simulated robot performs it on its feet.
#include <gtest/gtest.h>

#include "motion_fixture.hpp"
#include "performance.hpp"

namespace gaitway::motion {
namespace {

class ShippedMotion : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedMotion, IsPlannedWithinAllLimitsAndPerformedOnItsFeet) {
  const urdf::RobotModel& robot = humanoid22();
  const PlannedMotion planned = plan_motion(robot, shipped(GetParam()), {});
  for (const LimitUse& use : check_plan(robot, planned.plan, {}).uses)
    EXPECT_LE(use.excess, 0.0) << describe(use);
  EXPECT_LT(planned.plan.duration_s(), 0.8 * planned.first_duration_s);

  // From home and back, at rest.
  for (const std::size_t point : {std::size_t{0}, planned.plan.point_count() - 1}) {
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      EXPECT_NEAR(planned.plan.point(point)[j], robot.joints[j].home_rad, 1e-6) << robot.joints[j].name;
    }
  }

  const Performance performance = perform(robot, planned.plan);
  EXPECT_FALSE(performance.fallen);
  EXPECT_LT(performance.tilt_at_end_rad, 0.02);
  EXPECT_LT(performance.end_offset_m, 0.01);
  EXPECT_LT(performance.worst_tracking_rad, 0.015);
  EXPECT_LT(performance.zmp_error_rms_m, 0.010);
}

INSTANTIATE_TEST_SUITE_P(Motions, ShippedMotion, ::testing::Values("wave", "bow", "squat", "kick"),
                         [](const auto& chosen) { return chosen.param; });

struct Fall {
  const char* motion;
  double direction;  // 1 onto the front, -1 onto the back
};

class GetUp : public ::testing::TestWithParam<Fall> {};

TEST_P(GetUp, ToAStand) {
  urdf::RobotModel robot = humanoid22();
  // Without feedback two of three robots whose servos and motors differ stand up: `gaitway measure gait
  // --rows get_up_front,get_up_back` is about those, with all that balances.
  robot.parts_deviation = 0.0;
  const MotionPlan plan = plan_motion(robot, shipped(GetParam().motion), {}).plan;
  const auto stands_up = [&](const simulator::PlantOptions& options) {
    simulator::Plant plant(robot, options);
    fall(plant, robot, GetParam().direction, plan.reference(0));
    const simulator::PlantTruth lying = plant.truth();
    EXPECT_LT(lying.base.translation().z(), 0.15);
    EXPECT_LT(GetParam().direction * lying.trunk.linear()(2, 0), -0.9) << "the side it lies on";
    play(plant, robot, plan, 1.0);
    return plant.truth().trunk_tilt_rad < 0.05 && plant.truth().base.translation().z() > 0.35;
  };
  EXPECT_TRUE(stands_up({.mismatch = 0.0, .sensor_noise = false}));
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    EXPECT_TRUE(stands_up({.seed = seed, .mismatch = 1.0, .sensor_noise = false})) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, GetUp,
                         ::testing::Values(Fall{"get_up_front", 1.0}, Fall{"get_up_back", -1.0}),
                         [](const auto& chosen) { return chosen.param.motion; });

// Compliant servos given the planned angles themselves lag by what the torques take, and the robot rocks.
TEST(ServoLead, KeepsTheKicksZmpWhereItIsPlanned) {
  MotionPlan plan = plan_motion(humanoid22(), shipped("kick"), {}).plan;
  const double leading_m = perform(humanoid22(), plan).zmp_error_rms_m;
  plan.reference_rad = plan.joint_rad;
  EXPECT_LT(3.0 * leading_m, perform(humanoid22(), plan).zmp_error_rms_m);
}

// Nothing is left to give: a motion that moves one joint alone goes as fast as that joint's limits let it.
TEST(MotionPlanner, IsTimeOptimalForOneJoint) {
  const Motion motion = of_keys("  - {name: turn, joints: {neck_yaw: 70}}\n  - {name: back, from: home}\n");
  const PlannedMotion planned = plan_motion(humanoid22(), motion, {.limits = {}, .smoothness = 1e-9});
  double nearest = 1e9;
  for (const LimitUse& use : planned.report.uses) {
    const bool of_motor =
        use.kind == LimitKind::speed || use.kind == LimitKind::torque || use.kind == LimitKind::acceleration;
    if (of_motor) nearest = std::min(nearest, -use.excess / use.limit);
  }
  EXPECT_LT(nearest, 0.08);
}

TEST(MotionPlanner, KeepsLeastTimesAndHolds) {
  const Motion motion = of_keys(
      "  - {name: turn, min_time_s: 0.9, hold_s: 0.4, joints: {neck_yaw: 20}}\n  - {name: back, from: "
      "home}\n");
  const MotionPlan plan = plan_motion(humanoid22(), motion, {}).plan;
  ASSERT_EQ(plan.keys.size(), 2U);
  EXPECT_GE(plan.keys[0].reached, 90U);
  EXPECT_EQ(plan.keys[0].left - plan.keys[0].reached, 40U);
  const auto yaw = static_cast<std::size_t>(humanoid22().joint_index("neck_yaw"));
  for (std::size_t i = plan.keys[0].reached; i <= plan.keys[0].left; ++i) {
    EXPECT_NEAR(plan.point(i)[yaw], 20.0 * kDegree, 1e-12);
  }
}

TEST(MotionPlanner, TheSameKeysGiveTheSamePointsToTheBit) {
  const Motion motion = shipped("squat");
  EXPECT_EQ(plan_motion(humanoid22(), motion, {}).plan.joint_rad,
            plan_motion(humanoid22(), motion, {}).plan.joint_rad);
}

// What motors are too weak for takes longer, and is refused where slowness does not help.
TEST(MotionPlanner, WeakMotorsAreSlowerOrRefused) {
  urdf::RobotModel weak = humanoid22();
  for (urdf::Joint& joint : weak.joints) joint.motor.torque_limit_Nm = 4.0;
  const Motion squat = shipped("squat");
  const double normal_s = plan_motion(humanoid22(), squat, {}).plan.duration_s();
  EXPECT_GT(plan_motion(weak, squat, {}).plan.duration_s(), normal_s);
  for (urdf::Joint& joint : weak.joints) joint.motor.torque_limit_Nm = 2.0;
  try {
    static_cast<void>(plan_motion(weak, squat, {}));
    FAIL() << "planned";
  } catch (const MotionError& error) {
    EXPECT_NE(std::string(error.what()).find("key 'down': left_hip_pitch needs"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace gaitway::motion
