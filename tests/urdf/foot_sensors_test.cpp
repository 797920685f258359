// Robots whose feet tell their load with four cells, with a six-axis sensor or not at all, and which lack an
// inclinometer or accelerometers in the feet: what loads, what a wrench means, and what is refused.
#include "broken_robot.hpp"
#include "gaitway/input/text.hpp"
#include "robots/robot_variants.hpp"

namespace gaitway::urdf {
namespace {

using gaitway::test::RobotVariant;
using test::BrokenRobot;
using test::kNetworkFile;

TEST(FootSensors, AreFourCellsWhereNothingIsSaid) {
  const RobotModel robot = BrokenRobot().load();
  for (const Foot& foot : robot.feet) EXPECT_EQ(foot.sensor, FootSensor::cells);
  EXPECT_TRUE(robot.senses_load());
  EXPECT_TRUE(robot.carries(SensorKind::force_cell));
  EXPECT_FALSE(robot.carries(SensorKind::foot_wrench));
}

TEST(FootSensors, OfSixAxesHaveAFrameAndChannels) {
  RobotVariant variant;
  variant.give_six_axis_feet();
  const RobotModel robot = load_robot(variant.folder());
  EXPECT_EQ(robot.feet[0].sensor, FootSensor::six_axis);
  EXPECT_EQ(robot.feet[1].sensor_pose.translation(), Eigen::Vector3d(0.0, 0.0, -0.02));
  const SensorChannel& torque =
      robot.channels[static_cast<std::size_t>(robot.joint_index("left_ankle_pitch"))][1];
  EXPECT_EQ(channel_name(torque), "left_foot_torque_x");
  EXPECT_EQ(torque.scale, 0.001);
  EXPECT_EQ(robot.noise.torque_Nm, 0.01);
}

TEST(FootSensors, MayBeNone) {
  RobotVariant variant;
  variant.take_foot_sensors();
  variant.take_inclinometer();
  variant.take_foot_accelerometers();
  const RobotModel robot = load_robot(variant.folder());
  EXPECT_FALSE(robot.senses_load());
  EXPECT_FALSE(robot.carries(SensorKind::inclination));
  EXPECT_FALSE(robot.carries(SensorKind::foot_acceleration));
}

TEST(Inclinometer, ThatIsNotCarriedIsNoPendulum) {
  BrokenRobot robot;
  EXPECT_EQ(robot.load().imu.inclinometer, Inclinometer::pendulum);
  robot.replace(kNetworkFile, "inclination_roll", "none").replace(kNetworkFile, "inclination_pitch", "none");
  robot.expect_complaint({"imu.inclinometer = pendulum: no joint carries inclination channels"});
}

TEST(FootSensors, AWrenchIsTheSameForceAtTheSamePlaceWhereverTheSensorSits) {
  RobotVariant variant;
  variant.give_six_axis_feet();
  Foot foot = load_robot(variant.folder()).feet[0];
  foot.sensor_pose.translation() = Eigen::Vector3d(0.03, -0.01, 0.02);
  foot.sensor_pose.linear() = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).matrix();
  const Eigen::Vector3d force_N(4.0, -3.0, 40.0), place_m(0.05, -0.02, 0.0);  // in the sole frame
  const Eigen::Isometry3d in_sole = foot.sole.inverse() * foot.sensor_pose;
  const Eigen::Matrix3d turn = in_sole.linear().transpose();
  Wrench sensed;
  sensed << turn * force_N, turn * (place_m - in_sole.translation()).cross(force_N);
  const std::array<double, 4> cells_N = foot.cell_forces_N(sensed);
  double sum_N = 0.0;
  Eigen::Vector2d moment_Nm = Eigen::Vector2d::Zero();
  for (std::size_t cell = 0; cell < 4; ++cell) {
    sum_N += cells_N[cell];
    moment_Nm += cells_N[cell] * foot.cell_m[cell];
  }
  EXPECT_NEAR(sum_N, 40.0, 1e-9);
  EXPECT_LT((moment_Nm / sum_N - place_m.head<2>()).norm(), 1e-9);
  EXPECT_EQ(foot.cell_forces_N(Wrench(Wrench::Zero())), (std::array<double, 4>{}));
}

TEST(FootSensors, WrongOnesAreRefused) {
  const auto refused = [](const std::string& before, const std::string& after,
                          const std::vector<std::string>& parts) {
    BrokenRobot robot;
    robot.replace(kNetworkFile, "feet:", before, after);
    robot.expect_complaint(parts);
  };
  refused("cell_inset_m: 0.005}", "cell_inset_m: 0.005, sensor: sixaxis}",
          {"feet.left.sensor = 'sixaxis': must be cells, six_axis or none", "Did you mean 'six_axis'?"});
  refused("cell_inset_m: 0.005}", "cell_inset_m: 0.005, sensor: none}",
          {"feet", "both feet must have the same kind of sensor"});
  refused("cell_inset_m: 0.005}", "sensor: six_axis}", {"feet.left", "sensor_position_m"});
  refused("cell_inset_m: 0.005}", "cell_inset_m: 0.005, sensor_position_m: [0, 0, 0]}",
          {"only a six-axis sensor has a frame", "Write sensor: six_axis"});
}

TEST(FootSensors, AndTheirChannelsMustAgree) {
  BrokenRobot none;
  for (const char* const side : {"left: {link: left_foot", "right: {link: right_foot"}) {
    none.replace(kNetworkFile, side, "cell_inset_m: 0.005}", "sensor: none}");
  }
  none.expect_complaint({"'left_cell_front_left' is carried, but the foot's sensor is 'none'",
                         "Write sensor: cells for both feet, or take the channel away"});
  BrokenRobot extra;
  extra.replace(kNetworkFile, "[left_foot_acceleration_z, none]",
                "[left_foot_acceleration_z, left_foot_force_z]");
  extra.expect_complaint(
      {"joints[2].channels[1]", "nothing says what a count of it is", "Add channel_scale.foot_force_N"});
}

TEST(FootSensors, OfSixAxesNeedForceAndTorquesThatPlaceIt) {
  RobotVariant variant;
  variant.give_six_axis_feet();
  std::string text = input::read_text_file(variant.folder() / kNetworkFile, "");
  text.replace(text.find("left_foot_torque_y"), std::string("left_foot_torque_y").size(),
               "left_foot_force_y");
  const BrokenRobot robot;
  robot.write(kNetworkFile, text);
  robot.expect_complaint({"the sensor channel 'left_foot_torque_y' is carried by no joint"});
}

TEST(FootSensors, OptionalSensorsAreCarriedWholeOrNotAtAll) {
  BrokenRobot tilt;
  tilt.replace(kNetworkFile, "inclination_roll", "none");
  tilt.expect_complaint({"'inclination_roll' is carried by no joint"});
  BrokenRobot foot;
  foot.replace(kNetworkFile, "left_foot_acceleration_z", "none");
  foot.expect_complaint({"'left_foot_acceleration_z' is carried by no joint"});
  BrokenRobot gyro;
  gyro.replace(kNetworkFile, "angular_velocity_z", "none");
  gyro.expect_complaint({"'angular_velocity_z' is carried by no joint"});
}

TEST(FootSensors, ANinthTrimIsRefusedAndFewerAreNot) {
  BrokenRobot nine;
  nine.replace(kNetworkFile, "node: 14", "node: 14, trim_channel: 8");
  nine.expect_complaint({nine.line_of(kNetworkFile, "trim_channel: 8"), "joints[13].trim_channel = '8'",
                         "one trim frame holds the corrections of 8 joints",
                         "Give channels to ankles first"});
  RobotVariant few;
  few.trim_ankles_alone();
  const RobotModel robot = load_robot(few.folder());
  EXPECT_EQ(std::ranges::count_if(robot.joints, [](const Joint& joint) { return joint.trim_channel >= 0; }),
            4);
}

}  // namespace
}  // namespace gaitway::urdf
