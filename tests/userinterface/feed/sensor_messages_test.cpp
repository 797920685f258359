// Joint states, trunk sensors and feet, against values worked out by hand.
#include "gaitway/api/state_messages.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "gaitway/api/ros_messages.hpp"
#include "humanoid.hpp"

namespace gaitway::api {
namespace {

using test::humanoid;

TEST(RosTime, SplitsIntoSecondsAndNanoseconds) {
  EXPECT_EQ(ros_time(12'345'678'901).sec, 12);
  EXPECT_EQ(ros_time(12'345'678'901).nanosec, 345'678'901U);
  EXPECT_EQ(ros_time(-1).sec, -1);
  EXPECT_EQ(ros_time(-1).nanosec, 999'999'999U);
}

TEST(JointStateMessage, HasEveryJointByItsNameInTheModelsOrder) {
  ros::JointState message = make_joint_state(humanoid());
  JointStates joints{};
  joints.stamp_ns = 3'000'000'005;
  joints.joint_count = 22;
  for (int i = 0; i < 22; ++i) {
    joints.position[i] = 0.01 * i;
    joints.velocity[i] = -0.1 * i;
    joints.torque[i] = 1.0 + i;
  }
  fill(message, joints);
  ASSERT_EQ(message.name.size(), 22U);
  ASSERT_EQ(message.position.size(), 22U);
  ASSERT_EQ(message.velocity.size(), 22U);
  ASSERT_EQ(message.effort.size(), 22U);
  EXPECT_EQ(message.name[3], "left_knee");
  EXPECT_DOUBLE_EQ(message.position[3], 0.03);
  EXPECT_DOUBLE_EQ(message.velocity[3], -0.3);
  EXPECT_DOUBLE_EQ(message.effort[21], 22.0);
  EXPECT_EQ(message.header.stamp.sec, 3);
  EXPECT_EQ(message.header.stamp.nanosec, 5U);
}

TEST(ImuMessage, IsInTheFrameOfTheLinkThatCarriesTheSensors) {
  EXPECT_EQ(make_imu(humanoid()).header.frame_id, "trunk");
}

TEST(ImuMessage, TurnsByRollThenPitchThenYaw) {
  ros::Imu message = make_imu(humanoid());
  gaitway::Imu imu{};
  imu.stamp_ns = 7;
  imu.angular_velocity[2] = 0.5;
  imu.acceleration[2] = 9.81;
  Estimate estimate{};
  estimate.attitude[2] = std::numbers::pi / 2.0;
  estimate.attitude[1] = 0.2;
  fill(message, imu, &estimate);
  // Rz(90°)·Ry(0.2): (cos 45°·cos 0.1, −sin 45°·sin 0.1, cos 45°·sin 0.1, sin 45°·cos 0.1) as w, x, y, z.
  const double s = std::numbers::sqrt2 / 2.0;
  EXPECT_NEAR(message.orientation.w, s * std::cos(0.1), 1e-12);
  EXPECT_NEAR(message.orientation.x, -s * std::sin(0.1), 1e-12);
  EXPECT_NEAR(message.orientation.y, s * std::sin(0.1), 1e-12);
  EXPECT_NEAR(message.orientation.z, s * std::cos(0.1), 1e-12);
  EXPECT_EQ(message.orientation_covariance[0], 0.0);
  EXPECT_EQ(message.angular_velocity.z, 0.5);
  EXPECT_EQ(message.linear_acceleration.z, 9.81);
  EXPECT_EQ(message.header.stamp.nanosec, 7U);
}

TEST(ImuMessage, SaysThatItDoesNotKnowTheOrientationWithoutAnEstimate) {
  ros::Imu message = make_imu(humanoid());
  const Estimate estimate{};
  fill(message, gaitway::Imu{}, &estimate);
  fill(message, gaitway::Imu{}, nullptr);
  EXPECT_EQ(message.orientation_covariance[0], -1.0);
  EXPECT_EQ(message.orientation.w, 1.0);
}

TEST(FootWrench, IsTheCellsForceAndItsMomentsAboutTheSole) {
  // Sole 135 x 85 mm around (10, 0) mm, cells 5 mm inside: x 72.5 and -52.5 mm, y ±37.5 mm.
  FootForces forces{};
  forces.stamp_ns = 9;
  const std::array<double, 4> cell_N{10.0, 20.0, 5.0, 1.0};  // front left, front right, rear left, rear right
  std::copy(cell_N.begin(), cell_N.end(), forces.force[1]);
  ros::WrenchStamped message = make_foot_wrench(humanoid(), urdf::Side::right);
  fill(message, forces, humanoid(), urdf::Side::right);
  EXPECT_EQ(message.header.frame_id, "right_sole");
  EXPECT_DOUBLE_EQ(message.wrench.force.z, 36.0);
  EXPECT_NEAR(message.wrench.torque.x, 0.0375 * (10.0 - 20.0 + 5.0 - 1.0), 1e-12);
  EXPECT_NEAR(message.wrench.torque.y, -(0.0725 * 30.0 - 0.0525 * 6.0), 1e-12);
  EXPECT_EQ(message.wrench.force.x, 0.0);
  EXPECT_EQ(message.wrench.torque.z, 0.0);
}

TEST(FootWrench, OfAnUnloadedFootIsZeroAgain) {
  FootForces forces{};
  forces.force[0][0] = 3.0;
  ros::WrenchStamped message = make_foot_wrench(humanoid(), urdf::Side::left);
  fill(message, forces, humanoid(), urdf::Side::left);
  forces.force[0][0] = 0.0;
  fill(message, forces, humanoid(), urdf::Side::left);
  EXPECT_EQ(message.wrench.force.z, 0.0);
  EXPECT_EQ(message.wrench.torque.y, 0.0);
}

}  // namespace
}  // namespace gaitway::api
