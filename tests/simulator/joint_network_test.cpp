// The joints' electronics: with the gains that their drives really have, and the current that they measure.
#include "gaitway/simulator/joint_network.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gaitway::simulator {
namespace {

class JointNetworkTest : public ::testing::Test {
 protected:
  JointNetworkTest() { robot_.parts_deviation = 1.0; }
  // All encoders say home, and a little more.
  [[nodiscard]] PlantSensors stretched(double by_rad) const {
    PlantSensors sensors;
    for (const urdf::Joint& joint : robot_.joints) {
      sensors.encoder_count.push_back(
          static_cast<std::int32_t>(std::lround((joint.home_rad + by_rad) / joint.encoder_count_rad)));
    }
    return sensors;
  }

  urdf::RobotModel robot_ = urdf::load_robot(GAITWAY_ROBOT);
};

TEST_F(JointNetworkTest, ItsServosAreAsStiffAsTheBodysTruthSays) {
  const Plant plant(robot_, {.seed = 5, .mismatch = 1.0, .sensor_noise = false});
  JointNetwork real(robot_, 5, 0.0, 1.0), described(robot_, 5, 0.0);
  const PlantSensors sensors = stretched(0.004);
  real.step(0, sensors);
  described.step(0, sensors);
  for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
    const JointTruth& truth = plant.body_truth().joints[j];
    ASSERT_LT(described.torque_Nm()[j], -0.5);
    EXPECT_NEAR(real.torque_Nm()[j] / described.torque_Nm()[j], truth.servo_stiffness_factor, 1e-9);
    EXPECT_NEAR(real.config(static_cast<int>(j)).damping_Nms_per_rad,
                robot_.joints[j].servo.damping_Nms_per_rad * truth.servo_damping_factor, 1e-9);
    EXPECT_EQ(described.config(static_cast<int>(j)).stiffness_Nm_per_rad,
              robot_.joints[j].servo.stiffness_Nm_per_rad);
  }
}

TEST_F(JointNetworkTest, AJointThatComesBackHasItsOwnGainsAgain) {
  JointNetwork real(robot_, 5, 0.0, 1.0);
  const PlantSensors sensors = stretched(0.004);
  real.step(0, sensors);
  const double before_Nm = real.torque_Nm()[3];
  real.power_off(3);
  real.power_on(3, stretched(0.0));
  real.step(1'000'000, sensors);
  EXPECT_NEAR(real.torque_Nm()[3], before_Nm, 0.3) << "to the count that it found itself at";
}

TEST_F(JointNetworkTest, TellsEachJointTheCurrentThatItsSensorReads) {
  JointNetwork network(robot_, 1, 0.0);
  PlantSensors sensors = stretched(0.0);
  EXPECT_EQ(network.sensors(3, sensors).motor_current_Nm, 0.0F) << "no body, no current";
  sensors.motor_current_Nm.assign(robot_.joints.size(), 0.0);
  sensors.motor_current_Nm[3] = -1.5;
  EXPECT_EQ(network.sensors(3, sensors).motor_current_Nm, -1.5F);
  EXPECT_EQ(network.sensors(4, sensors).motor_current_Nm, 0.0F);
}

}  // namespace
}  // namespace gaitway::simulator
