// A robot's calibration.yaml becomes part of its model, or is refused with its place.
#include "broken_robot.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/tilt.hpp"
#include "gaitway/urdf/calibration.hpp"

namespace gaitway::urdf {
namespace {

using facts::kRadPerDegree;
constexpr const char* kSound = R"(robot: humanoid22
joint_zeros_deg:
  left_knee: {value: 0.5, deviation: 0.03}
  right_hip_yaw: {value: -0.25}
trunk_com_offset_m: {value: [0.004, -0.002, 0.01], deviation: [0.001, 0.001, 0.003]}
force_cell_gains:
  left: {value: [1.01, 0.99, 1.02, 0.98]}
  right: {value: [1.03, 1.0, 1.0, 0.97], deviation: [0.01, 0.01, 0.01, 0.01]}
imu_tilts_deg:
  accelerometer: {value: [1.5, -0.5], deviation: [0.1, 0.3]}
  inclinometer: {value: [-0.8, 0.4]}
)";

TEST(CalibrationFile, becomes_part_of_the_model) {
  const test::BrokenRobot robot;
  const RobotModel described = robot.load();
  robot.write("calibration.yaml", kSound);
  const RobotModel calibrated = robot.load();
  const auto joint = [&](const char* name) {
    return calibrated.joints[static_cast<std::size_t>(calibrated.joint_index(name))];
  };
  EXPECT_DOUBLE_EQ(joint("left_knee").encoder_zero_rad, 0.5 * kRadPerDegree);
  EXPECT_DOUBLE_EQ(joint("right_hip_yaw").encoder_zero_rad, -0.25 * kRadPerDegree);
  EXPECT_EQ(joint("left_hip_yaw").encoder_zero_rad, 0.0);
  const auto trunk = static_cast<std::size_t>(described.imu.link);
  const Eigen::Vector3d offset = calibrated.links[trunk].com_m - described.links[trunk].com_m;
  EXPECT_TRUE(offset.isApprox(Eigen::Vector3d(0.004, -0.002, 0.01), 1e-9));
  EXPECT_EQ(calibrated.trunk_com_offset_m, Eigen::Vector3d(0.004, -0.002, 0.01));
  const double share = described.links[trunk].mass_kg / described.total_mass_kg();
  EXPECT_NEAR(ForwardKinematics(calibrated).com_m().x() - ForwardKinematics(described).com_m().x(),
              0.004 * share, 1e-9);
  int cells = 0;
  for (const auto& pair : calibrated.channels) {
    for (const SensorChannel& channel : pair) {
      if (channel.kind != SensorKind::force_cell) {
        EXPECT_EQ(channel.gain, 1.0);
        continue;
      }
      ++cells;
      if (channel.side == Side::left && channel.index == 2) {
        EXPECT_EQ(channel.gain, 1.02);
      }
      if (channel.side == Side::right && channel.index == 3) {
        EXPECT_EQ(channel.gain, 0.97);
      }
    }
  }
  EXPECT_EQ(cells, 8);
}

Eigen::Vector3d up_at(double roll_deg, double pitch_deg) {
  return geometry::up_at_tilt(kRadPerDegree * Eigen::Vector2d(roll_deg, pitch_deg));
}

TEST(CalibrationFile, levels_what_each_sensor_of_the_imu_says) {
  const test::BrokenRobot robot;
  const RobotModel described = robot.load();
  robot.write("calibration.yaml", kSound);
  const RobotModel calibrated = robot.load();
  const Imu& imu = calibrated.imu;
  EXPECT_TRUE(imu.specific_force_in_link(up_at(1.5, -0.5)).isApprox(Eigen::Vector3d::UnitZ(), 1e-9));
  EXPECT_LT(imu.tilt_in_link(kRadPerDegree * Eigen::Vector2d(-0.8, 0.4)).norm(), 1e-9);
  // Forward by 10 degrees is 10 degrees more than upright.
  const Eigen::Vector2d ahead = imu.tilt_in_link(kRadPerDegree * Eigen::Vector2d(-0.8, 10.4));
  EXPECT_NEAR(ahead.x(), 0.0, 0.02 * kRadPerDegree);
  EXPECT_NEAR(ahead.y(), 10.0 * kRadPerDegree, 0.02 * kRadPerDegree);
  const Eigen::Vector3d turn(0.1, -0.2, 0.3);
  EXPECT_EQ(imu.angular_velocity_in_link(turn), turn) << "the file says nothing of it";
  EXPECT_TRUE(imu.pose.isApprox(described.imu.pose, 0.0)) << "where the simulated body has it";
}

TEST(CalibrationFile, without_tilts_of_the_imu_leaves_it_as_described) {
  const test::BrokenRobot robot;
  robot.write("calibration.yaml", "robot: humanoid22\n");
  const Imu imu = robot.load().imu;
  const Eigen::Vector2d tilt_rad(0.1, -0.2);
  EXPECT_EQ(imu.tilt_in_link(tilt_rad), tilt_rad);
  EXPECT_EQ(imu.specific_force_in_link(Eigen::Vector3d::UnitX()), Eigen::Vector3d::UnitX());
}

TEST(CalibrationFile, may_be_left_out) {
  const test::BrokenRobot robot;
  robot.write("calibration.yaml", kSound);
  const RobotModel described = load_robot(robot.folder(), CalibrationUse::left_out);
  EXPECT_EQ(described.trunk_com_offset_m, Eigen::Vector3d::Zero());
  for (const Joint& joint : described.joints) EXPECT_EQ(joint.encoder_zero_rad, 0.0);
  EXPECT_EQ(described.imu.specific_force_in_link(Eigen::Vector3d::UnitX()), Eigen::Vector3d::UnitX());
}

TEST(CalibrationFile, is_read_as_it_is_for_who_shows_it) {
  test::BrokenRobot robot;
  EXPECT_FALSE(read_calibration(robot.load()));
  robot.write("calibration.yaml", std::string(kSound) + "made: 2026-11-25T03:21:29Z\n");
  const RobotModel model = robot.load();
  const auto calibration = read_calibration(model);
  ASSERT_TRUE(calibration);
  EXPECT_EQ(calibration->made, "2026-11-25T03:21:29Z");
  const auto& knee = calibration->zero_rad[static_cast<std::size_t>(model.joint_index("left_knee"))];
  ASSERT_TRUE(knee && knee->deviation);
  EXPECT_DOUBLE_EQ(knee->value[0], 0.5 * kRadPerDegree);
  EXPECT_DOUBLE_EQ((*knee->deviation)[0], 0.03 * kRadPerDegree);
  EXPECT_FALSE(calibration->zero_rad[static_cast<std::size_t>(model.joint_index("left_hip_yaw"))]);
  EXPECT_EQ(calibration->trunk_com_offset_m->value[2], 0.01);
  EXPECT_EQ((*calibration->cell_gain)[1].value[0], 1.03);
  EXPECT_FALSE((*calibration->cell_gain)[0].deviation);
  EXPECT_FALSE(calibration->imu_tilt.gyro_rad);
  ASSERT_TRUE(calibration->imu_tilt.accelerometer_rad && calibration->imu_tilt.accelerometer_rad->deviation);
  EXPECT_DOUBLE_EQ(calibration->imu_tilt.accelerometer_rad->value[0], 1.5 * kRadPerDegree);
  EXPECT_DOUBLE_EQ((*calibration->imu_tilt.accelerometer_rad->deviation)[1], 0.3 * kRadPerDegree);
  EXPECT_FALSE(calibration->imu_tilt.inclinometer_rad->deviation);
  robot.write("calibration.yaml", kSound);
  EXPECT_EQ(read_calibration(robot.load())->made, "") << "files from before it was written say nothing";
}

TEST(CalibrationFile, tells_dates_from_what_is_none) {
  for (const char* const date :
       {"2026-11-25", "2024-02-29", "2026-11-25T23:59:59Z", "2000-01-01T00:00:00Z"}) {
    test::BrokenRobot robot;
    robot.write("calibration.yaml", "robot: humanoid22\nmade: " + std::string(date) + "\n");
    EXPECT_EQ(read_calibration(robot.load())->made, date);
  }
  for (const char* const none :
       {"2026-02-29", "2026-13-01", "2026-00-10", "1999-12-31", "26-11-25", "2026-11-25T24:00:00Z",
        "2026-11-25T03:60:00Z", "2026-11-25T03:21:29", "2026-11-25T03:21:29+01:00", "2026-11-25Z",
        "2026-11-25T", "25.11.2026", "yesterday", "20261125", "2026-1-5", "2026-11-25T03:21:29ZZ"}) {
    test::BrokenRobot robot;
    robot.write("calibration.yaml", "robot: humanoid22\nmade: '" + std::string(none) + "'\n");
    robot.expect_complaint({"calibration.yaml:2", none, "YYYY-MM-DD", "2026-11-25T03:21:29Z"});
  }
}

TEST(CalibrationFile, is_refused_with_its_place) {
  const auto expect = [](const std::string& before, const std::string& after,
                         const std::vector<std::string>& parts) {
    test::BrokenRobot robot;
    robot.write("calibration.yaml", kSound);
    robot.replace("calibration.yaml", before, after).expect_complaint(parts);
  };
  expect("robot: humanoid22", "robot: other", {"calibration.yaml:1", "humanoid22", "gaitway calibrate"});
  expect("left_knee", "left_nee", {"calibration.yaml:3", "left_nee", "left_knee"});
  expect("value: 0.5,", "value: 50,", {"calibration.yaml:3", "50", "20"});
  expect("value: 0.5,", "", {"calibration.yaml:3", "value"});
  expect("0.004, ", "", {"calibration.yaml:5", "trunk_com_offset_m"});
  expect("0.004", "4", {"calibration.yaml:5", "0.1"});
  expect("1.02", "0", {"calibration.yaml:7", "0.5"});
  expect("force_cell_gains", "force_cell_gain", {"calibration.yaml:6", "force_cell_gains"});
  expect("1.5, -0.5", "150, -0.5", {"calibration.yaml:10", "imu_tilts_deg.accelerometer", "150", "20"});
  expect("-0.8, 0.4", "-0.8", {"calibration.yaml:11", "imu_tilts_deg.inclinometer"});
  expect("inclinometer:", "inclinator:", {"calibration.yaml:11", "inclinator", "inclinometer"});
}

}  // namespace
}  // namespace gaitway::urdf
