// Transforms, odometry, points and footsteps.
#include "gaitway/api/frame_messages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "humanoid.hpp"
#include "transform_tree.hpp"

namespace gaitway::api {
namespace {

using test::humanoid;
using test::TransformTree;

TEST(LinkTransformsMessage, PutsEveryLinkWhereForwardKinematicsHasIt) {
  std::mt19937 random(3);
  LinkTransforms transforms(humanoid());
  urdf::ForwardKinematics kinematics(humanoid());
  std::vector<double> position_rad;
  for (const urdf::Joint& joint : humanoid().joints) {
    position_rad.push_back(std::uniform_real_distribution(joint.lower_rad, joint.upper_rad)(random));
  }
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
  base.translation() = Eigen::Vector3d(1.0, -2.0, 0.3);
  base.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  transforms.fill(position_rad, &base, 42);
  kinematics.compute(position_rad);

  const TransformTree tree(transforms.message());
  EXPECT_EQ(transforms.message().transforms.size(), 1U + 22U + 2U);
  for (std::size_t link = 0; link < humanoid().links.size(); ++link) {
    const Eigen::Isometry3d expected = base * kinematics.link_pose(static_cast<int>(link));
    EXPECT_TRUE(tree.pose("odom", humanoid().links[link].name).isApprox(expected, 1e-9))
        << humanoid().links[link].name;
  }
  EXPECT_TRUE(tree.pose("odom", "left_sole").isApprox(base * kinematics.sole_pose(urdf::Side::left), 1e-9));
  EXPECT_TRUE(tree.pose("odom", "right_sole").isApprox(base * kinematics.sole_pose(urdf::Side::right), 1e-9));
  for (const ros::TransformStamped& transform : transforms.message().transforms) {
    EXPECT_EQ(transform.header.stamp.nanosec, 42U);
  }
}

TEST(LinkTransformsMessage, HasNoTwoFramesOfOneNameWhereALinkIsCalledLikeASole) {
  urdf::RobotModel robot = humanoid();
  robot.links[static_cast<std::size_t>(robot.feet[0].link)].name = "left_sole";
  EXPECT_EQ(sole_frame(robot, urdf::Side::left), "left_sole_frame");
  EXPECT_EQ(sole_frame(robot, urdf::Side::right), "right_sole");
  LinkTransforms transforms(robot);
  std::set<std::string> children;
  for (const ros::TransformStamped& transform : transforms.message().transforms) {
    EXPECT_TRUE(children.insert(transform.child_frame_id).second) << transform.child_frame_id;
  }
}

TEST(LinkTransformsMessage, LeavesOutWhereTheBaseIsWhenThatIsNotKnown) {
  LinkTransforms transforms(humanoid());
  const std::vector<double> position_rad(22, 0.0);
  const Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 2; ++i) {
    transforms.fill(position_rad, &base, 1);
    EXPECT_EQ(transforms.message().transforms.size(), 25U);
    transforms.fill(position_rad, nullptr, 2);
    EXPECT_EQ(transforms.message().transforms.size(), 24U);
    EXPECT_FALSE(TransformTree(transforms.message()).knows("pelvis"));
  }
}

TEST(OdometryMessage, IsTheBaseInOdomWithItsTwistInTheBase) {
  RobotFrames frames(humanoid());
  std::vector<double> position_rad;
  for (const urdf::Joint& joint : humanoid().joints) position_rad.push_back(joint.home_rad);
  Estimate estimate{};
  estimate.angular_velocity[1] = 0.25;
  frames.update(10, position_rad, std::vector<double>(22, 0.0), estimate, nullptr);
  estimate.attitude[2] = 0.2;
  frames.update(20, position_rad, std::vector<double>(22, 0.0), estimate, nullptr);
  ros::Odometry message = make_odometry(humanoid());
  fill(message, frames, 1'000'000'010);
  EXPECT_EQ(message.header.frame_id, "odom");
  EXPECT_EQ(message.child_frame_id, "pelvis");
  EXPECT_EQ(message.header.stamp.sec, 1);
  EXPECT_NEAR(message.pose.pose.position.z, 0.36, 1e-6);
  EXPECT_NEAR(message.pose.pose.orientation.z, std::sin(0.1), 1e-9);
  EXPECT_NEAR(message.pose.pose.orientation.w, std::cos(0.1), 1e-9);
  EXPECT_NEAR(message.twist.twist.angular.y, 0.25, 1e-9);
}

TEST(GroundPoint, OfTheSupportFrameIsPutIntoOdom) {
  Eigen::Isometry3d support = Eigen::Isometry3d::Identity();
  support.translation() = Eigen::Vector3d(2.0, 1.0, 0.0);
  support.linear() = Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  ros::PointStamped message = make_ground_point();
  fill(message, support, {0.1, 0.02, 0.3}, 5);
  EXPECT_EQ(message.header.frame_id, "odom");
  EXPECT_NEAR(message.point.x, 2.0 - 0.02, 1e-12);
  EXPECT_NEAR(message.point.y, 1.0 + 0.1, 1e-12);
  EXPECT_NEAR(message.point.z, 0.3, 1e-12);
}

class FootstepsTest : public ::testing::Test {
 protected:
  FootstepsTest() {
    planned.stamp_ns = 150;
    planned.footstep_count = 3;
    for (int i = 0; i < 3; ++i) {
      planned.footstep[i][0] = 0.1 * (i + 1);
      planned.footstep[i][1] = i % 2 == 0 ? 0.05 : -0.05;
      planned.footstep[i][2] = 0.2 * i;
    }
  }
  PlannedState planned{};
  Footsteps footsteps;
  const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
};

TEST_F(FootstepsTest, AreThoseThatArePlanned) {
  EXPECT_TRUE(footsteps.update(planned, here));
  const ros::PoseArray& message = footsteps.message();
  ASSERT_EQ(message.poses.size(), 3U);
  EXPECT_EQ(message.header.frame_id, "odom");
  EXPECT_EQ(message.header.stamp.nanosec, 150U);
  EXPECT_DOUBLE_EQ(message.poses[1].position.x, 0.2);
  EXPECT_DOUBLE_EQ(message.poses[1].position.y, -0.05);
  EXPECT_NEAR(message.poses[2].orientation.z, std::sin(0.2), 1e-12);
  EXPECT_NEAR(message.poses[2].orientation.w, std::cos(0.2), 1e-12);
}

TEST_F(FootstepsTest, ArePutIntoOdom) {
  Eigen::Isometry3d shift = Eigen::Isometry3d::Identity();
  shift.translation() = Eigen::Vector3d(1.0, 2.0, 0.0);
  shift.linear() = Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  EXPECT_TRUE(footsteps.update(planned, shift));
  const ros::Pose& first = footsteps.message().poses.at(0);
  EXPECT_NEAR(first.position.x, 1.0 - 0.05, 1e-12);
  EXPECT_NEAR(first.position.y, 2.0 + 0.1, 1e-12);
  EXPECT_NEAR(first.orientation.z, std::sin(M_PI / 4.0), 1e-12);
}

TEST_F(FootstepsTest, TellWhetherThePlanHasOtherOnes) {
  Eigen::Isometry3d moved = here;
  moved.translation().x() = 0.001;
  EXPECT_FALSE(footsteps.update({}, here)) << "none before, none now";
  EXPECT_TRUE(footsteps.update(planned, here));
  EXPECT_FALSE(footsteps.update(planned, moved)) << "the same in the plan";
  planned.footstep[2][1] += 1e-6;
  EXPECT_TRUE(footsteps.update(planned, here));
  planned.footstep_count = 1;
  EXPECT_TRUE(footsteps.update(planned, here)) << "two have landed";
  EXPECT_TRUE(footsteps.update({}, here));
  EXPECT_TRUE(footsteps.message().poses.empty());
}

}  // namespace
}  // namespace gaitway::api
