// What each joint of the body does, whatever it is called and wherever it stands in the description.
#include "gaitway/urdf/body_joints.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "robots/robot_variants.hpp"

namespace gaitway::urdf {
namespace {

const std::map<std::string, std::string> kWhatJointsDo{{"left_hip_yaw", "left hip yaw"},
                                                       {"right_knee", "right knee"},
                                                       {"left_ankle_roll", "left ankle roll"},
                                                       {"waist_yaw", "waist yaw"},
                                                       {"waist_pitch", "waist pitch"},
                                                       {"neck_yaw", "neck yaw"},
                                                       {"neck_pitch", "neck pitch"},
                                                       {"left_shoulder_pitch", "left shoulder pitch"},
                                                       {"right_shoulder_roll", "right shoulder roll"},
                                                       {"left_elbow", "left elbow pitch"},
                                                       {"right_elbow", "right elbow pitch"}};

std::string what_does(const RobotModel& robot, int joint) {
  return describe(BodyJoints(robot, ForwardKinematics(robot)).role(joint));
}

TEST(BodyJoints, TellWhatHumanoid22sJointsDo) {
  const gaitway::test::RobotVariant variant;
  const RobotModel robot = load_robot(variant.folder());
  for (const auto& [joint, what] : kWhatJointsDo) EXPECT_EQ(what_does(robot, robot.joint_index(joint)), what);
  std::set<std::string> all;
  for (int j = 0; j < static_cast<int>(robot.joints.size()); ++j) all.insert(what_does(robot, j));
  EXPECT_EQ(all.size(), robot.joints.size()) << "no two do the same";
}

TEST(BodyJoints, GoByNoName) {
  gaitway::test::RobotVariant variant;
  variant.rename();
  const RobotModel robot = load_robot(variant.folder());
  for (const auto& [joint, what] : kWhatJointsDo) {
    EXPECT_EQ(what_does(robot, robot.joint_index(gaitway::test::RobotVariant::renamed(joint))), what);
  }
}

TEST(BodyJoints, FollowAHipOfAnotherOrder) {
  for (const std::vector<std::size_t>& order : gaitway::test::kHipOrders) {
    gaitway::test::RobotVariant variant;
    variant.reorder(gaitway::test::kHip, order);
    const RobotModel robot = load_robot(variant.folder());
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string turns = gaitway::test::kHip[order[i]].substr(4);
      EXPECT_EQ(what_does(robot, robot.joint_index("left_" + gaitway::test::kHip[i])), "left hip " + turns);
    }
  }
}

TEST(BodyJoints, HaveMirrorImages) {
  const gaitway::test::RobotVariant variant;
  const RobotModel robot = load_robot(variant.folder());
  const ForwardKinematics home(robot);
  const BodyJoints body(robot, home);
  const auto mirrored = [&](const std::string& name) {
    return robot.joints[static_cast<std::size_t>(body.mirrored(robot.joint_index(name)).value())].name;
  };
  EXPECT_EQ(mirrored("left_shoulder_roll"), "right_shoulder_roll");
  EXPECT_EQ(mirrored("right_knee"), "left_knee");
  EXPECT_EQ(mirrored("waist_yaw"), "waist_yaw");
  const auto angle_rad = [&](const std::string& from, const std::string& to) {
    return mirror_angle(robot, home, robot.joint_index(from), robot.joint_index(to)).value().of(0.5);
  };
  EXPECT_EQ(angle_rad("left_shoulder_roll", "right_shoulder_roll"), -0.5);
  EXPECT_EQ(angle_rad("left_elbow", "right_elbow"), 0.5);
  EXPECT_EQ(angle_rad("waist_yaw", "waist_yaw"), -0.5);
  EXPECT_FALSE(
      mirror_angle(robot, home, robot.joint_index("left_elbow"), robot.joint_index("right_hip_yaw")));
}

// A joint that twists the arm at the elbow: the upper arm begins before it.
TEST(BodyJoints, TakeTheUpperArmFromTheShoulder) {
  const gaitway::test::RobotVariant variant;
  RobotModel robot = load_robot(variant.folder());
  Joint& roll = robot.joints[static_cast<std::size_t>(robot.joint_index("left_shoulder_roll"))];
  Joint& elbow = robot.joints[static_cast<std::size_t>(robot.joint_index("left_elbow"))];
  const int pitch = robot.joint_index("left_shoulder_pitch");
  std::swap(roll.origin, elbow.origin);
  roll.axis = Eigen::Vector3d::UnitZ();
  roll.home_rad = 0.0;
  const BodyJoints body(robot, ForwardKinematics(robot));
  EXPECT_NEAR(body.limb_at_home_rad(pitch), robot.joints[static_cast<std::size_t>(pitch)].home_rad, 1e-9);
}

// Upper arms that twist in the middle, forearms that are held ahead: no twist is an elbow.
TEST(BodyJoints, KnowTheElbowFromATwistBeforeIt) {
  const gaitway::test::RobotVariant variant;
  RobotModel robot = load_robot(variant.folder());
  const int roll = robot.joint_index("left_shoulder_roll"), elbow = robot.joint_index("left_elbow");
  Joint& twist = robot.joints[static_cast<std::size_t>(roll)];
  twist.axis = Eigen::Vector3d::UnitZ();
  twist.origin.translation().z() = -0.07;
  twist.home_rad = 0.0;
  robot.joints[static_cast<std::size_t>(elbow)].origin.translation().z() = -0.07;
  robot.joints[static_cast<std::size_t>(elbow)].home_rad = -1.5;
  EXPECT_EQ(what_does(robot, roll), "left shoulder yaw");
  EXPECT_EQ(what_does(robot, elbow), "left elbow pitch");
}

TEST(BodyJoints, OfARobotWithoutArmsAreLegsWaistAndNeck) {
  gaitway::test::RobotVariant variant;
  variant.remove_arms();
  const RobotModel robot = load_robot(variant.folder());
  EXPECT_EQ(robot.joints.size(), 16U);
  const BodyJoints body(robot, ForwardKinematics(robot));
  EXPECT_TRUE(body.arm(Side::left).empty());
  EXPECT_EQ(what_does(robot, robot.joint_index("waist_pitch")), "waist pitch");
  EXPECT_EQ(what_does(robot, robot.joint_index("neck_yaw")), "neck yaw");
  EXPECT_FALSE(body.find({BodyPart::left_arm, JointPlace::elbow, Turn::pitch, 0}));
}

}  // namespace
}  // namespace gaitway::urdf
