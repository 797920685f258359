// What stands in a maker's URDF becomes links and joints; what is left out is noted.
#include <numbers>

#include "maker_folder.hpp"

namespace gaitway::importer {
namespace {

using test::joint;
using test::link;
using test::MakerFolder;
using test::mass;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Key;
using testing::Optional;

constexpr double kRight_rad = 0.5 * std::numbers::pi;

MakerRobot hinge(const std::string& elements, const std::string& type = "revolute") {
  return MakerFolder().read_robot(link("a", mass(1.0)) + link("b", mass(1.0)) +
                                  joint("j", type, "a", "b", elements));
}

TEST(MakerUrdf, LinksAndJointsAreATreeInOrder) {
  const MakerRobot robot =
      MakerFolder().read("<robot name=\"walker\">\n" + joint("upper", "revolute", "body", "arm") +
                         joint("lower", "continuous", "arm", "hand") + link("hand") + link("arm") +
                         link("body", mass(3.0)) + "</robot>");
  EXPECT_EQ(robot.name, "walker");
  ASSERT_EQ(robot.links.size(), 3U);
  EXPECT_EQ(robot.links[0].name, "body");
  EXPECT_EQ(robot.links[0].parent_joint, -1);
  EXPECT_EQ(robot.links[0].line, 6);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    EXPECT_EQ(robot.joints[i].child_link, static_cast<int>(i) + 1);
    EXPECT_EQ(robot.links[i + 1].parent_joint, static_cast<int>(i));
    EXPECT_LE(robot.joints[i].parent_link, static_cast<int>(i));
  }
  EXPECT_EQ(robot.joint_index("lower"), 1);
  EXPECT_EQ(robot.joint_index("middle"), std::nullopt);
  EXPECT_THAT(robot.notes, IsEmpty());
}

TEST(MakerUrdf, ARobotWithoutANameIsCalledLikeItsFile) {
  EXPECT_EQ(MakerFolder().read("<robot>" + link("a") + "</robot>").name, "robot");
}

TEST(MakerUrdf, AFilesNameWithoutWhichARobotHasNoneIsOneLine) {
  const MakerFolder folder;
  const MakerRobot robot =
      read_maker_urdf(folder.write("new\nx: 1.urdf", "<robot>" + link("a") + "</robot>"), {});
  EXPECT_EQ(robot.name, "new\\x0Ax: 1");
}

TEST(MakerUrdf, ElementsOfOtherProgramsArePassedOver) {
  const MakerRobot robot = MakerFolder().read_robot(
      "<gazebo reference=\"a\"><mu1>0.2</mu1></gazebo><transmission name=\"t\"/><sensor/>" +
      link("a",
           "<self_collide>0</self_collide><collision_checking><capsule name=\"x\"/></collision_checking>"));
  EXPECT_THAT(robot.notes, IsEmpty());
}

TEST(MakerUrdf, InertiaIsTurnedIntoTheLinksAxes) {
  const MakerRobot robot = MakerFolder().read_robot(
      link("a",
           "<inertial><origin xyz=\"1 2 3\" rpy=\"0 0 1.5707963267948966\"/><mass value=\"2\"/>"
           "<inertia ixx=\"1\" ixy=\"0.25\" ixz=\"0\" iyy=\"2\" iyz=\"0\" izz=\"3\"/></inertial>"));
  Eigen::Matrix3d expected;
  expected << 2.0, -0.25, 0.0, -0.25, 1.0, 0.0, 0.0, 0.0, 3.0;
  EXPECT_TRUE(robot.links[0].inertia_kg_m2.isApprox(expected, 1e-12)) << robot.links[0].inertia_kg_m2;
  EXPECT_EQ(robot.links[0].com_m, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(robot.links[0].mass_kg, 2.0);
}

TEST(MakerUrdf, RollPitchYawTurnAboutFixedAxes) {
  const MakerRobot robot =
      hinge("<origin xyz=\"0 0 1\" rpy=\"1.5707963267948966 1.5707963267948966 0\"/><axis xyz=\"0 1 0\"/>");
  // Roll takes y to z, and pitch z to x.
  EXPECT_TRUE(
      (robot.joints[0].origin.linear() * robot.joints[0].axis).isApprox(Eigen::Vector3d::UnitX(), 1e-12));
}

TEST(MakerUrdf, ALinkWithoutInertialHasNoMass) {
  EXPECT_EQ(MakerFolder().read_robot(link("a")).links[0].mass_kg, 0.0);
}

TEST(MakerUrdf, AnAxisIsUnitAndXWithoutWord) {
  EXPECT_EQ(hinge("").joints[0].axis, Eigen::Vector3d::UnitX());
  EXPECT_EQ(hinge("<axis xyz=\"0 -20 0\"/>").joints[0].axis, -Eigen::Vector3d::UnitY());
}

TEST(MakerUrdf, LimitsAreWhatTheFileSays) {
  const MakerRobot robot = hinge(
      "<limit lower=\"-0.5\" upper=\"+1.\" velocity=\"6\" effort=\"1.2e2\"/>"
      "<dynamics damping=\"0.1\" friction=\".2\"/>");
  const MakerJoint& joint = robot.joints[0];
  EXPECT_THAT(joint.lower_rad, Optional(-0.5));
  EXPECT_THAT(joint.upper_rad, Optional(1.0));
  EXPECT_THAT(joint.velocity_rad_per_s, Optional(6.0));
  EXPECT_THAT(joint.effort_Nm, Optional(120.0));
  EXPECT_THAT(joint.damping_Nms_per_rad, Optional(0.1));
  EXPECT_THAT(joint.friction_Nm, Optional(0.2));
  EXPECT_THAT(robot.notes, IsEmpty());
}

TEST(MakerUrdf, ALimitThatIsMissingBesideAnotherIsZero) {
  const MakerJoint joint = hinge("<limit upper=\"2\"/>").joints[0];
  EXPECT_THAT(joint.lower_rad, Optional(0.0));
  EXPECT_THAT(joint.upper_rad, Optional(2.0));
}

void expect_no_limits(const MakerJoint& joint) {
  EXPECT_EQ(joint.lower_rad, std::nullopt);
  EXPECT_EQ(joint.upper_rad, std::nullopt);
  EXPECT_EQ(joint.velocity_rad_per_s, std::nullopt);
  EXPECT_EQ(joint.effort_Nm, std::nullopt);
  EXPECT_EQ(joint.damping_Nms_per_rad, std::nullopt);
  EXPECT_EQ(joint.friction_Nm, std::nullopt);
}

TEST(MakerUrdf, ZerosAreNoLimits) {
  expect_no_limits(hinge("").joints[0]);
  expect_no_limits(hinge("<limit lower=\"0\" upper=\"0\" velocity=\"0\" effort=\"0\"/>"
                         "<dynamics damping=\"0\" friction=\"0\"/>")
                       .joints[0]);
  expect_no_limits(hinge("<limit velocity=\"-1\" effort=\"-1\"/><dynamics damping=\"-1\"/>").joints[0]);
}

TEST(MakerUrdf, AContinuousJointHasNoEnds) {
  const MakerJoint joint = hinge("<limit lower=\"-1\" upper=\"1\" effort=\"2\"/>", "continuous").joints[0];
  EXPECT_EQ(joint.lower_rad, std::nullopt);
  EXPECT_EQ(joint.upper_rad, std::nullopt);
  EXPECT_THAT(joint.effort_Nm, Optional(2.0));
}

TEST(MakerUrdf, LimitsThatNoJointHasAreNoted) {
  const MakerRobot robot = hinge("<limit lower=\"-1e16\" upper=\"1e16\" velocity=\"1e308\" effort=\"1e9\"/>");
  expect_no_limits(robot.joints[0]);
  EXPECT_THAT(robot.notes, ElementsAre(AllOf(HasSubstr("j velocity 1e+308"), HasSubstr("j effort 1e+09"),
                                             HasSubstr("j lower -1e+16"), HasSubstr("j upper 1e+16"))));
}

TEST(MakerUrdf, FixedJointsAreMerged) {
  const MakerRobot robot = MakerFolder().read_robot(
      link("body", mass(1.0)) + link("sensor", mass(0.5)) + link("lens") +
      joint("s", "fixed", "body", "sensor", "<origin xyz=\"1 0 0\" rpy=\"0 0 1.5707963267948966\"/>") +
      joint("l", "fixed", "sensor", "lens", "<origin xyz=\"1 0 0\"/>"));
  ASSERT_EQ(robot.links.size(), 1U);
  EXPECT_DOUBLE_EQ(robot.links[0].mass_kg, 1.5);
  ASSERT_THAT(robot.links[0].frames, ElementsAre(Key("lens"), Key("sensor")));
  EXPECT_TRUE(robot.links[0].frames.at("lens").translation().isApprox(Eigen::Vector3d(1.0, 1.0, 0.0), 1e-12));
}

TEST(MakerUrdf, PrismaticAndMimickingJointsAreHeldStillAndNoted) {
  const MakerRobot robot = MakerFolder().read_robot(
      link("a", mass(1.0)) + link("b", mass(1.0)) + link("c", mass(1.0)) + link("d", mass(1.0)) +
      joint("turns", "revolute", "a", "b") +
      joint("slides", "prismatic", "b", "c", "<axis xyz=\"0 0 1\"/><mimic joint=\"turns\" offset=\"0.5\"/>") +
      joint("follows", "revolute", "b", "d",
            "<axis xyz=\"0 0 1\"/><mimic joint=\"turns\" multiplier=\"2\" offset=\"1.5707963267948966\"/>"));
  ASSERT_EQ(robot.joints.size(), 1U);
  const auto& frames = robot.links[1].frames;
  EXPECT_TRUE(frames.at("c").isApprox(Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.5)), 1e-12));
  EXPECT_TRUE(frames.at("d").linear().isApprox(
      Eigen::AngleAxisd(kRight_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix(), 1e-12));
  EXPECT_THAT(robot.notes, ElementsAre(AllOf(HasSubstr("Prismatic"), HasSubstr("slides")),
                                       AllOf(HasSubstr("mimic"), HasSubstr("follows"))));
}

TEST(MakerUrdf, ARootWithoutMassGivesWay) {
  for (const char* type : {"fixed", "floating", "planar"}) {
    const MakerRobot robot = MakerFolder().read_robot(
        link("world") + link("base") + link("pelvis", mass(1.0)) + link("leg", mass(1.0)) +
        joint("free", type, "world", "base", "<origin xyz=\"0 0 9\"/>") +
        joint("waist", "fixed", "base", "pelvis", "<origin xyz=\"0 0 1\"/>") +
        joint("hip", "revolute", "pelvis", "leg", "<origin xyz=\"0 0 -2\"/>"));
    ASSERT_EQ(robot.links.size(), 2U) << type;
    EXPECT_EQ(robot.links[0].name, "pelvis");
    EXPECT_EQ(robot.links[0].parent_joint, -1);
    EXPECT_EQ(robot.joints[0].parent_link, 0);
    EXPECT_EQ(link_poses(robot, {0.0})[1].translation(), Eigen::Vector3d(0.0, 0.0, -2.0));
    EXPECT_EQ(robot.links[0].frames.at("base").translation(), Eigen::Vector3d(0.0, 0.0, -1.0));
    EXPECT_THAT(robot.notes, ElementsAre(HasSubstr("'world' has no mass and gives way to 'base'"),
                                         HasSubstr("'base' has no mass and gives way to 'pelvis'")));
  }
}

TEST(MakerUrdf, ARootWithMassOrSeveralLinksStays) {
  const std::string pelvis = link("pelvis", mass(1.0)) + joint("waist", "fixed", "base", "pelvis");
  EXPECT_EQ(MakerFolder().read_robot(link("base", mass(1.0)) + pelvis).links[0].name, "base");
  EXPECT_EQ(MakerFolder()
                .read_robot(link("base") + pelvis + link("imu") + joint("i", "fixed", "base", "imu"))
                .links[0]
                .name,
            "base");
}

TEST(MakerUrdf, ColoursAreTheVisualsOrTheMaterialsThatItNames) {
  const std::string box = "<geometry><box size=\"1 1 1\"/></geometry>";
  const MakerRobot robot = MakerFolder().read_robot(
      "<material name=\"red\"><color rgba=\"1 0 0 1\"/></material>" +
      link("a", "<visual>" + box + "<material name=\"red\"/></visual><visual>" + box +
                    "<material name=\"blue\"><color rgba=\"0 0 1 0.5\"/></material></visual><visual>" + box +
                    "<material name=\"blue\"/></visual><visual>" + box + "</visual>"));
  ASSERT_EQ(robot.links[0].visual.size(), 4U);
  EXPECT_EQ(robot.links[0].visual[0].rgba, Eigen::Vector4d(1.0, 0.0, 0.0, 1.0));
  EXPECT_EQ(robot.links[0].visual[1].rgba, Eigen::Vector4d(0.0, 0.0, 1.0, 0.5));
  EXPECT_EQ(robot.links[0].visual[2].rgba, Eigen::Vector4d(0.0, 0.0, 1.0, 0.5));
  EXPECT_EQ(robot.links[0].visual[3].rgba, VisualSurface{}.rgba);
}

TEST(MakerUrdf, NotesHoldNothingThatATerminalObeys) {
  const MakerRobot robot = MakerFolder().read_robot(
      link("a", "<visual><geometry><mesh filename=\"m\x1B[2J.stl\"/></geometry></visual>"));
  EXPECT_THAT(robot.notes, ElementsAre(HasSubstr("m\\x1B[2J.stl")));
}

}  // namespace
}  // namespace gaitway::importer
