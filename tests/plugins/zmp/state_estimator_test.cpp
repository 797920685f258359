// The whole estimate, from synthetic sensors.
#include "gaitway/zmp/state_estimator.hpp"

#include <gtest/gtest.h>

#include <random>

#include "allocation_count.hpp"
#include "synthetic_robot.hpp"

namespace gaitway::zmp {
namespace {

using test::humanoid;
using test::kTick_ns;
using test::Sensors;
using test::weight_N;
using urdf::Side;

constexpr std::size_t kLeftAnklePitch = 4;  // brings two force cells of the left foot

class StateEstimatorTest : public ::testing::Test {
 protected:
  // Presents the sensors with a new stamp.
  bool tick() {
    now_ns_ += kTick_ns;
    sensors_.stamp(now_ns_ - 2'000'000);
    return update();
  }
  bool update() {
    return estimator_.update(now_ns_, sensors_.joints, sensors_.forces, sensors_.imu, estimate_);
  }
  void stand(int ticks) {
    sensors_.press(Side::left, 0.5 * weight_N(), {0.01, 0.0});
    sensors_.press(Side::right, 0.5 * weight_N(), {0.01, 0.0});
    for (int i = 0; i < ticks; ++i) ASSERT_TRUE(tick());
  }
  // Both feet flat, the body turned about the ankles so far that the CoM is at x in the left level frame.
  void lean_to(double com_x) {
    urdf::ForwardKinematics kinematics(humanoid());
    double pitch = 0.0;
    for (int i = 0; i < 8; ++i) {
      const Eigen::Matrix3d upright = Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()).toRotationMatrix();
      const auto posture = leaning(pitch);
      kinematics.compute(posture);
      const Eigen::Vector3d com =
          upright * (kinematics.com_m() - kinematics.sole_pose(Side::left).translation());
      pitch += (com_x - com.x()) / com.z();
    }
    sensors_.set_posture(leaning(pitch));
    sensors_.imu.angular_velocity[1] = has_pitch_ ? (pitch - sensors_.imu.inclination[1]) / 0.01 : 0.0;
    sensors_.imu.inclination[1] = pitch;
    has_pitch_ = true;
  }
  static std::vector<double> leaning(double pitch) {
    std::vector<double> posture = test::home_posture(humanoid());
    for (const auto& leg : humanoid().legs) posture[static_cast<std::size_t>(leg.joints[4])] -= pitch;
    return posture;
  }

  StateEstimator estimator_{humanoid(), EstimatorParameters{}};
  Sensors sensors_;
  Estimate estimate_{};
  std::int64_t now_ns_ = 1'000'000'000;
  bool has_pitch_ = false;
};

TEST_F(StateEstimatorTest, StandingRobotHasTheExactZmpOfBothFeet) {
  sensors_.press(Side::left, 0.75 * weight_N(), {0.02, 0.01});
  sensors_.press(Side::right, 0.25 * weight_N(), {-0.02, 0.0});
  ASSERT_TRUE(tick());
  EXPECT_EQ(estimate_.support, 0U);
  EXPECT_EQ(estimate_.contact[0], 1U);
  EXPECT_EQ(estimate_.contact[1], 1U);
  EXPECT_NEAR(estimate_.foot_force[0], 0.75 * weight_N(), 1e-9);
  EXPECT_NEAR(estimate_.foot_zmp[1][0], -0.02, 1e-12);
  EXPECT_NEAR(estimate_.zmp[0], 0.75 * 0.02 + 0.25 * -0.02, 1e-9);
  EXPECT_NEAR(estimate_.zmp[1], 0.75 * 0.01 + 0.25 * -0.10, 1e-9);  // the feet are 100 mm apart
  EXPECT_EQ(estimate_.stamp_ns, now_ns_ - 2'000'000);
}

TEST_F(StateEstimatorTest, ZmpIsWithinFiveMillimetresUnderNoise) {
  std::mt19937 random(37);
  std::normal_distribution<double> force(0.0, humanoid().noise.force_N / std::sqrt(10.0)), tilt(0.0, 0.003);
  for (int i = 0; i < 500; ++i) {
    sensors_.press(Side::left, 0.6 * weight_N(), {0.02, 0.01});
    sensors_.press(Side::right, 0.4 * weight_N(), {-0.02, 0.0});
    for (auto& foot : sensors_.forces.force) {
      for (double& cell : foot) cell += force(random);
    }
    sensors_.imu.inclination[0] = tilt(random);
    sensors_.imu.inclination[1] = tilt(random);
    ASSERT_TRUE(tick());
    EXPECT_NEAR(estimate_.zmp[0], 0.004, 0.005);
    EXPECT_NEAR(estimate_.zmp[1], 0.006 - 0.04, 0.005);
  }
}

TEST_F(StateEstimatorTest, DcmOfASwayingPendulumIsFollowed) {
  std::mt19937 random(41);
  std::normal_distribution<double> noise(0.0, 1.0);
  const double height = SupportKinematics(humanoid()).com_m(Side::left).z();
  const double omega = std::sqrt(test::kGravity_m_per_s2 / height);
  const double frequency = 2.0 * M_PI * 0.8;
  double worst = 0.0, squares = 0.0;
  constexpr int kTicks = 1000, kSettle = 200;
  for (int i = 0; i < kTicks; ++i) {
    const double t = i * 0.01;
    const double com = 0.01 + 0.015 * std::sin(frequency * t);
    const double velocity = 0.015 * frequency * std::cos(frequency * t);
    const double acceleration = -0.015 * frequency * frequency * std::sin(frequency * t);
    lean_to(com);
    const double zmp = com - acceleration / (omega * omega);
    for (const Side side : urdf::kSides) sensors_.press(side, 0.5 * weight_N(), {zmp, 0.0});
    for (auto& foot : sensors_.forces.force) {
      for (double& cell : foot) cell += 0.2 / std::sqrt(10.0) * noise(random);
    }
    const Sensors clean = sensors_;
    sensors_.imu.angular_velocity[1] += 0.01 / std::sqrt(10.0) * noise(random);
    sensors_.imu.inclination[1] += 0.003 * noise(random);
    ASSERT_TRUE(tick());
    sensors_.imu = clean.imu;
    if (i < kSettle) continue;
    const double error = estimate_.dcm[0] - (com + velocity / omega);
    worst = std::max(worst, std::abs(error));
    squares += error * error / (kTicks - kSettle);
  }
  EXPECT_LT(std::sqrt(squares), 0.003);
  EXPECT_LT(worst, 0.008);
}

// The main controller was stopped for a while: what the CoM has moved meanwhile is no fall.
class StateEstimatorGap : public StateEstimatorTest, public ::testing::WithParamInterface<int> {};

TEST_P(StateEstimatorGap, InWhichTheBodyMovedIsNoFall) {
  lean_to(-0.02);
  for (const Side side : urdf::kSides) sensors_.press(side, 0.5 * weight_N(), {-0.02, 0.0});
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(tick());
    sensors_.imu.angular_velocity[1] = 0.0;
  }
  now_ns_ += GetParam() * kTick_ns;
  lean_to(0.04);
  sensors_.imu.angular_velocity[1] = 0.0;
  for (const Side side : urdf::kSides) sensors_.press(side, 0.5 * weight_N(), {0.04, 0.0});
  for (int i = 0; i < 50; ++i) {
    ASSERT_TRUE(tick());
    EXPECT_EQ(estimate_.fall, estimate::fall::upright) << "tick " << i;
    EXPECT_LT(std::abs(estimate_.com_velocity[0]), 0.06 / (0.01 * GetParam()) + 0.05) << "tick " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Slots, StateEstimatorGap, ::testing::Values(8, 20, 60, 500));

TEST_F(StateEstimatorTest, ChangeOfSupportMovesTheFrameAndNotTheRobot) {
  stand(100);
  sensors_.press(Side::left, 0.7 * weight_N(), {0.01, -0.03});
  sensors_.press(Side::right, 0.3 * weight_N(), {0.01, 0.03});
  tick();
  const Estimate before = estimate_;
  ASSERT_EQ(before.support, 0U);
  sensors_.press(Side::left, 0.35 * weight_N(), {0.01, -0.03});
  sensors_.press(Side::right, 0.65 * weight_N(), {0.01, 0.03});
  tick();
  ASSERT_EQ(estimate_.support, 1U);
  EXPECT_NEAR(estimate_.com[1], before.com[1] + 0.1, 0.002);
  EXPECT_NEAR(estimate_.com[0], before.com[0], 0.002);
  EXPECT_NEAR(estimate_.zmp[1], 0.35 * 0.07 + 0.65 * 0.03, 1e-6);
  EXPECT_NEAR(estimate_.com_velocity[1], before.com_velocity[1], 0.02);
}

TEST_F(StateEstimatorTest, NothingIsSaidBeforeEverySensorWasHeard) {
  sensors_.stamp(now_ns_ - 1'000'000'000);  // much too old
  EXPECT_FALSE(update());
  sensors_.stamp(now_ns_);
  sensors_.imu.stamp_ns = now_ns_ - 1'000'000'000;
  EXPECT_FALSE(update());
  EXPECT_TRUE(tick());
}

TEST_F(StateEstimatorTest, StaleImuIsKeptAndSaid) {
  sensors_.imu.inclination[1] = 0.1;
  stand(50);
  const Estimate before = estimate_;
  for (int i = 0; i < 10; ++i) {
    now_ns_ += kTick_ns;
    sensors_.joints.stamp_ns = sensors_.forces.stamp_ns = now_ns_ - 2'000'000;
    ASSERT_TRUE(update());
    EXPECT_TRUE(estimator_.faults().imu_stale);
    EXPECT_FALSE(estimator_.faults().joints_stale);
  }
  EXPECT_EQ(estimate_.stamp_ns, before.stamp_ns);
  EXPECT_EQ(estimate_.attitude[1], before.attitude[1]);
  tick();
  EXPECT_FALSE(estimator_.faults().any());
  EXPECT_EQ(estimate_.stamp_ns, now_ns_ - 2'000'000);
}

// Where nothing moves, it may tell the same for ever.
TEST_F(StateEstimatorTest, AnImuThatAlwaysTellsTheSameOnLegsThatMoveIsStuck) {
  stand(50);
  EXPECT_FALSE(estimator_.faults().any());
  for (int i = 0; i < 20; ++i) {
    sensors_.joints.reference_position[kLeftAnklePitch] += 0.01;
    sensors_.imu.acceleration[0] += 0.01;
    ASSERT_TRUE(tick());
    EXPECT_EQ(estimator_.faults().imu_stale, i >= 14) << i;
  }
  ASSERT_TRUE(tick());
  EXPECT_TRUE(estimator_.faults().imu_stale) << "standing still mends nothing";
  sensors_.imu.angular_velocity[2] += 0.001;
  ASSERT_TRUE(tick());
  EXPECT_FALSE(estimator_.faults().any());
}

TEST_F(StateEstimatorTest, MissingJointKeepsItsPositionAndItsSensorsAreStale) {
  stand(50);
  const Estimate before = estimate_;
  sensors_.joints.missing = 1U << kLeftAnklePitch;
  sensors_.joints.position[kLeftAnklePitch] = 1.0;
  sensors_.press(Side::left, 0.0, {0.0, 0.0});
  for (int i = 0; i < 5; ++i) tick();
  EXPECT_TRUE(estimator_.faults().forces_stale);
  EXPECT_FALSE(estimator_.faults().imu_stale);
  EXPECT_EQ(estimator_.faults().missing, 1U << kLeftAnklePitch);
  EXPECT_NEAR(estimate_.com[0], before.com[0], 0.003);
  EXPECT_EQ(estimate_.contact[0], 1U);
  EXPECT_EQ(estimate_.stamp_ns, before.stamp_ns);
}

TEST_F(StateEstimatorTest, ValuesThatAreNotNumbersAreNotTaken) {
  stand(50);
  sensors_.imu.angular_velocity[0] = std::nan("");
  sensors_.forces.force[1][2] = INFINITY;
  sensors_.joints.position[7] = std::nan("");
  for (int i = 0; i < 20; ++i) tick();
  EXPECT_TRUE(estimator_.faults().imu_stale);
  EXPECT_TRUE(estimator_.faults().forces_stale);
  EXPECT_EQ(estimator_.faults().missing, 1U << 7U);
  for (const double value : estimate_.com) EXPECT_TRUE(std::isfinite(value));
  for (const double value : estimate_.dcm) EXPECT_TRUE(std::isfinite(value));
  for (const double value : estimate_.attitude) EXPECT_TRUE(std::isfinite(value));
}

TEST_F(StateEstimatorTest, EverythingStaleHoldsTheEstimateStill) {
  stand(50);
  const Estimate before = estimate_;
  for (int i = 0; i < 500; ++i) {
    now_ns_ += kTick_ns;
    ASSERT_TRUE(update());
  }
  EXPECT_EQ(estimate_.com[0], before.com[0]);
  EXPECT_EQ(estimate_.dcm[1], before.dcm[1]);
  EXPECT_EQ(estimate_.stamp_ns, before.stamp_ns);
}

TEST_F(StateEstimatorTest, HeadingDoesNotDriftOnceTheBiasIsLearned) {
  sensors_.imu.angular_velocity[2] = 0.0035;
  stand(500);
  const double yaw = estimate_.attitude[2];
  EXPECT_LT(yaw, 0.004);
  EXPECT_NEAR(estimate_.gyro_bias[2], 0.0035, 3.0 * estimate_.gyro_bias_deviation[2]);
  EXPECT_LT(estimate_.gyro_bias_deviation[2], 0.0008);
  for (int i = 0; i < 3000; ++i) {  // on one foot, as in walking
    sensors_.press(Side::left, weight_N(), {0.01, 0.0});
    sensors_.press(Side::right, 0.0, {0.01, 0.0});
    tick();
  }
  EXPECT_NEAR(estimate_.attitude[2], yaw, 0.01);  // 0.105 with the bias
  EXPECT_GT(estimate_.attitude_deviation[2], 0.2 * std::abs(estimate_.attitude[2] - yaw));
}

TEST_F(StateEstimatorTest, JointsThatRattleInTheirPlayDoNotKeepItFromLearning) {
  sensors_.imu.angular_velocity[2] = 0.0035;
  const Sensors still = sensors_;
  sensors_.press(Side::left, 0.5 * weight_N(), {0.01, 0.0});
  sensors_.press(Side::right, 0.5 * weight_N(), {0.01, 0.0});
  for (int i = 0; i < 500; ++i) {
    for (std::size_t joint = 0; joint < 12; ++joint) {
      const double sign = (i + static_cast<int>(joint)) % 3 == 0 ? 1.0 : -1.0;
      sensors_.joints.position[joint] = still.joints.position[joint] + 0.001 * sign;
      sensors_.joints.velocity[joint] = 0.3 * sign;
    }
    sensors_.imu.angular_velocity[1] = i % 2 == 0 ? 0.1 : -0.1;
    tick();
  }
  EXPECT_NEAR(estimate_.gyro_bias[2], 0.0035, 0.0008);
}

TEST_F(StateEstimatorTest, SaysHowUncertainItIs) {
  stand(100);
  for (const double deviation : estimate_.com_deviation) {
    EXPECT_GT(deviation, 0.001);
    EXPECT_LT(deviation, 0.010);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_GT(estimate_.zmp_deviation[axis], 0.0001);
    EXPECT_LT(estimate_.zmp_deviation[axis], 0.005);
    EXPECT_GT(estimate_.dcm_deviation[axis], estimate_.com_deviation[axis]);
    EXPECT_GT(estimate_.attitude_deviation[axis], 0.0);
    EXPECT_LT(estimate_.attitude_deviation[axis], 0.008) << "a second of a pendulum at rest";
  }
}

TEST_F(StateEstimatorTest, DeadCellChangesNeitherZmpNorContact) {
  stand(20);
  for (int i = 0; i < 100; ++i) {
    sensors_.press(Side::left, 0.5 * weight_N(), {0.01, 0.0});
    sensors_.forces.force[0][1] = 0.0;
    tick();
  }
  EXPECT_TRUE(estimator_.cells().is_dead(Side::left, 1));
  EXPECT_NEAR(estimate_.foot_force[0], 0.5 * weight_N(), 1e-6);
  EXPECT_NEAR(estimate_.foot_zmp[0][0], 0.01, 1e-6);
  EXPECT_NEAR(estimate_.foot_zmp[0][1], 0.0, 1e-6);
}

TEST_F(StateEstimatorTest, SlipOfALoadedFootShows) {
  for (auto& foot : sensors_.forces.acceleration) foot[2] = 9.81;
  stand(100);
  EXPECT_LT(estimate_.slip_speed[0], 0.001);
  sensors_.forces.acceleration[1][0] = 5.0;
  for (int i = 0; i < 4; ++i) tick();
  EXPECT_NEAR(estimate_.slip_speed[1], 0.2, 0.04);
  EXPECT_LT(estimate_.slip_speed[0], 0.001);
}

// The estimate is in the frame of the foot: how far the robot has come is nowhere in it.
TEST_F(StateEstimatorTest, AKilometreLaterItSaysTheSameOfAStep) {
  const auto step = [this](Side from) {
    const Side to = from == Side::left ? Side::right : Side::left;
    for (const double share : {0.0, 0.5, 1.0, 1.0}) {
      sensors_.press(from, (1.0 - share) * weight_N(), {0.01, 0.0});
      sensors_.press(to, share * weight_N(), {0.01, 0.0});
      tick();
    }
  };
  for (int i = 0; i < 4000; ++i) {  // until what it learns has settled
    step(Side::right);
    step(Side::left);
  }
  const Estimate early = estimate_;
  for (int i = 0; i < 5000; ++i) {  // 10,000 steps of 0.1 m
    step(Side::right);
    step(Side::left);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(estimate_.com[axis], early.com[axis], 1e-6);
    EXPECT_NEAR(estimate_.dcm[axis], early.dcm[axis], 1e-6);
    EXPECT_NEAR(estimate_.zmp[axis], early.zmp[axis], 1e-6);
    EXPECT_NEAR(estimate_.dcm_deviation[axis], early.dcm_deviation[axis], 1e-6);
    EXPECT_NEAR(estimate_.attitude[axis], early.attitude[axis], 1e-6);
  }
}

// Time is whole nanoseconds, and only its differences count.
TEST_F(StateEstimatorTest, ThirtyDaysOfUptimeChangeNothing) {
  constexpr std::int64_t kThirtyDays_ns = std::int64_t{30} * 86'400 * 1'000'000'000;
  StateEstimator late{humanoid(), EstimatorParameters{}};
  std::mt19937 random(43);
  std::normal_distribution<double> noise(0.0, 0.003);
  for (int i = 0; i < 300; ++i) {
    sensors_.press(Side::left, (i % 40 < 20 ? 0.9 : 0.2) * weight_N(), {0.01, 0.0});
    sensors_.press(Side::right, (i % 40 < 20 ? 0.1 : 0.8) * weight_N(), {0.01, 0.0});
    for (double& rate : sensors_.imu.angular_velocity) rate = noise(random);
    for (double& tilt : sensors_.imu.inclination) tilt = noise(random);
    ASSERT_TRUE(tick());
    const std::int64_t stamp_ns = sensors_.joints.stamp_ns;
    sensors_.stamp(stamp_ns + kThirtyDays_ns);
    Estimate estimate{};
    ASSERT_TRUE(
        late.update(now_ns_ + kThirtyDays_ns, sensors_.joints, sensors_.forces, sensors_.imu, estimate));
    EXPECT_EQ(estimate.stamp_ns, estimate_.stamp_ns + kThirtyDays_ns);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_EQ(estimate.dcm[axis], estimate_.dcm[axis]);
      EXPECT_EQ(estimate.zmp[axis], estimate_.zmp[axis]);
    }
    EXPECT_EQ(estimate.attitude[2], estimate_.attitude[2]);
  }
}

TEST_F(StateEstimatorTest, RobotInTheAirHasNoContact) {
  stand(20);
  sensors_.press(Side::left, 0.0, {0.0, 0.0});
  sensors_.press(Side::right, 0.0, {0.0, 0.0});
  for (int i = 0; i < 50; ++i) tick();
  EXPECT_EQ(estimate_.contact[0] + estimate_.contact[1], 0U);
  for (const double value : estimate_.dcm) EXPECT_TRUE(std::isfinite(value));
}

class WithoutInclinometer : public StateEstimatorTest {
 protected:
  static urdf::RobotModel model() {
    urdf::RobotModel model = humanoid();
    for (auto& joint : model.channels) {
      for (auto& channel : joint) {
        if (channel.kind == urdf::SensorKind::inclination) channel.kind = urdf::SensorKind::none;
      }
    }
    return model;
  }
  void feel(const Eigen::Vector3d& specific_force, int ticks) {
    Eigen::Map<Eigen::Vector3d>(sensors_.imu.acceleration) = specific_force;
    for (int i = 0; i < ticks; ++i) {
      now_ns_ += kTick_ns;
      sensors_.stamp(now_ns_);
      ASSERT_TRUE(blind_.update(now_ns_, sensors_.joints, sensors_.forces, sensors_.imu, estimate_));
    }
  }
  static Eigen::Vector3d at_rest(const Attitude& attitude) {
    return attitude.tilt().transpose() * Eigen::Vector3d(0, 0, 9.81);
  }
  StateEstimator blind_{model(), EstimatorParameters{}};
};

TEST_F(WithoutInclinometer, BeginsWithLevelSolesHoweverItIsShaken) {
  feel({-1.2, 0.4, 9.5}, 10);
  EXPECT_NEAR(estimate_.attitude[0], 0.0, 0.01);
  EXPECT_NEAR(estimate_.attitude[1], 0.0, 0.015);
}

TEST_F(WithoutInclinometer, ComesToWhatTheAccelerometerSaysAllTheTime) {
  feel(at_rest({0.05, -0.08, 0.0}), 2000);
  EXPECT_NEAR(estimate_.attitude[0], 0.05, 0.01);
  EXPECT_NEAR(estimate_.attitude[1], -0.08, 0.01);
}

TEST_F(WithoutInclinometer, OneThatLiesKnowsItAtOnce) {
  feel(at_rest({0.1, 1.4, 0.0}), 1);
  EXPECT_NEAR(estimate_.attitude[0], 0.1, 1e-6);
  EXPECT_NEAR(estimate_.attitude[1], 1.4, 1e-6);
}

// What it reckons goes the way of what cells tell.
TEST(WithoutFootSensors, StandsOnBothFeetByAccelerometerAndLegs) {
  urdf::RobotModel model = humanoid();
  for (urdf::Foot& foot : model.feet) foot.sensor = urdf::FootSensor::none;
  StateEstimator estimator(model, EstimatorParameters{});
  Sensors sensors;
  Estimate estimate{};
  for (std::int64_t now_ns = kTick_ns; now_ns < 50 * kTick_ns; now_ns += kTick_ns) {
    sensors.stamp(now_ns);
    sensors.forces.stamp_ns = 0;  // they never come
    ASSERT_TRUE(estimator.update(now_ns, sensors.joints, sensors.forces, sensors.imu, estimate));
  }
  EXPECT_FALSE(estimator.faults().forces_stale);
  for (std::size_t foot = 0; foot < 2; ++foot) {
    EXPECT_EQ(estimate.contact[foot], 1U);
    EXPECT_NEAR(estimate.foot_force[foot], 0.5 * weight_N(), 0.02 * weight_N());
  }
  EXPECT_NEAR(estimate.zmp[0], estimate.com[0], 0.002);
  EXPECT_GT(estimate.zmp_deviation[0], 0.009);
}

TEST_F(StateEstimatorTest, UpdateDoesNotAllocate) {
  stand(5);
  const long before = gaitway::test::allocation_count();
  for (int i = 0; i < 100; ++i) {
    sensors_.press(i % 20 < 10 ? Side::left : Side::right, (i % 10) * 0.1 * weight_N(), {0.0, 0.0});
    tick();
  }
  EXPECT_EQ(gaitway::test::allocation_count() - before, 0);
}

TEST(EstimatorParametersTest, BadValuesAreRefusedByName) {
  EstimatorParameters parameters;
  parameters.contact_off_share = 0.2;
  try {
    StateEstimator estimator(humanoid(), parameters);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("contact_off_share is 0.2"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace gaitway::zmp
