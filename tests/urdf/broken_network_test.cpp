// Every way in which robot.yaml can be wrong is refused with file, line, field, value, rule and remedy.
#include "broken_robot.hpp"

namespace gaitway::urdf {
namespace {

using test::BrokenRobot;
using test::kNetworkFile;

// One replacement and all that the complaint must hold; the complaint must name the changed line.
void expect_refused(const std::string& before, const std::string& after, std::vector<std::string> parts) {
  BrokenRobot robot;
  robot.replace(kNetworkFile, before, after);
  parts.push_back(robot.line_of(kNetworkFile, after));
  robot.expect_complaint(parts);
}

TEST(BrokenNetwork, MissingFileIsNamed) {
  const BrokenRobot robot;
  robot.remove(kNetworkFile);
  robot.expect_complaint({"robot.yaml: the file is missing or cannot be read"});
}

TEST(BrokenNetwork, MalformedYamlIsToldWithLineAndColumn) {
  BrokenRobot robot;
  robot.replace(kNetworkFile, "node: 3, ", "node: 3]");
  robot.expect_complaint({robot.line_of(kNetworkFile, "node: 3]"), "column ", "malformed YAML"});
}

TEST(BrokenNetwork, AnEmptyFileIsRefused) {
  const BrokenRobot robot;
  robot.write(kNetworkFile, "");
  robot.expect_complaint({"robot.yaml", "must be a map"});
}

TEST(BrokenNetwork, UnknownKeyNamesTheNearest) {
  expect_refused("{name: left_knee,            node: 4", "{name: left_knee,            nod: 4",
                 {"joints[3] key = 'nod': there is no such key", "Did you mean 'node'?"});
  expect_refused("trim: {count", "trims: {count", {"Did you mean 'trim'?"});
  expect_refused("{profile: full}", "{profile: full, revision_slot: 4}",
                 {"network key = 'revision_slot': there is no such key"});
}

TEST(BrokenNetwork, KeyThatStandsTwiceIsRefused) {
  expect_refused("node: 4, ", "node: 4, node: 5, ", {"= 'node': the key stands here twice"});
}

TEST(BrokenNetwork, MissingKeyIsNamed) {
  expect_refused("{name: left_knee,            node: 4, ", "{name: left_knee, ",
                 {"joints[3]: the key 'node' is missing"});
}

TEST(BrokenNetwork, WrongTypesAreRefused) {
  expect_refused("count_deg: 0.05  ", "count_deg: small", {"defaults.count_deg = 'small': must be a number"});
  expect_refused("node: 5,", "node: 5.5,", {"joints[4].node = '5.5': must be a whole number"});
  expect_refused("servo: {stiffness_Nm_per_rad: 300, damping_Nms_per_rad: 4}", "servo: 300",
                 {"defaults.servo = '300': must be a map"});
  expect_refused("size_m: [0.135, 0.085]", "size_m: [0.135]",
                 {"feet.left.size_m = a list of 1: must be a list of 2"});
}

TEST(BrokenNetwork, ImplausibleValuesAreRefused) {
  expect_refused("count_deg: 0.05  ", "count_deg: 5",
                 {"defaults.count_deg = '5': must be 0.001..0.5 deg", "Check the unit"});
  expect_refused("stiffness_Nm_per_rad: 300", "stiffness_Nm_per_rad: -300",
                 {"defaults.servo.stiffness_Nm_per_rad = '-300'"});
  expect_refused("physics_step_s: 0.001", "physics_step_s: 1", {"simulation.physics_step_s = '1'"});
  expect_refused("parts: 1", "parts: -1", {"simulation.parts = '-1': must be 0..5"});
  expect_refused("inclinometer: pendulum", "inclinometer: pendulm",
                 {"imu.inclinometer = 'pendulm': must be fused or pendulum", "gyro of its own"});
  expect_refused("friction: 0.8", "friction: .nan",
                 {"simulation.contact.friction = '.nan': must be a number"});
  expect_refused("encoder_counts_per_turn: 200000", "encoder_counts_per_turn: 36",
                 {"defaults.encoder_counts_per_turn = '36': must be 256.."});
}

TEST(BrokenNetwork, EncoderMustBeFinerThanACount) {
  BrokenRobot robot;
  robot.replace(kNetworkFile, "encoder_counts_per_turn: 200000", "encoder_counts_per_turn: 2048");
  robot.expect_complaint({"defaults", "the encoder's step of 0.175781 deg", "a count of 0.05 deg"});
}

TEST(BrokenNetwork, NodeMustBeInRange) {
  expect_refused("node: 22,", "node: 65,", {"joints[21].node = '65': must be 1..64"});
  expect_refused("node: 22,", "node: 0,", {"joints[21].node = '0': must be 1..64"});
}

TEST(BrokenNetwork, TwoJointsMustNotShareAController) {
  expect_refused(
      "right_knee,           node: 10", "right_knee,           node: 4",
      {"joints[9].node = '4': controller 4 is taken by joint 'left_knee' already", "'right_knee'"});
}

TEST(BrokenNetwork, AJointMustNotHaveTwoControllers) {
  expect_refused(
      "{name: right_knee,           node: 10", "{name: left_knee,           node: 10",
      {"joints[9].name = 'left_knee'", "taken by joint 'left_knee' already", "List each joint once"});
}

TEST(BrokenNetwork, TwoJointsMustNotShareATrimChannel) {
  expect_refused(
      "right_cell_rear_right], trim_channel: 7", "right_cell_rear_right], trim_channel: 6",
      {"joints[11].trim_channel = '6': trim channel 6 is taken by joint 'left_ankle_roll' already"});
  expect_refused("trim_channel: 7", "trim_channel: 8", {"must be 0..7"});
}

TEST(BrokenNetwork, SensorChannelMustBeCarriedOnce) {
  expect_refused(
      "[right_cell_rear_left, right", "[left_cell_rear_left, right",
      {"joints[11].channels[0] = 'left_cell_rear_left'", "is taken by joint 'left_ankle_roll' already"});
  BrokenRobot missing;
  missing.replace(kNetworkFile, "[right_cell_rear_left,", "[none,");
  missing.expect_complaint(
      {"robot.yaml:", "joints", "'right_cell_rear_left' is carried by no joint", "Add it"});
}

TEST(BrokenNetwork, UnknownSensorChannelNamesTheNearest) {
  expect_refused("angular_velocity_z", "angular_velosity_z",
                 {"joints[1].channels[0] = 'angular_velosity_z'", "Did you mean 'angular_velocity_z'?"});
}

TEST(BrokenNetwork, JointThatTheUrdfLacksNamesTheNearest) {
  expect_refused("{name: left_knee,", "{name: left_nee,",
                 {"joint name = 'left_nee'", "no such joint in robot.urdf", "Did you mean 'left_knee'?"});
}

TEST(BrokenNetwork, ChildBeforeItsParentIsRefused) {
  BrokenRobot robot;
  const std::string yaw = "  - {name: neck_yaw,             node: 15}\n";
  const std::string pitch = "  - {name: neck_pitch,           node: 16}\n";
  robot.replace(kNetworkFile, yaw + pitch, pitch + yaw);
  robot.expect_complaint({robot.line_of(kNetworkFile, "{name: neck_pitch"), "'neck_pitch'",
                          "parents come before children", "'neck'"});
}

TEST(BrokenNetwork, HomeMustLieWithinTheLimits) {
  expect_refused("node: 22, home_deg: -30", "node: 22, home_deg: 30",
                 {"joint 'right_elbow' home_deg = 30", "must lie within the URDF's limits -131.78..0 deg"});
}

TEST(BrokenNetwork, VelocityLimitMustFitAByte) {
  BrokenRobot robot;
  robot.replace(kNetworkFile, "count_deg: 0.05  ", "count_deg: 0.03  ");
  robot.expect_complaint({robot.line_of("robot.urdf", "<joint name=\"left_hip_yaw\""),
                          "joint 'left_hip_yaw' limit velocity = 8 rad/s", "a signed byte of 0.03 deg",
                          "6.65 rad/s", "count_deg"});
}

TEST(BrokenNetwork, TrimLimitMustFitAByte) {
  expect_refused("limit_deg: 6.35", "limit_deg: 6.4",
                 {"trim.limit_deg = '6.4'", "127 counts of 0.05 deg = 6.35 deg"});
}

TEST(BrokenNetwork, MotorMustNotExceedTheEffortLimit) {
  BrokenRobot robot;
  robot.replace(kNetworkFile, "node: 4, ", "node: 4, motor: {torque_limit_Nm: 12}, ");
  robot.expect_complaint({robot.line_of(kNetworkFile, "torque_limit_Nm: 12"),
                          "joint 'left_knee' torque_limit_Nm = 12", "the URDF's effort limit is 8 N·m",
                          "Make the two agree"});
}

TEST(BrokenNetwork, FootLinkMustExist) {
  expect_refused("{link: left_foot", "{link: left_fot",
                 {"feet.left.link = 'left_fot': there is no such link", "Did you mean 'left_foot'?"});
}

TEST(BrokenNetwork, FootMustEndItsLeg) {
  expect_refused("{link: left_foot", "{link: right_foot",
                 {"feet.left.link = 'right_foot': the leg ends at the link 'left_foot'"});
}

TEST(BrokenNetwork, ImuLinkMustExist) {
  expect_refused("{link: trunk", "{link: trank", {"imu.link = 'trank'", "Did you mean 'trunk'?"});
}

TEST(BrokenNetwork, LegMustHaveSixJointsInAChain) {
  expect_refused("left: [left_hip_yaw, left_hip_roll,", "left: [left_hip_roll,",
                 {"legs.left = a list of 5: a leg has six joints"});
  expect_refused("left: [left_hip_yaw, left_hip_roll,", "left: [left_hip_roll, left_hip_yaw,",
                 {"legs.left[0] = 'left_hip_roll': must hang on the link 'pelvis'"});
  expect_refused("left: [left_hip_yaw, left_hip_roll,", "left: [left_hip_yaw, left_hip_rol,",
                 {"legs.left[1] = 'left_hip_rol'", "Did you mean 'left_hip_roll'?"});
}

TEST(BrokenNetwork, HipHeightMustFitTheHomePosture) {
  expect_refused("hip_height_m: 0.36", "hip_height_m: 0.345",
                 {"standing.hip_height_m = 0.345", "the left hip is 0.3600 m above the sole"});
}

TEST(BrokenNetwork, SolesMustBeLevelAtHome) {
  BrokenRobot robot;
  robot.replace(kNetworkFile, "trim_channel: 4, home_deg: -19.75", "trim_channel: 4, home_deg: -15");
  robot.expect_complaint({"standing: in the home posture the left sole is not level"});
}

TEST(BrokenNetwork, AnInclinometerThatIsTurnedOverIsRefused) {
  expect_refused(
      "position_m: [0, 0, 0.10], rotation_rpy_deg: [0, 0, 0]",
      "position_m: [0, 0, 0.10], rotation_rpy_deg: [180, 0, 90]",
      {"imu.rotation_rpy_deg", "z axis is 180 deg from up", "derived from gyro and accelerometer"});
}

}  // namespace
}  // namespace gaitway::urdf
