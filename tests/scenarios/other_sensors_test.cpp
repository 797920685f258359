// humanoid22 with other sensors stands and walks through the whole chain: six-axis feet, feet without
// sensors, the IMU in the base, ideal parts, trims at the ankles alone,
// without inclinometer and foot accelerometers.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "robots/robot_variants.hpp"
#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

using gaitway::test::RobotVariant;

struct Equipment {
  std::string name;
  std::function<void(RobotVariant&)> change;
};

class OtherSensors : public ::testing::TestWithParam<Equipment> {};

TEST_P(OtherSensors, StandAndWalk) {
  RobotVariant variant;
  GetParam().change(variant);
  const urdf::RobotModel robot = urdf::load_robot(variant.folder());
  for (int seed = 1; seed <= seeds(3); ++seed) {
    auto run = SimulatedRun::of_robot(static_cast<std::uint64_t>(seed), robot);
    run.play({.seconds = 12.0, .events = {walk_at(2.0, 0.15)}});
    EXPECT_FALSE(run.metrics().fell) << "at " << run.metrics().fell_at_s << " s, seed " << seed;
    EXPECT_NEAR(run.metrics().mean_speed_m_per_s(), 0.15, 0.0225) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, OtherSensors,
                         ::testing::Values(Equipment{"SixAxisFeet", &RobotVariant::give_six_axis_feet},
                                           Equipment{"FeetWithoutSensors", &RobotVariant::take_foot_sensors},
                                           Equipment{"ImuInTheBase", &RobotVariant::put_imu_into_base},
                                           Equipment{"PartsAsDescribed", &RobotVariant::build_of_ideal_parts},
                                           Equipment{"TrimsAtTheAnklesAlone",
                                                     &RobotVariant::trim_ankles_alone},
                                           Equipment{"NeitherInclinometerNorFootAccelerometers",
                                                     [](RobotVariant& variant) {
                                                       variant.take_inclinometer();
                                                       variant.take_foot_accelerometers();
                                                     }},
                                           Equipment{"GyroAndAccelerometerInTheBaseAlone",
                                                     [](RobotVariant& variant) {
                                                       variant.take_foot_sensors();
                                                       variant.put_imu_into_base();
                                                       variant.trim_ankles_alone();
                                                       variant.take_inclinometer();
                                                       variant.take_foot_accelerometers();
                                                     }}),
                         [](const auto& tested) { return tested.param.name; });

// The gyro's bias walks, and nothing but the accelerations of a walk tells which way is up.
TEST(RealParts, TiltIsKnownOnALongWalk) {
  const RobotVariant variant;
  const urdf::RobotModel robot = urdf::load_robot(variant.folder());
  for (int seed = 1; seed <= seeds(2); ++seed) {
    auto run = SimulatedRun::of_robot(static_cast<std::uint64_t>(seed), robot);
    run.apply(walk_at(2.0, 0.2));
    auto reader = run.cosimulation.client().read<Estimate>("estimate");
    const auto error = [&]() -> Eigen::Vector2d {
      Estimate estimate{};
      EXPECT_TRUE(reader.read(estimate));
      const Eigen::Vector3d up = run.cosimulation.plant().truth().trunk.linear().row(2);
      return {estimate.attitude[0] - std::atan2(up.y(), up.z()),
              estimate.attitude[1] - std::atan2(-up.x(), std::hypot(up.y(), up.z()))};
    };
    Eigen::Vector2d first = Eigen::Vector2d::Zero();  // mean of a minute: how the IMU is mounted
    Eigen::Vector2d last = Eigen::Vector2d::Zero();
    for (double until_s = 0.5; until_s <= 420.0 && !run.metrics().fell; until_s += 0.5) {
      while (run.time_s() < until_s) run.cosimulation.advance_millisecond();
      if (until_s > 60.0 && until_s <= 120.0) first += error() / 120.0;
      if (until_s > 360.0) last += error() / 120.0;
    }
    EXPECT_FALSE(run.metrics().fell) << "seed " << seed;
    EXPECT_LT((last - first).norm(), 0.015) << "seed " << seed;
  }
}

}  // namespace
}  // namespace gaitway::scenarios
