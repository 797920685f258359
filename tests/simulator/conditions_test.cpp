// Each condition does to the robot what it says, and nothing to a robot without it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "home_servo.hpp"

namespace gaitway::simulator {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180.0;

class ConditionsTest : public ::testing::Test {
 protected:
  [[nodiscard]] Plant plant(const Conditions& conditions, std::uint64_t seed = 1) const {
    return Plant(model_, {.seed = seed, .mismatch = 0.0, .sensor_noise = false, .conditions = conditions});
  }
  [[nodiscard]] double weight_N(const Plant& robot) const {
    return robot.ground_contact().normal_force_N[0] + robot.ground_contact().normal_force_N[1];
  }

  urdf::RobotModel model_ = humanoid22();
};

TEST_F(ConditionsTest, OnASlopeTheStandingRobotLeansWithTheGround) {
  Conditions conditions;
  conditions.ground.slope_rad = {4.0 * kRadPerDeg, -3.0 * kRadPerDeg};
  Plant robot = plant(conditions);
  HomeServo(model_).hold(robot, 1500);
  EXPECT_FALSE(robot.fallen());
  EXPECT_NEAR(weight_N(robot), model_.total_mass_kg() * 9.81 * std::cos(robot.truth().trunk_tilt_rad), 0.5);
  // Uphill ahead: the trunk leans back; downhill to the left: it leans to the left.
  EXPECT_NEAR(robot.sensors().inclination_rad.y(), -4.0 * kRadPerDeg, 0.02);
  EXPECT_NEAR(robot.sensors().inclination_rad.x(), -3.0 * kRadPerDeg, 0.02);
}

TEST_F(ConditionsTest, TheGroundIsHigherOrLowerBeyondAStep) {
  for (const double height_m : {0.008, -0.008}) {
    Conditions conditions;
    conditions.ground.step = GroundStep{.at_m = -1.0, .height_m = height_m};
    Plant robot = plant(conditions);  // it stands beyond the line: in the ground, or above it
    HomeServo(model_).hold(robot, 1500);
    EXPECT_FALSE(robot.fallen());
    EXPECT_NEAR(robot.ground_contact().sole[0].translation().z(), height_m, 0.002) << height_m;
  }
}

TEST_F(ConditionsTest, TilesAreFlatWhereTheRobotStandsAndOtherwiseOfTheSeed) {
  Conditions conditions;
  conditions.ground.tile_height_m = 0.02;
  Plant robot = plant(conditions);
  HomeServo(model_).hold(robot, 500);
  EXPECT_FALSE(robot.fallen());
  EXPECT_NEAR(robot.truth().trunk_tilt_rad, 0.0, 0.02);
  EXPECT_NEAR(weight_N(robot), model_.total_mass_kg() * 9.81, 1.0);
}

TEST_F(ConditionsTest, ALoadOnTheTrunkIsFeltByTheFeet) {
  Conditions conditions;
  conditions.body.trunk_mass_factor = 1.1;
  Plant robot = plant(conditions);
  HomeServo(model_).hold(robot, 1500);
  const double trunk_kg = model_.links[static_cast<std::size_t>(model_.imu.link)].mass_kg;
  EXPECT_NEAR(weight_N(robot) / 9.81 - model_.total_mass_kg(), 0.1 * trunk_kg, 0.01);
}

TEST_F(ConditionsTest, WeakMotorsGiveTheirShareOfTheTorque) {
  Conditions conditions;
  conditions.body.torque_factor = 0.75;
  Plant robot = plant(conditions);
  std::vector<double> command(model_.joints.size(), 0.0);
  const auto knee = static_cast<std::size_t>(model_.joint_index("left_knee"));
  command[knee] = 100.0;
  robot.step(command);
  EXPECT_NEAR(robot.sensors().motor_torque_Nm[knee], 0.75 * model_.joints[knee].motor.torque_limit_Nm, 0.1);
}

// The motor holds its place; behind it the arm hangs by gravity at one end of the play.
TEST_F(ConditionsTest, BehindAJointWithPlayTheLinkMovesByThePlay) {
  Conditions conditions;
  conditions.body.backlash_rad = 2.0 * kRadPerDeg;
  Plant robot = plant(conditions), exact = plant({});
  HomeServo(model_).hold(robot, 1500);
  HomeServo(model_).hold(exact, 1500);
  EXPECT_FALSE(robot.fallen());
  EXPECT_EQ(robot.positions().size(), exact.positions().size() + model_.joints.size());
  // Motor and play of a joint stand side by side behind the base's seven numbers.
  const auto elbow = static_cast<std::size_t>(model_.joint_index("left_elbow"));
  const double play_rad = robot.positions()[7 + 2 * elbow + 1];
  EXPECT_NEAR(std::abs(play_rad), 1.0 * kRadPerDeg, 0.15 * kRadPerDeg);
  EXPECT_NEAR(robot.sensors().encoder_count[elbow] * model_.joints[elbow].encoder_count_rad,
              robot.positions()[7 + 2 * elbow], model_.joints[elbow].encoder_count_rad);
}

TEST_F(ConditionsTest, TheGyroReadsItsBiasOfTheSeed) {
  Conditions conditions;
  conditions.body.gyro_bias_deviation_rad_per_s = 0.2 * kRadPerDeg;
  double variance = 0.0;
  constexpr int kRobots = 60;
  for (std::uint64_t seed = 1; seed <= kRobots; ++seed) {
    const Eigen::Vector3d difference = plant(conditions, seed).sensors().angular_velocity_rad_per_s -
                                       plant({}, seed).sensors().angular_velocity_rad_per_s;
    variance += difference.squaredNorm() / (3.0 * kRobots);
  }
  EXPECT_NEAR(std::sqrt(variance) / kRadPerDeg, 0.2, 0.04);
}

TEST_F(ConditionsTest, CellsHaveTheirGainsAndADeadOneReadsNothing) {
  Conditions conditions;
  conditions.body.cell_gain_deviation = 0.03;
  conditions.body.dead_cell = DeadCell{.foot = urdf::Side::right, .cell = 2};
  Plant robot = plant(conditions), exact = plant({});
  HomeServo(model_).hold(robot, 1500);
  HomeServo(model_).hold(exact, 1500);
  EXPECT_EQ(robot.sensors().force_N[1][2], 0.0);
  double furthest = 0.0;
  for (std::size_t cell = 0; cell < 4; ++cell) {
    const double ratio = robot.sensors().force_N[0][cell] / exact.sensors().force_N[0][cell];
    furthest = std::max(furthest, std::abs(ratio - 1.0));
    EXPECT_NEAR(ratio, 1.0, 0.12);
  }
  EXPECT_GT(furthest, 0.002);
}

}  // namespace
}  // namespace gaitway::simulator
