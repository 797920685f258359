// Postures of a fall: as a robot's folder gives them, or the crouch of a robot whose folder says nothing.
#include "gaitway/trajectory/fall_posture_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include "gaitway/trajectory/fall_posture.hpp"
#include "robots/robot_variants.hpp"

namespace gaitway::trajectory {
namespace {

using test::RobotVariant;
using ::testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180.0;

double angle_deg(const urdf::RobotModel& robot, const FallPostures& postures, FallDirection direction,
                 const std::string& joint) {
  return postures[static_cast<std::size_t>(direction)][static_cast<std::size_t>(robot.joint_index(joint))] /
         kDegree;
}

void write_postures(const RobotVariant& variant, const std::string& text) {
  std::ofstream(variant.folder() / kFallPostureFile) << text;
}

std::string complaint_about(const std::string& text) {
  const RobotVariant variant;
  write_postures(variant, text);
  try {
    static_cast<void>(fall_postures_of(urdf::load_robot(variant.folder())));
  } catch (const urdf::RobotError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(FallPostureFile, BelongsToTheRobotAndNamesItsOwnJoints) {
  RobotVariant variant;
  variant.rename();
  write_postures(variant, "ahead: {symmetric: {" + RobotVariant::renamed("left_shoulder_roll") + ": 40}}\n" +
                              "back: {joints: {" + RobotVariant::renamed("waist_pitch") + ": 20}}\n" +
                              "left: {joints: {" + RobotVariant::renamed("waist_yaw") + ": 50, " +
                              RobotVariant::renamed("left_elbow") + ": -70}}\n");
  const urdf::RobotModel robot = urdf::load_robot(variant.folder());
  const FallPostures postures = fall_postures_of(robot).value();
  const auto of = [&](FallDirection direction, const std::string& joint) {
    return angle_deg(robot, postures, direction, RobotVariant::renamed(joint));
  };
  EXPECT_NEAR(of(FallDirection::ahead, "left_shoulder_roll"), 40.0, 1e-9);
  EXPECT_NEAR(of(FallDirection::ahead, "right_shoulder_roll"), -40.0, 1e-9);
  EXPECT_NEAR(of(FallDirection::back, "waist_pitch"), 20.0, 1e-9);
  EXPECT_TRUE(std::isnan(of(FallDirection::back, "left_knee"))) << "it stays where it is";
  EXPECT_NEAR(of(FallDirection::left, "waist_yaw"), 50.0, 1e-9);
  EXPECT_NEAR(of(FallDirection::right, "waist_yaw"), -50.0, 1e-9) << "the mirror image";
  EXPECT_NEAR(of(FallDirection::right, "right_elbow"), -70.0, 1e-9);
  EXPECT_TRUE(std::isnan(of(FallDirection::right, "left_elbow")));
}

TEST(FallPostureFile, NamesWhatIsWrongWithIt) {
  EXPECT_THAT(complaint_about("ahead: {}\nback: {}\n"), HasSubstr("left"));
  EXPECT_THAT(complaint_about("ahead: {joints: {left_kne: 3}}\nback: {}\nleft: {}\n"),
              HasSubstr("Did you mean 'left_knee'?"));
  EXPECT_THAT(complaint_about("ahead: {}\nback: {}\nleft: {symmetric: {waist_yaw: 3}}\n"),
              HasSubstr("waist_yaw is of no left limb"));
  EXPECT_THAT(complaint_about("ahead: {}\nback: {joints: {left_knee: 160}}\nleft: {}\n"),
              HasSubstr("left_knee turns from 0.0 to 131.8 deg"));
}

// Whatever the hip's order and the joints' names.
TEST(OwnPostures, BringArmsToWhereTheRobotFallsAndBendItsKnees) {
  RobotVariant variant;
  variant.reorder(test::kHip, {2, 0, 1});  // pitch, yaw, roll
  variant.rename();
  const urdf::RobotModel robot = urdf::load_robot(variant.folder());
  const FallPostures postures = fall_postures_of(robot).value();
  const auto of = [&](FallDirection direction, const std::string& joint) {
    return angle_deg(robot, postures, direction, RobotVariant::renamed(joint));
  };
  for (const std::string side : {"left_", "right_"}) {
    EXPECT_NEAR(of(FallDirection::ahead, side + "shoulder_pitch"), -90.0, 0.1);
    EXPECT_NEAR(of(FallDirection::back, side + "shoulder_pitch"), 60.0, 0.1);
    EXPECT_NEAR(of(FallDirection::back, side + "knee"), 95.0, 0.1);
    EXPECT_NEAR(of(FallDirection::ahead, side + "hip_yaw"), -20.0, 0.1) << "it pitches here";
    EXPECT_TRUE(std::isnan(of(FallDirection::ahead, side + "hip_roll"))) << "it turns about the leg here";
  }
  EXPECT_NEAR(of(FallDirection::left, "waist_yaw"), 60.0, 0.1);
  EXPECT_NEAR(of(FallDirection::right, "waist_yaw"), -60.0, 0.1);
  EXPECT_NEAR(of(FallDirection::left, "right_elbow"), -115.0, 0.1);
  EXPECT_NEAR(of(FallDirection::right, "left_elbow"), -115.0, 0.1);
  EXPECT_TRUE(std::isnan(of(FallDirection::ahead, "neck_yaw"))) << "it stays where it is";
}

TEST(OwnPostures, StayWithinTheStops) {
  const RobotVariant variant;
  urdf::RobotModel robot = urdf::load_robot(variant.folder());
  const auto knee = static_cast<std::size_t>(robot.joint_index("left_knee"));
  robot.joints[knee].upper_rad = 50.0 * kDegree;
  EXPECT_LE(own_postures(robot).value()[0][knee], 50.0 * kDegree - 0.009);
}

TEST(OwnPostures, AreNoneWithoutArms) {
  RobotVariant variant;
  variant.remove_arms();
  const urdf::RobotModel robot = urdf::load_robot(variant.folder());
  EXPECT_FALSE(own_postures(robot));
  EXPECT_FALSE(FallPosture(robot).exists());
}

}  // namespace
}  // namespace gaitway::trajectory
