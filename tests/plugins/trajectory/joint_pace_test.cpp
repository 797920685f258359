// Motors that turn slowly get a gait that they can follow; kinematics/joint_pace_test.cpp says how near the
// reckoning is.
#include "gaitway/trajectory/joint_pace.hpp"

#include <gtest/gtest.h>

#include "gaitway/trajectory/robot_gait.hpp"

namespace gaitway::trajectory {
namespace {

urdf::RobotModel with_motors(double speed_rad_per_s) {
  urdf::RobotModel robot = urdf::load_robot(GAITWAY_ROBOTS "/humanoid22");
  for (urdf::Joint& joint : robot.joints) joint.velocity_limit_rad_per_s = speed_rad_per_s;
  return robot;
}

TEST(JointPace, GrowsWithSpeedAndLiftAndFallsWithTheStepTime) {
  const urdf::RobotModel robot = with_motors(8.0);
  const GaitParameters gait = gait_of(robot);
  const double usual = fastest_joint(gait, robot, 0.15).share;
  EXPECT_GT(fastest_joint(gait, robot, 0.40).share, 1.1 * usual);
  GaitParameters higher = gait, slower = gait;
  higher.lift_m *= 1.3;
  slower.step_time_s *= 1.3;
  EXPECT_GT(fastest_joint(higher, robot, 0.15).share, 1.02 * usual);
  EXPECT_LT(fastest_joint(slower, robot, 0.15).share, 0.95 * usual);
  EXPECT_NEAR(fastest_joint(gait, with_motors(4.0), 0.15).share, 2.0 * usual, 1e-9);
}

TEST(GaitOf, SlowMotorsGetAGaitThatTheyCanFollow) {
  const GaitParameters usual = gait_of(with_motors(8.0));
  for (const double speed_rad_per_s : {6.8, 5.7, 4.7, 4.2}) {  // 1.3 to 0.8 of sqrt(g / hip height)
    const urdf::RobotModel robot = with_motors(speed_rad_per_s);
    const GaitParameters gait = gait_of(robot);
    EXPECT_NO_THROW(gait.validate());
    EXPECT_LE(fastest_joint(gait, robot, 0.15).share, 0.8) << speed_rad_per_s;
    EXPECT_LE(fastest_joint(gait, robot, gait.max_step_forward_m / gait.step_time_s).share, 0.93)
        << speed_rad_per_s;
    EXPECT_LT(gait.max_step_forward_m / gait.step_time_s, usual.max_step_forward_m / usual.step_time_s);
    EXPECT_GE(gait.lift_m, 0.3 * 0.95 * usual.lift_m) << "the feet still leave the ground";
  }
}

}  // namespace
}  // namespace gaitway::trajectory
