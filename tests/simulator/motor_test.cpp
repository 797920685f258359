// The motors give what they can: full torque at rest and when braking, less the faster they drive.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "home_servo.hpp"

namespace gaitway::simulator {
namespace {

class MotorTest : public ::testing::Test {
 protected:
  urdf::RobotModel model_ = humanoid22();
  Plant plant_{model_, {.seed = 1, .mismatch = 0.0, .sensor_noise = false}};
  HomeServo servo_{model_};
  std::size_t elbow_ = static_cast<std::size_t>(model_.joint_index("left_elbow"));
  urdf::Motor motor_ = model_.joints[elbow_].motor;

  // Asks the elbow for a torque, holds everything else. Returns the elbow's speed before the step.
  double drive(double torque_Nm) {
    const double speed = plant_.velocities()[6 + elbow_];
    const std::span<const double> hold = servo_(plant_);
    std::vector<double> torque(hold.begin(), hold.end());
    torque[elbow_] = torque_Nm;
    plant_.step(torque);
    return speed;
  }
  double given_Nm() const { return plant_.sensors().motor_torque_Nm[elbow_]; }
};

TEST_F(MotorTest, GivesWhatIsAskedBelowItsLimit) {
  drive(1.25);
  EXPECT_EQ(given_Nm(), 1.25);
}

TEST_F(MotorTest, FadesWithSpeedWhenDriving) {
  double fastest = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double speed = drive(-100.0);  // bends the arm
    if (speed < 0.0) {
      const double limit = motor_.torque_limit_Nm * std::max(0.0, 1.0 + speed / motor_.speed_limit_rad_per_s);
      EXPECT_NEAR(given_Nm(), -limit, 1e-5);
    } else {
      EXPECT_NEAR(given_Nm(), -motor_.torque_limit_Nm, 1e-5);
    }
    fastest = std::max(fastest, -speed);
  }
  EXPECT_GT(fastest, 0.5 * motor_.speed_limit_rad_per_s) << "the arm hardly moved";
  EXPECT_LT(fastest, motor_.speed_limit_rad_per_s + 0.1);
}

TEST_F(MotorTest, ASaggingSupplyHalvesWhatAllMotorsGiveForItsTimeAlone) {
  plant_.weaken_motors(0.5, 0.01);
  for (int i = 0; i < 12; ++i) {
    const double speed = drive(i % 2 == 0 ? 100.0 : -100.0);  // to and fro, so that it brakes or hardly moves
    const bool drives = (i % 2 == 0) == (speed > 0.0);
    const double fade = drives ? 1.0 - std::abs(speed) / motor_.speed_limit_rad_per_s : 1.0;
    EXPECT_NEAR(std::abs(given_Nm()), (i < 10 ? 0.5 : 1.0) * fade * motor_.torque_limit_Nm, 1e-5) << i;
  }
  EXPECT_THROW(plant_.weaken_motors(1.5, 0.1), std::invalid_argument);
  EXPECT_THROW(plant_.weaken_motors(0.5, 0.0), std::invalid_argument);
}

TEST_F(MotorTest, TheCurrentSensorOfAnIdealMotorTellsWhatIsApplied) {
  for (const double asked_Nm : {0.5, -1.25, -100.0}) {
    drive(asked_Nm);
    EXPECT_NEAR(plant_.sensors().motor_current_Nm[elbow_], given_Nm(), 1e-6) << asked_Nm;
  }
}

// At rest, where no gear loses anything.
TEST_F(MotorTest, WithDeviationsEachMotorGivesByItsTorqueConstantAndTellsByItsSensor) {
  model_.parts_deviation = 1.0;
  Plant plant(model_, {.seed = 7, .mismatch = 1.0, .sensor_noise = false});
  const BodyTruth truth = plant.body_truth();
  for (std::size_t j = 0; j < model_.joints.size(); ++j) {
    EXPECT_EQ(plant.sensors().motor_current_Nm[j], truth.joints[j].current_offset_Nm);
  }
  plant.step(std::vector<double>(model_.joints.size(), 2.0));
  for (std::size_t j = 0; j < model_.joints.size(); ++j) {
    const JointTruth& joint = truth.joints[j];
    EXPECT_NEAR(plant.sensors().motor_torque_Nm[j], 2.0 * joint.torque_constant_factor, 1e-6);
    EXPECT_NEAR(plant.sensors().motor_current_Nm[j], 2.0 * joint.current_gain + joint.current_offset_Nm,
                1e-12);
  }
}

TEST_F(MotorTest, BrakesWithItsFullTorque) {
  for (int i = 0; i < 20; ++i) {
    drive(-100.0);
  }
  const double speed = drive(100.0);
  ASSERT_LT(speed, -1.0);
  EXPECT_NEAR(given_Nm(), motor_.torque_limit_Nm, 1e-5);
}

}  // namespace
}  // namespace gaitway::simulator
