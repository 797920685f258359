// The simulated sensors read what physics says, plus the noise that the robot's description gives them.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "gaitway/facts/facts.hpp"
#include "home_servo.hpp"
#include "robots/robot_variants.hpp"

namespace gaitway::simulator {
namespace {

using facts::kGravity_m_per_s2;

class SensorTest : public ::testing::Test {
 protected:
  urdf::RobotModel model_ = humanoid22();
  HomeServo servo_{model_};
  PlantOptions exact_{.seed = 1, .mismatch = 0.0, .sensor_noise = false};
};

TEST_F(SensorTest, TheCellsSeeTheCentreOfPressure) {
  Plant plant(model_, exact_);
  plant.push("trunk", Eigen::Vector3d::UnitX(), 1.0, 0.2);
  double farthest_m = 0.0;
  for (int i = 0; i < 500; ++i) {
    servo_.hold(plant, 1);
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const double force = plant.ground_contact().normal_force_N[foot];
      const auto& cells = plant.sensors().force_N[foot];
      EXPECT_NEAR(std::accumulate(cells.begin(), cells.end(), 0.0), force, 1e-9);
      if (force < 1.0) {
        continue;
      }
      Eigen::Vector2d moment = Eigen::Vector2d::Zero();
      for (std::size_t cell = 0; cell < 4; ++cell) {
        moment += cells[cell] * model_.feet[foot].cell_m[cell];
      }
      const Eigen::Vector2d& cop = plant.ground_contact().foot_cop_m[foot];
      EXPECT_LT((moment / force - cop).norm(), 1e-9);
      const Eigen::Vector2d from_centre = (cop - model_.feet[foot].centre_m).cwiseAbs();
      EXPECT_LE(from_centre.x(), model_.feet[foot].size_m.x() / 2 + 1e-3);
      EXPECT_LE(from_centre.y(), model_.feet[foot].size_m.y() / 2 + 1e-3);
      farthest_m = std::max(farthest_m, from_centre.x());
    }
  }
  EXPECT_GT(farthest_m, 0.03) << "the push did not move the centre of pressure";
}

// But for what the foot's own acceleration takes.
TEST_F(SensorTest, ASixAxisSensorSeesWhatTheGroundDoesToTheFoot) {
  gaitway::test::RobotVariant variant;
  variant.give_six_axis_feet();
  const urdf::RobotModel model = urdf::load_robot(variant.folder());
  HomeServo servo(model);
  Plant plant(model, exact_);
  servo.hold(plant, 1000);
  plant.push("trunk", Eigen::Vector3d(1.0, 0.5, 0.0), 0.5, 0.3);
  for (int i = 0; i < 500; ++i) {
    servo.hold(plant, 1);
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const double force_N = plant.ground_contact().normal_force_N[foot];
      const auto cells_N = model.feet[foot].cell_forces_N(plant.sensors().foot_wrench[foot]);
      EXPECT_NEAR(std::accumulate(cells_N.begin(), cells_N.end(), 0.0), force_N, 0.5);
      if (force_N < 15.0) continue;
      Eigen::Vector2d moment_Nm = Eigen::Vector2d::Zero();
      for (std::size_t cell = 0; cell < 4; ++cell) moment_Nm += cells_N[cell] * model.feet[foot].cell_m[cell];
      EXPECT_LT((moment_Nm / force_N - plant.ground_contact().foot_cop_m[foot]).norm(), 0.003);
    }
  }
  throw_up(plant, model);
  servo.hold(plant, 300);
  EXPECT_NEAR(plant.sensors().foot_wrench[0][2], 0.0, 3.5) << "in the air: no more than the foot's weight";
}

TEST_F(SensorTest, AccelerometersFeelGravityAtRest) {
  Plant plant(model_, exact_);
  servo_.hold(plant, 2000);
  const Eigen::Vector3d up(0.0, 0.0, kGravity_m_per_s2);
  const double tilt_share = kGravity_m_per_s2 * plant.truth().trunk_tilt_rad;
  EXPECT_LT((plant.sensors().acceleration_m_per_s2 - up).norm(), tilt_share + 0.05);
  for (const Eigen::Vector3d& foot : plant.sensors().foot_acceleration_m_per_s2) {
    EXPECT_LT((foot - up).norm(), 0.05);
  }
}

TEST_F(SensorTest, AccelerometersFeelNothingInFreeFall) {
  Plant plant(model_, exact_);
  throw_up(plant, model_);
  servo_.hold(plant, 500);
  ASSERT_EQ(plant.ground_contact().normal_force_N[0] + plant.ground_contact().normal_force_N[1], 0.0);
  EXPECT_LT(plant.sensors().acceleration_m_per_s2.norm(), 0.02);
  for (std::size_t foot = 0; foot < 2; ++foot) {
    EXPECT_LT(plant.sensors().foot_acceleration_m_per_s2[foot].norm(), 0.02);
    EXPECT_EQ(plant.sensors().force_N[foot], (std::array<double, 4>{}));
  }
}

TEST_F(SensorTest, GyroAndInclinometerAgreeWithTheMotionOfTheTrunk) {
  model_.imu.inclinometer = urdf::Inclinometer::fused;
  Plant plant(model_, exact_);
  servo_.hold(plant, 200);
  plant.push("trunk", Eigen::Vector3d(1.0, 1.0, 0.0), 1.0, 0.1);
  Eigen::Vector2d turned = plant.sensors().inclination_rad;
  double largest_rad = 0.0;
  for (int i = 0; i < 150; ++i) {  // the sum of small rates is the angle as long as angles are small
    servo_.hold(plant, 1);
    turned += 0.001 * plant.sensors().angular_velocity_rad_per_s.head<2>();
    largest_rad = std::max(largest_rad, plant.sensors().inclination_rad.norm());
  }
  EXPECT_GT(largest_rad, 0.01);
  EXPECT_LT((turned - plant.sensors().inclination_rad).norm(), 0.05 * largest_rad);
  EXPECT_GT(plant.sensors().inclination_rad.y(), 0.0) << "pushed forward, the trunk pitches forward";
  EXPECT_LT(plant.sensors().inclination_rad.x(), 0.0) << "pushed to the left, the trunk rolls to the left";
}

// A pendulum hangs along apparent gravity: a trunk that is driven forwards throws it back, as if it pitched
// back.
TEST_F(SensorTest, APendulumFeelsEveryAcceleration) {
  Plant plant(model_, exact_);
  servo_.hold(plant, 300);
  const double at_rest_rad = plant.sensors().inclination_rad.y();
  const Eigen::Vector3d trunk_at_rest_m = plant.truth().trunk.translation();
  plant.push("trunk", Eigen::Vector3d::UnitX(), 1.0, 0.1);
  double least_rad = at_rest_rad, least_pitch_rad = 0.0;
  for (int i = 0; i < 60; ++i) {
    servo_.hold(plant, 1);
    least_rad = std::min(least_rad, plant.sensors().inclination_rad.y());
    least_pitch_rad = std::min(least_pitch_rad, std::asin(-plant.truth().trunk.linear()(2, 0)));
  }
  EXPECT_GT(plant.truth().trunk.translation().x(), trunk_at_rest_m.x());
  EXPECT_GT(least_pitch_rad, -0.005) << "the trunk itself never pitched back";
  EXPECT_LT(least_rad, at_rest_rad - 0.025);
}

TEST_F(SensorTest, NoiseHasTheDescribedDeviationAndNoBias) {
  Plant noisy(model_, {.seed = 9, .mismatch = 0.0, .sensor_noise = true});
  Plant exact(model_, {.seed = 9, .mismatch = 0.0, .sensor_noise = false});
  constexpr int kSteps = 4000;
  std::array<double, 4> sum{}, square{};
  for (int i = 0; i < kSteps; ++i) {
    servo_.hold(noisy, 1);
    servo_.hold(exact, 1);
    const PlantSensors &a = noisy.sensors(), &b = exact.sensors();
    const std::array<double, 4> error{
        (a.angular_velocity_rad_per_s.x() - b.angular_velocity_rad_per_s.x()) /
            model_.noise.angular_velocity_rad_per_s,
        (a.acceleration_m_per_s2.z() - b.acceleration_m_per_s2.z()) / model_.noise.acceleration_m_per_s2,
        (a.inclination_rad.y() - b.inclination_rad.y()) / model_.noise.inclination_rad,
        (a.force_N[1][2] - b.force_N[1][2]) / model_.noise.force_N};
    for (std::size_t k = 0; k < error.size(); ++k) {
      sum[k] += error[k];
      square[k] += error[k] * error[k];
    }
  }
  for (std::size_t k = 0; k < sum.size(); ++k) {
    EXPECT_NEAR(sum[k] / kSteps, 0.0, 4.0 / std::sqrt(kSteps)) << k;
    EXPECT_NEAR(std::sqrt(square[k] / kSteps), 1.0, 0.05) << k;
  }
}

}  // namespace
}  // namespace gaitway::simulator
