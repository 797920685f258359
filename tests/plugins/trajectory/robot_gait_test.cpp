// The pattern's numbers come from the robot's own description; footsteps that a leg cannot reach are refused
// before anything moves.
#include "gaitway/trajectory/robot_gait.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "gaitway/trajectory/walking_pattern.hpp"

namespace gaitway::trajectory {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const urdf::RobotModel& humanoid22() {
  static const urdf::RobotModel robot = urdf::load_robot(GAITWAY_ROBOTS "/humanoid22");
  return robot;
}
GaitParameters shipped() {
  return gait_of(humanoid22());
}

void expect_refused(const GaitParameters& parameters, const char* name_and_value, const char* reach) {
  EXPECT_THAT([&] { require_reachable(parameters, humanoid22()); },
              ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(name_and_value),
                                                         HasSubstr("footstep unreachable"), HasSubstr(reach),
                                                         HasSubstr("in the plug-in's configuration"))));
}

WalkCommand walk(double forward_m_per_s, double left_m_per_s, double turn_rad_per_s) {
  WalkCommand command{};
  command.walk = 1;
  command.velocity[0] = forward_m_per_s;
  command.velocity[1] = left_m_per_s;
  command.turn_rate = turn_rad_per_s;
  return command;
}

// Largest distance of hip and ankle over the points of a walk with both feet on the ground.
double farthest_in_walk_m(const GaitParameters& p, const WalkCommand& command) {
  const std::array<LegReach, 2> legs = leg_reach(humanoid22());
  WalkingPattern pattern(p);
  MotionPlan plan{};
  double farthest_m = 0.0;
  for (std::uint32_t batch = 1; batch <= 60; ++batch) {
    pattern.plan(batch, 80'000'000 * std::int64_t{batch}, command, Correction{}, plan);
    for (int i = 0; i < 8; ++i) {
      if (plan.foot_position[i][0][2] + plan.foot_position[i][1][2] > 1e-6) continue;
      for (std::size_t side = 0; side < 2; ++side) {
        const Eigen::Vector2d com(plan.com[i][0], plan.com[i][1]);
        const Eigen::Rotation2Dd base(plan.base_yaw[i]), foot(plan.foot_yaw[i][side]);
        const LegReach& leg = legs[side];
        const Eigen::Vector2d hip = com + base * Eigen::Vector2d(leg.hip_forward_m, leg.hip_left_m);
        const Eigen::Vector2d ankle =
            Eigen::Vector2d(plan.foot_position[i][side][0], plan.foot_position[i][side][1]) +
            foot * Eigen::Vector2d(leg.ankle_forward_m, leg.ankle_left_m);
        farthest_m =
            std::max(farthest_m, std::hypot((hip - ankle).norm(), plan.hip_height[i] - leg.ankle_height_m));
      }
    }
  }
  return farthest_m;
}

TEST(GaitOf, HumanoidHasTheDefaults) {
  const GaitParameters defaults, shipped_ones = shipped();
  EXPECT_EQ(shipped_ones.step_time_s, defaults.step_time_s);
  EXPECT_EQ(shipped_ones.max_step_forward_m, defaults.max_step_forward_m);
  EXPECT_EQ(shipped_ones.max_foot_spacing_m, defaults.max_foot_spacing_m);
  EXPECT_EQ(shipped_ones.settle_s, defaults.settle_s);
  EXPECT_EQ(shipped_ones.zmp_inward_m, defaults.zmp_inward_m);
}

// Knees that cannot be stretched: what the defaults ask for is out of reach, and would be refused.
TEST(GaitOf, LegsThatReachLessGetShorterSteps) {
  urdf::RobotModel robot = humanoid22();
  for (const urdf::Leg& leg : robot.legs)
    robot.joints[static_cast<std::size_t>(leg.joints[3])].lower_rad = 0.55;
  EXPECT_THROW(require_reachable(shipped(), robot), std::invalid_argument);
  const GaitParameters gait = gait_of(robot);
  EXPECT_NO_THROW(require_reachable(gait, robot));
  EXPECT_NO_THROW(gait.validate());
  EXPECT_LT(gait.max_step_forward_m, shipped().max_step_forward_m);
  EXPECT_GT(gait.max_step_forward_m, 0.03);
}

// It may still be configured, and is refused after that.
TEST(GaitOf, ABodyThatCannotStandSoIsNotRefusedBeforeItsConfigurationIsHeard) {
  urdf::RobotModel robot = humanoid22();
  for (urdf::Foot& foot : robot.feet) foot.size_m.y() = 0.2;  // the soles overlap
  GaitParameters gait;
  EXPECT_NO_THROW(gait = gait_of(robot));
  EXPECT_THROW(gait.validate(), std::invalid_argument);
}

TEST(GaitOf, AWiderStanceIsSteppedOutOfAsFar) {
  urdf::RobotModel robot = humanoid22();
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    robot.joints[static_cast<std::size_t>(robot.legs[side].joints[0])].origin.translation().y() +=
        side == 0 ? 0.02 : -0.02;
  }
  const GaitParameters gait = gait_of(robot);
  EXPECT_NEAR(gait.foot_spacing_m, 0.14, 1e-9);
  EXPECT_NEAR(gait.adjust_spacing_m, shipped().adjust_spacing_m + 0.04, 1e-9);
  EXPECT_NO_THROW(gait.validate());
}

TEST(StandingPosture, HumanoidStandsAsItsDescriptionSays) {
  const GaitParameters p = gait_of(humanoid22());
  EXPECT_NO_THROW(p.validate());
  EXPECT_EQ(p.hip_height_m, humanoid22().hip_height_m);
  EXPECT_NEAR(p.foot_spacing_m, 0.100, 0.005);
  EXPECT_NEAR(p.com_height_m, 0.378, 0.02);
  EXPECT_NEAR(p.sole.length_m, 0.135, 1e-9);
}

TEST(ReachCheck, MeasuresTheLegFromItsJoints) {
  for (const LegReach& leg : leg_reach(humanoid22())) {
    EXPECT_NEAR(leg.longest_m, 0.34, 1e-9);  // thigh and shin of 0.17 m, the knee goes to 0
    EXPECT_NEAR(leg.shortest_m, 0.34 * std::cos(0.5 * 2.3), 1e-9);
    EXPECT_NEAR(leg.ankle_height_m, 0.04, 1e-9);
    EXPECT_NEAR(std::abs(leg.hip_left_m), 0.05, 1e-9);
  }
}

TEST(ReachCheck, TheShippedLimitsAreWithinReach) {
  EXPECT_NO_THROW(require_reachable(shipped(), humanoid22()));
}

TEST(ReachCheck, RefusalNamesParameterValueReachAndRemedy) {
  GaitParameters p = shipped();
  p.max_step_forward_m = 0.25;
  expect_refused(p, "max_step_forward = 0.25 m", "the leg reaches 0.338 m");
  p = shipped();
  p.max_step_backward_m = 0.25;
  expect_refused(p, "max_step_backward = 0.25 m", "the leg reaches 0.338 m");
  p = shipped();
  p.max_foot_spacing_m = 0.40;
  expect_refused(p, "max_foot_spacing = 0.4 m", "Lower max_foot_spacing");
  p = shipped();
  p.hip_height_m = 0.40;
  expect_refused(p, "hip_height = 0.4 m", "Lower hip_height");
}

TEST(ReachCheck, RefusesALiftThatTheKneeCannotFoldTo) {
  GaitParameters p = shipped();
  p.lift_m = 0.19;
  expect_refused(p, "lift = 0.19 m", "the leg folds to");
}

TEST(ReachCheck, ALowerHipAllowsLongerSteps) {
  GaitParameters p = shipped();
  p.max_step_forward_m = 0.25;
  EXPECT_THROW(require_reachable(p, humanoid22()), std::invalid_argument);
  p.hip_height_m = 0.31;
  p.fast_hip_height_m = 0.30;
  EXPECT_NO_THROW(require_reachable(p, humanoid22()));
}

void limit_ankle_pitch(urdf::RobotModel& robot, double to_limit_rad) {
  for (urdf::Joint& joint : robot.joints) {
    if (!joint.name.ends_with("ankle_pitch")) continue;
    joint.lower_rad = joint.home_rad - to_limit_rad;
    joint.upper_rad = joint.home_rad + to_limit_rad;
  }
}

TEST(RoomForSteps, IsLackedByAnAnkleThatStandsAtItsLimit) {
  urdf::RobotModel robot = humanoid22();
  EXPECT_NO_THROW(require_room_for_steps(shipped(), robot));
  limit_ankle_pitch(robot, 0.05);
  EXPECT_THAT([&] { require_walkable(shipped(), robot); },
              ThrowsMessage<std::invalid_argument>(
                  AllOf(HasSubstr("hip_height = 0.36 m"), HasSubstr("the ankle pitch"),
                        HasSubstr("beyond its limits"), HasSubstr("home angles in robot.yaml"))));
}

TEST(RoomForSteps, AMotorThatIsTooSlowForAnyStepIsRefusedBySpeed) {
  urdf::RobotModel robot = humanoid22();
  for (urdf::Joint& joint : robot.joints) {
    if (joint.name.ends_with("knee")) joint.velocity_limit_rad_per_s = 1.0;
  }
  EXPECT_THAT([&] { require_walkable(shipped(), robot); },
              ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("step_time"), HasSubstr("the knee"),
                                                         HasSubstr("'left_knee' turns at 1 at most"))));
}

// The corner that the check takes is no nearer than what the pattern really plans at full speed.
TEST(ReachCheck, BoundsThePlannedWalk) {
  const GaitParameters p = shipped();
  const LegReach leg = leg_reach(humanoid22())[0];
  const double forward_m = farthest_hip_to_ankle_m(p, leg, p.max_step_forward_m, p.max_foot_spacing_m);
  const double backward_m = farthest_hip_to_ankle_m(p, leg, p.max_step_backward_m, p.max_foot_spacing_m);
  EXPECT_LE(farthest_in_walk_m(p, walk(1.0, 0.0, 0.0)), forward_m);
  EXPECT_LE(farthest_in_walk_m(p, walk(1.0, 0.3, 0.5)), forward_m);
  EXPECT_LE(farthest_in_walk_m(p, walk(0.0, 1.0, 0.0)), forward_m);
  EXPECT_LE(farthest_in_walk_m(p, walk(0.0, 0.0, 2.0)), forward_m);
  EXPECT_LE(farthest_in_walk_m(p, walk(-1.0, 0.0, 0.0)), backward_m);
}

}  // namespace
}  // namespace gaitway::trajectory
