// What the planner does not know of the simulated robot: masses, CoM of the trunk, zeros of the encoders.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "home_servo.hpp"

namespace gaitway::simulator {
namespace {

class MismatchTest : public ::testing::Test {
 protected:
  Plant plant(std::uint64_t seed, double mismatch) const {
    return Plant(model_, {.seed = seed, .mismatch = mismatch, .sensor_noise = false});
  }
  // Mean square of the encoders' zero errors.
  double zero_variance(std::uint64_t seed, double mismatch) const {
    const Plant robot = plant(seed, mismatch);
    double sum = 0.0;
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      const urdf::Joint& joint = model_.joints[j];
      const double error =
          robot.sensors().encoder_count[j] * joint.encoder_count_rad - robot.positions()[7 + j];
      sum += error * error;
    }
    return sum / static_cast<double>(model_.joints.size());
  }
  double weight_kg(std::uint64_t seed, double mismatch) {
    Plant robot = plant(seed, mismatch);
    HomeServo(model_).hold(robot, 1500);
    return (robot.ground_contact().normal_force_N[0] + robot.ground_contact().normal_force_N[1]) / 9.81;
  }

  urdf::RobotModel model_ = humanoid22();
};

TEST_F(MismatchTest, ZeroIsTheDescribedRobot) {
  EXPECT_LT(std::sqrt(zero_variance(5, 0.0)), model_.joints[0].encoder_count_rad);
  EXPECT_NEAR(weight_kg(5, 0.0), model_.total_mass_kg(), 0.01);
}

TEST_F(MismatchTest, EncoderZerosDeviateByTheirSigma) {
  constexpr int kRobots = 40;
  double variance = 0.0;
  for (std::uint64_t seed = 1; seed <= kRobots; ++seed) {
    variance += zero_variance(seed, 1.0) / kRobots;
  }
  EXPECT_NEAR(std::sqrt(variance) * 180.0 / std::numbers::pi, 0.4, 0.03);
  EXPECT_NEAR(std::sqrt(zero_variance(5, 2.0) / zero_variance(5, 1.0)), 2.0, 0.02);
}

TEST_F(MismatchTest, ChangesTheWeight) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const double change = weight_kg(seed, 1.0) / model_.total_mass_kg() - 1.0;
    EXPECT_GT(std::abs(change), 1e-4);
    EXPECT_LT(std::abs(change), 0.1);
  }
}

TEST_F(MismatchTest, MovesTheCentreOfMassByMillimetresAndDifferentlyForEachSeed) {
  const Eigen::Vector3d described = plant(1, 0.0).truth().com_m;
  constexpr int kRobots = 40;
  double square = 0.0;
  for (std::uint64_t seed = 1; seed <= kRobots; ++seed) {
    const Eigen::Vector3d offset = plant(seed, 1.0).truth().com_m - described;
    EXPECT_LT(offset.norm(), 0.03);
    square += offset.x() * offset.x() / kRobots;
  }
  // The trunk is 31 % of the robot: 6 mm there are 1.8 mm of the whole; the masses of the legs add to that.
  EXPECT_GT(std::sqrt(square), 0.0012);
  EXPECT_LT(std::sqrt(square), 0.0035);
}

}  // namespace
}  // namespace gaitway::simulator
