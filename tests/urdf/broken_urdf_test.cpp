// Every way in which robot.urdf can be wrong is refused with file, line, field, value, rule and remedy.
#include "broken_robot.hpp"

namespace gaitway::urdf {
namespace {

using test::BrokenRobot;
using test::kNetworkFile;

constexpr const char* kUrdf = "robot.urdf";
constexpr const char* kLeftKnee = "<joint name=\"left_knee\"";
constexpr const char* kLeftThigh = "<link name=\"left_thigh\"";

TEST(BrokenUrdf, AnUndamagedCopyLoads) {
  EXPECT_EQ(BrokenRobot().complaint(), "(loaded without complaint)");
}

TEST(BrokenUrdf, MissingFileIsNamed) {
  const BrokenRobot robot;
  robot.remove(kUrdf);
  robot.expect_complaint({"robot.urdf: the file is missing or cannot be read"});
}

TEST(BrokenUrdf, MalformedXmlIsToldWithItsLine) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftThigh, "</inertial>", "</inertia>");
  robot.expect_complaint({robot.line_of(kUrdf, "</inertia>"), "column", "malformed XML"});
}

TEST(BrokenUrdf, TextThatIsNoUrdfIsRefused) {
  const BrokenRobot robot;
  robot.write(kUrdf, "<sdf/>");
  robot.expect_complaint({"robot.urdf:1: ", "the outermost element must be <robot>"});
}

std::string nested(const std::string& open, int levels, const std::string& close) {
  std::string text;
  for (int i = 0; i < levels; ++i) text += open;
  for (int i = 0; i < levels; ++i) text += close;
  return text;
}

TEST(BrokenUrdf, ElementsNestedTooDeepAreRefusedBeforeTheParserMeetsThem) {
  const std::string tail = "</robot>";
  // A tag in quotes, in a comment or behind a declaration closes nothing.
  for (const char* const open : {"<a>", "<a b=\"/>\">", "<a b='</a>'>", "<a><!-- </a> -->", "<a><!--></a>-->",
                                 "<a><![CDATA[</a>]]>", "<_>"}) {
    const BrokenRobot robot;
    robot.write(kUrdf, "<robot name=\"x\">\n" + nested(open, 100'000, "</a>") + tail);
    robot.expect_complaint({"robot.urdf:2: ", "must not be nested more than 32 deep"});
  }
  const BrokenRobot declared;
  declared.write(kUrdf, "<?xml version='\"' encoding=\"><!--\"?>" + nested("<a>", 100'000, "</a>"));
  declared.expect_complaint({"robot.urdf:1: ", "'>' stands between quotes"});
}

TEST(BrokenUrdf, ManyElementsSideBySideAreNoNesting) {
  BrokenRobot robot;
  std::string comments;
  for (int i = 0; i < 1000; ++i) comments += "<!-- <link> -->\n";
  robot.replace(kUrdf, kLeftThigh, comments + kLeftThigh);
  EXPECT_EQ(robot.complaint(), "(loaded without complaint)");
}

TEST(BrokenUrdf, FilesOfManyMegabytesAreRefusedByName) {
  const BrokenRobot urdf;
  urdf.write(kUrdf, "<!-- " + std::string(5'000'000, 'x') + " -->");
  urdf.expect_complaint({"robot.urdf: the file is larger than 4 MiB"});
  const BrokenRobot yaml;
  yaml.write(kNetworkFile, "# " + std::string(5'000'000, 'x'));
  yaml.expect_complaint({"robot.yaml: the file is larger than 4 MiB"});
}

TEST(BrokenUrdf, ADoctypeIsToldAsSuch) {
  BrokenRobot robot;
  robot.replace(kUrdf, "<robot ", "<!DOCTYPE robot [<!ENTITY half \"0.5\">]>\n<robot ");
  robot.expect_complaint({robot.line_of(kUrdf, "<!DOCTYPE"), "a URDF has no DOCTYPE"});
}

TEST(BrokenUrdf, ADecimalCommaIsTold) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftThigh, "mass value=\"0.45\"", "mass value=\"0,45\"");
  robot.expect_complaint({"'0,45': must be a number with a decimal point, not with a comma"});
}

TEST(BrokenUrdf, MisspeltElementNamesTheNearest) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftThigh, "<mass value=\"0.45\"/>", "<mas value=\"0.45\"/>");
  robot.expect_complaint({robot.line_of(kUrdf, "<mas "), "link 'left_thigh' inertial = <mas>",
                          "there is no such element", "Did you mean 'mass'?"});
}

TEST(BrokenUrdf, MisspeltAttributeNamesTheNearest) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftKnee, "velocity=", "velocty=");
  robot.expect_complaint({robot.line_of(kUrdf, "velocty="), "joint 'left_knee' limit velocty = '8'",
                          "Did you mean 'velocity'?"});
}

TEST(BrokenUrdf, MissingAttributeAndElementAreNamed) {
  BrokenRobot attribute;
  attribute.replace(kUrdf, kLeftKnee, " effort=\"8\"", "");
  attribute.expect_complaint({"joint 'left_knee' limit: the attribute 'effort' is missing"});
  BrokenRobot element;
  element.replace(kUrdf, kLeftKnee, "<axis xyz=\"0 1 0\"/>", "");
  element.expect_complaint(
      {element.line_of(kUrdf, kLeftKnee), "joint 'left_knee': the element <axis> is missing"});
}

TEST(BrokenUrdf, WordsInPlaceOfNumbersAreRefused) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftKnee, "xyz=\"0 0 -0.17\"", "xyz=\"0 0\"");
  robot.expect_complaint(
      {robot.line_of(kUrdf, "xyz=\"0 0\""), "joint 'left_knee' origin xyz = '0 0'", "must be 3 numbers"});
  BrokenRobot word;
  word.replace(kUrdf, kLeftThigh, "mass value=\"0.45\"", "mass value=\"0.45kg\"");
  word.expect_complaint({word.line_of(kUrdf, "0.45kg"), "'0.45kg': must be a number"});
}

TEST(BrokenUrdf, SameNameTwiceIsRefused) {
  BrokenRobot robot;
  robot.replace(kUrdf, "<joint name=\"right_knee\"", kLeftKnee);
  robot.expect_complaint({"joint 'left_knee': the name is taken already in line"});
}

TEST(BrokenUrdf, UnknownParentLinkIsToldInOneMessage) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftKnee, "parent link=\"left_thigh\"", "parent link=\"left_tigh\"");
  robot.expect_complaint({"robot.urdf: not a valid URDF: ", "left_tigh"});
}

TEST(BrokenUrdf, MassMustBePositive) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftThigh, "mass value=\"0.45\"", "mass value=\"-0.45\"");
  robot.expect_complaint(
      {robot.line_of(kUrdf, kLeftThigh), "link 'left_thigh' mass = -0.45 kg: must be above 0", "kilograms"});
}

TEST(BrokenUrdf, InertiaMustBePositiveDefinite) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftThigh, "ixy=\"0\"", "ixy=\"0.5\"");
  robot.expect_complaint(
      {robot.line_of(kUrdf, kLeftThigh), "link 'left_thigh' inertia", "positive definite"});
}

TEST(BrokenUrdf, InertiaMustObeyTheTriangleInequality) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftThigh, "izz=\"", "izz=\"1");
  robot.expect_complaint({"link 'left_thigh' inertia", "never less than the third"});
}

TEST(BrokenUrdf, LengthsInMillimetresAreNoticed) {
  BrokenRobot joint;
  joint.replace(kUrdf, kLeftKnee, "xyz=\"0 0 -0.17\"", "xyz=\"0 0 -170\"");
  joint.expect_complaint({joint.line_of(kUrdf, kLeftKnee), "joint 'left_knee' origin = 170", "in metres"});
  BrokenRobot box;
  box.replace(kUrdf, kLeftThigh, "box size=\"0.06 0.06 0.11\"", "box size=\"60 60 110\"");
  box.expect_complaint({"link 'left_thigh' visual = 60 x 60 x 110 m", "in metres"});
}

TEST(BrokenUrdf, LimitsInDegreesAreNoticed) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftKnee, "upper=\"2.3\"", "upper=\"132\"");
  robot.expect_complaint({robot.line_of(kUrdf, kLeftKnee), "joint 'left_knee' limit upper = 132", "-pi..pi",
                          "Write radians, not degrees"});
}

TEST(BrokenUrdf, LimitsMustBeInOrder) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftKnee, "upper=\"2.3\"", "upper=\"-0.1\"");
  robot.expect_complaint({"joint 'left_knee' limit lower = 0: must be below upper = -0.1"});
}

TEST(BrokenUrdf, AxisMustBeAUnitVector) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftKnee, "axis xyz=\"0 1 0\"", "axis xyz=\"0 2 0\"");
  robot.expect_complaint({"joint 'left_knee' axis length = 2: must be 1"});
}

TEST(BrokenUrdf, JointWithoutMotorIsRefused) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftKnee, "type=\"revolute\"", "type=\"fixed\"");
  robot.expect_complaint(
      {robot.line_of(kUrdf, kLeftKnee), "joint 'left_knee' type: must be 'revolute'", "merge the link"});
}

TEST(BrokenUrdf, ReferenceMustNotBeFasterThanTheMotor) {
  BrokenRobot robot;
  robot.replace(kUrdf, kLeftKnee, "velocity=\"8\"", "velocity=\"9\"");
  robot.expect_complaint({robot.line_of(kUrdf, kLeftKnee), "joint 'left_knee' limit velocity = 9 rad/s",
                          "the motor reaches 8 rad/s"});
}

TEST(BrokenUrdf, JointWithoutControllerNamesTheNearest) {
  BrokenRobot robot;
  robot.replace(kNetworkFile, "  - {name: right_elbow,          node: 22, home_deg: -30}\n", "");
  robot.expect_complaint({robot.line_of(kUrdf, "<joint name=\"right_elbow\""), "'right_elbow'",
                          "no local controller in robot.yaml", "Nearest name there: 'left_elbow'"});
}

}  // namespace
}  // namespace gaitway::urdf
