// The simulated robot stands, falls, is pushed and repeats itself.
#include "gaitway/simulator/plant.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gaitway/facts/facts.hpp"
#include "home_servo.hpp"

namespace gaitway::simulator {
namespace {

using facts::kGravity_m_per_s2;

class PlantTest : public ::testing::Test {
 protected:
  // Throws the robot up, pushes it in flight, and tells by how much its momentum changed in 0.2 s beyond what
  // gravity does.
  template <typename Push>
  Eigen::Vector3d momentum_gained(Push push) {
    Plant plant(model_, exact_);
    throw_up(plant, model_);
    servo_.hold(plant, 100);
    const auto com_velocity = [&] {
      const Eigen::Vector3d before = plant.truth().com_m;
      servo_.hold(plant, 1);
      return Eigen::Vector3d((plant.truth().com_m - before) / 0.001);
    };
    const Eigen::Vector3d before = com_velocity();
    push(plant);
    servo_.hold(plant, 199);
    const Eigen::Vector3d gravity(0.0, 0.0, -kGravity_m_per_s2);
    return model_.total_mass_kg() * (com_velocity() - before - 0.2 * gravity);
  }

  urdf::RobotModel model_ = humanoid22();
  HomeServo servo_{model_};
  PlantOptions exact_{.seed = 1, .mismatch = 0.0, .sensor_noise = false};
  std::vector<double> no_torque_ = std::vector<double>(model_.joints.size(), 0.0);
};

TEST_F(PlantTest, BeginsInTheHomePostureWithItsSolesOnTheGround) {
  const Plant plant(model_, exact_);
  for (const Eigen::Isometry3d& sole : plant.ground_contact().sole) {
    EXPECT_NEAR(sole.translation().z(), 0.0, 1e-9);
    EXPECT_NEAR(sole.linear()(2, 2), 1.0, 1e-9);
  }
  for (std::size_t j = 0; j < model_.joints.size(); ++j) {
    EXPECT_EQ(plant.positions()[7 + j], model_.joints[j].home_rad) << model_.joints[j].name;
  }
}

TEST_F(PlantTest, TellsWhatOfTheBodyLiesOnTheGround) {
  Plant plant(model_, exact_);
  servo_.hold(plant, 500);
  EXPECT_EQ(plant.ground_contact().body_force_N, 0.0) << "it stands on its feet alone";
  for (int ms = 0; ms < 4000; ++ms) plant.step(no_torque_);
  double force_Ns = 0.0;
  for (int ms = 0; ms < 500; ++ms) {
    plant.step(no_torque_);
    const GroundContact& contact = plant.ground_contact();
    EXPECT_GE(contact.body_force_N, contact.hardest_force_N);
    EXPECT_GE(contact.hardest_force_N, contact.trunk_force_N);
    force_Ns += 0.001 * (contact.body_force_N + contact.normal_force_N[0] + contact.normal_force_N[1]);
  }
  EXPECT_GT(plant.ground_contact().body_force_N, 0.0);
  EXPECT_NEAR(force_Ns / 0.5, model_.total_mass_kg() * kGravity_m_per_s2, 2.0)
      << "at rest the ground carries it";
}

TEST_F(PlantTest, StandsInItsHomePostureUnderItsServos) {
  Plant plant(model_, exact_);
  servo_.hold(plant, 2000);
  EXPECT_FALSE(plant.fallen());
  EXPECT_LT(plant.truth().trunk_tilt_rad, 0.01);
  EXPECT_NEAR(plant.time_s(), 2.0, 1e-9);
  const GroundContact& contact = plant.ground_contact();
  EXPECT_NEAR(contact.normal_force_N[0] + contact.normal_force_N[1],
              model_.total_mass_kg() * kGravity_m_per_s2, 0.1);
  EXPECT_LT((plant.truth().cop_m - plant.truth().com_m).head<2>().norm(), 0.002);
  for (const Eigen::Isometry3d& sole : contact.sole) {
    EXPECT_NEAR(sole.translation().z(), 0.0, 0.001) << "sunk into the ground";
  }
}

TEST_F(PlantTest, FallsWithoutTorqueAndSaysSo) {
  Plant plant(model_, exact_);
  EXPECT_FALSE(plant.fallen());
  for (int i = 0; i < 3000 && !plant.fallen(); ++i) {
    plant.step(no_torque_);
  }
  EXPECT_TRUE(plant.fallen());
}

TEST_F(PlantTest, LiesOnTheGroundAfterAFall) {
  Plant plant(model_, exact_);
  for (int i = 0; i < 4000; ++i) {
    plant.step(no_torque_);
  }
  EXPECT_GT(plant.truth().base.translation().z(), 0.02);
  EXPECT_LT(plant.truth().com_m.z(), 0.2);
}

TEST_F(PlantTest, APushGivesItsImpulseWhateverTheLengthOfItsDirection) {
  const Eigen::Vector3d gained =
      momentum_gained([](Plant& plant) { plant.push("trunk", Eigen::Vector3d(3.0, 4.0, 0.0), 0.5, 0.1); });
  EXPECT_LT((gained - Eigen::Vector3d(0.3, 0.4, 0.0)).norm(), 0.005);
}

TEST_F(PlantTest, PushesThatOverlapAddUp) {
  const Eigen::Vector3d gained = momentum_gained([](Plant& plant) {
    plant.push("trunk", Eigen::Vector3d::UnitX(), 0.2, 0.1);
    plant.push("trunk", Eigen::Vector3d::UnitX(), 0.2, 0.03);
    plant.push("pelvis", Eigen::Vector3d::UnitY(), 0.1, 0.001);
  });
  EXPECT_LT((gained - Eigen::Vector3d(0.4, 0.1, 0.0)).norm(), 0.005);
}

TEST_F(PlantTest, RefusesAPushThatIsNone) {
  Plant plant(model_, exact_);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(plant.push("tail", Eigen::Vector3d::UnitX(), 1.0, 0.1), std::invalid_argument);
  EXPECT_THROW(plant.push("world", Eigen::Vector3d::UnitX(), 1.0, 0.1), std::invalid_argument);
  EXPECT_THROW(plant.push("trunk", Eigen::Vector3d::Zero(), 1.0, 0.1), std::invalid_argument);
  EXPECT_THROW(plant.push("trunk", Eigen::Vector3d(nan, 0.0, 0.0), 1.0, 0.1), std::invalid_argument);
  EXPECT_THROW(plant.push("trunk", Eigen::Vector3d::UnitX(), nan, 0.1), std::invalid_argument);
  EXPECT_THROW(plant.push("trunk", Eigen::Vector3d::UnitX(), 1.0, 0.0), std::invalid_argument);
}

TEST_F(PlantTest, RefusesTorquesThatAreTooFewOrNotNumbers) {
  Plant plant(model_, exact_);
  std::vector<double> torque = no_torque_;
  torque[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(plant.step(torque), std::invalid_argument);
  torque.pop_back();
  EXPECT_THROW(plant.step(torque), std::invalid_argument);
}

TEST_F(PlantTest, OneSeedGivesTheSameMotionToTheBitAndAnotherAnother) {
  const auto end_of = [this](std::uint64_t seed) {
    Plant plant(model_, {.seed = seed, .mismatch = 1.0, .sensor_noise = true});
    servo_.hold(plant, 500);
    std::vector<double> end(plant.positions().begin(), plant.positions().end());
    end.push_back(plant.sensors().acceleration_m_per_s2.x());
    return end;
  };
  EXPECT_EQ(end_of(3), end_of(3));
  EXPECT_NE(end_of(3), end_of(4));
}

TEST_F(PlantTest, SensorNoiseDoesNotChangeTheRobotItself) {
  const auto end_of = [this](bool noise) {
    Plant plant(model_, {.seed = 3, .mismatch = 1.0, .sensor_noise = noise});
    servo_.hold(plant, 500);  // feels encoders alone, and those are without noise
    return std::vector<double>(plant.positions().begin(), plant.positions().end());
  };
  EXPECT_EQ(end_of(false), end_of(true));
}

TEST_F(PlantTest, AReplayOfItsTorquesEndsAtTheSamePlaceToTheBit) {
  Plant plant(model_, {.seed = 2, .mismatch = 1.0, .sensor_noise = true});
  std::vector<float> torques;
  for (int i = 0; i < 3000; ++i) {
    plant.step(servo_(plant));
    for (const double torque : plant.sensors().motor_torque_Nm) {
      torques.push_back(static_cast<float>(torque));
    }
  }
  const std::vector<double> before(plant.positions().begin(), plant.positions().end());
  const Replay replay = plant.replay(torques);
  EXPECT_EQ(replay.positions, before);
  EXPECT_GT(replay.wall_s, 0.0);
  EXPECT_EQ(std::vector<double>(plant.positions().begin(), plant.positions().end()), before);
  torques.pop_back();
  EXPECT_THROW((void)plant.replay_wall_s(torques), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::simulator
