// Base, support foot and velocities in `odom`.
#include "gaitway/api/robot_frames.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "humanoid.hpp"

namespace gaitway::api {
namespace {

using test::humanoid;

using facts::kSlot_ns;

std::vector<double> home() {
  std::vector<double> position_rad;
  for (const urdf::Joint& joint : humanoid().joints) position_rad.push_back(joint.home_rad);
  return position_rad;
}

PlannedState planned(const Eigen::Vector3d& left_m, double left_yaw_rad,
                     const Eigen::Vector3d& right_m = Eigen::Vector3d::Zero()) {
  PlannedState moment{};
  std::ranges::copy(left_m, moment.foot_position[0]);
  std::ranges::copy(right_m, moment.foot_position[1]);
  moment.foot_yaw[0] = left_yaw_rad;
  std::ranges::fill(moment.on_ground, 1U);
  return moment;
}

class RobotFramesTest : public ::testing::Test {
 protected:
  void update(const std::optional<PlannedState>& moment = std::nullopt) {
    now_ns += kSlot_ns;
    frames.update(now_ns, position_rad, velocity_rad_per_s, estimate, moment ? &*moment : nullptr);
  }

  std::vector<double> position_rad = home();
  std::vector<double> velocity_rad_per_s = std::vector<double>(22, 0.0);
  Estimate estimate{};
  RobotFrames frames{humanoid()};
  std::int64_t now_ns = 0;
};

TEST_F(RobotFramesTest, StandsOverTheOriginBeforeThereIsAPlan) {
  update();
  EXPECT_TRUE(frames.odom_from_base().translation().isApprox(Eigen::Vector3d(0.0, 0.0, 0.36), 1e-6));
  EXPECT_TRUE(frames.odom_from_base().linear().isIdentity(1e-9));
  EXPECT_NEAR(frames.odom_from_support().translation().y(), 0.05, 0.02) << "the left foot";
}

// Whoever begins to look on, or does so anew, sees the robot where it was.
TEST_F(RobotFramesTest, BeginsWhereTheRobotsOwnOdometryIs) {
  std::ranges::copy(std::array{2.0, 1.05, 0.3}, estimate.odometry_foot[0]);
  std::ranges::copy(std::array{2.0, 0.95, 0.3}, estimate.odometry_foot[1]);
  estimate.attitude[2] = 17.0;  // the gyro's own, which has nothing to do with it
  update();
  EXPECT_TRUE(frames.odom_from_support().translation().isApprox(Eigen::Vector3d(2.0, 1.05, 0.0), 1e-9));
  const Eigen::Matrix3d& turn = frames.odom_from_base().linear();
  EXPECT_NEAR(std::atan2(turn(1, 0), turn(0, 0)), 0.3, 1e-9);
  std::ranges::copy(std::array{5.0, 5.05, 0.3}, estimate.odometry_foot[0]);
  update();
  EXPECT_NEAR(frames.odom_from_support().translation().x(), 2.0, 1e-9)
      << "it has a reckoning of its own from then on";
  frames.reset();
  update();
  EXPECT_NEAR(frames.odom_from_support().translation().x(), 5.0, 1e-9);
}

TEST_F(RobotFramesTest, LaysThePlanSoThatTheSupportFootIsWhereItWasPlanned) {
  update(planned({1.0, 2.0, 0.0}, std::numbers::pi / 2.0, {9.0, 9.0, 0.0}));
  const Eigen::Isometry3d& plan = frames.odom_from_plan();
  EXPECT_TRUE(
      (plan * Eigen::Vector3d(1.0, 2.0, 0.0)).isApprox(frames.odom_from_support().translation(), 1e-9));
  EXPECT_TRUE((plan.linear() * Eigen::Vector3d::UnitY()).isApprox(Eigen::Vector3d::UnitX(), 1e-9));
}

TEST_F(RobotFramesTest, TurnsWithTheTrunkAboutTheSupportFoot) {
  update();
  const Eigen::Vector3d foot_m = frames.odom_from_support().translation();
  for (int slot = 0; slot < 50; ++slot) {
    estimate.attitude[2] += 0.01;
    update();
  }
  EXPECT_NEAR(std::atan2(frames.odom_from_base().linear()(1, 0), frames.odom_from_base().linear()(0, 0)), 0.5,
              1e-9);
  EXPECT_TRUE(frames.odom_from_support().translation().isApprox(foot_m, 1e-9));
}

TEST_F(RobotFramesTest, AGyroThatBeginsAnewIsNoTurn) {
  estimate.attitude[2] = 2.0;
  update();
  const Eigen::Isometry3d before = frames.odom_from_base();
  estimate.attitude[2] = 0.0;
  update();
  EXPECT_TRUE(frames.odom_from_base().isApprox(before, 1e-9));
}

TEST_F(RobotFramesTest, LeansAsTheTrunkIsMeasuredTo) {
  estimate.attitude[0] = 0.05;
  estimate.attitude[1] = 0.10;
  estimate.attitude[2] = 3.0;  // turned before it was first looked at
  update(planned({0.0, 0.0, 0.0}, 0.0));
  const Eigen::Matrix3d turn = frames.odom_from_base().linear();
  EXPECT_NEAR(std::asin(-turn(2, 0)), 0.10, 1e-9);
  EXPECT_NEAR(std::atan2(turn(2, 1), turn(2, 2)), 0.05, 1e-9);
  EXPECT_NEAR(std::atan2(turn(1, 0), turn(0, 0)), 0.0, 0.01)
      << "along the foot, up to the tilt's second order";
}

TEST_F(RobotFramesTest, TakesTheWaistOutOfTheTrunksAttitude) {
  position_rad[static_cast<std::size_t>(humanoid().joint_index("waist_pitch"))] = 0.3;
  estimate.attitude[1] = 0.3;
  update(planned({0.0, 0.0, 0.0}, 0.0));
  EXPECT_TRUE(frames.odom_from_base().linear().isIdentity(1e-9));
}

TEST_F(RobotFramesTest, LeavesThePlanWhereItIsWhileThatHasTheSupportFootInTheAir) {
  update(planned({1.0, 0.0, 0.0}, 0.0));
  const Eigen::Isometry3d before = frames.odom_from_plan();
  PlannedState lifted = planned({1.2, 0.0, 0.02}, 0.0);
  lifted.on_ground[0] = 0;
  update(lifted);
  EXPECT_TRUE(frames.odom_from_plan().isApprox(before, 1e-12));
}

TEST_F(RobotFramesTest, PutsTheOtherFootWhereTheJointsHaveIt) {
  update();
  const Eigen::Isometry3d before = frames.odom_from_base();
  const Eigen::Vector3d left_m = frames.odom_from_support().translation();
  estimate.support = 1;
  update();
  EXPECT_TRUE(frames.odom_from_base().isApprox(before, 1e-9));
  EXPECT_NEAR(frames.odom_from_support().translation().y(), -left_m.y(), 1e-9);
}

TEST_F(RobotFramesTest, HasTheVelocityOfTheBaseOverTheFoot) {
  // Ankle and hip pitch of both legs swing the base over the feet as an inverted pendulum, trunk upright.
  const double rate_rad_per_s = 0.2;
  const auto index = [](const char* name) { return static_cast<std::size_t>(humanoid().joint_index(name)); };
  const std::array joints{index("left_ankle_pitch"), index("right_ankle_pitch"), index("left_hip_pitch"),
                          index("right_hip_pitch")};
  const std::array signs{-1.0, -1.0, 1.0, 1.0};
  for (int slot = 0; slot < 60; ++slot) {
    for (std::size_t i = 0; i < joints.size(); ++i)
      position_rad[joints[i]] += signs[i] * rate_rad_per_s * 0.01;
    update(planned({0.0, 0.0, 0.0}, 0.0));
  }
  // The hips turn about the ankles, 0.32 m below them and about level: v = ω·h.
  const double height_m = 0.36 - 0.04;
  const Eigen::Vector3d velocity = frames.linear_velocity_m_per_s();
  EXPECT_NEAR(velocity.norm(), rate_rad_per_s * height_m, 0.003);
  EXPECT_GT(std::abs(velocity.x()), 0.05);
}

TEST_F(RobotFramesTest, ANewSupportFootIsNoVelocity) {
  update(planned({0.0, 0.05, 0.0}, 0.0, {0.0, -0.05, 0.0}));
  estimate.support = 1;
  update(planned({0.0, 0.05, 0.0}, 0.0, {0.03, -0.05, 0.0}));  // 30 mm off
  EXPECT_NEAR(frames.linear_velocity_m_per_s().norm(), 0.0, 1e-12);
}

TEST_F(RobotFramesTest, TakesTheWaistsRateOutOfTheTrunks) {
  velocity_rad_per_s[static_cast<std::size_t>(humanoid().joint_index("waist_yaw"))] = 0.4;
  estimate.angular_velocity[2] = 0.5;
  estimate.angular_velocity[0] = 0.1;
  update();
  EXPECT_TRUE(frames.angular_velocity_rad_per_s().isApprox(Eigen::Vector3d(0.1, 0.0, 0.1), 1e-12));
}

TEST_F(RobotFramesTest, BeginsAnewAfterAReset) {
  update();
  estimate.attitude[2] = 0.2;
  update(planned({5.0, 0.0, 0.0}, 0.0));
  frames.reset();
  EXPECT_FALSE(frames.known());
  EXPECT_TRUE(frames.odom_from_plan().isApprox(Eigen::Isometry3d::Identity()));
  update();
  EXPECT_TRUE(frames.odom_from_base().linear().isIdentity(1e-9));
}

}  // namespace
}  // namespace gaitway::api
