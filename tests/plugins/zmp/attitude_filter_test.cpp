// Attitude from gyro and tilt.
#include "gaitway/zmp/attitude_filter.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/tilt.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gaitway::zmp {
namespace {

using facts::kSlot_s;

// Roll, pitch, yaw with R = Rz Ry Rx.
Eigen::Vector3d euler_of(const Eigen::Matrix3d& r) {
  return {std::atan2(r(2, 1), r(2, 2)), std::asin(-r(2, 0)), std::atan2(r(1, 0), r(0, 0))};
}

constexpr double kTiltNoise_rad = 0.001;
constexpr double kDegree = M_PI / 180.0;

// A trunk that turns; the truth and what its sensors say.
struct Trunk {
  explicit Trunk(unsigned seed) : random(seed) {}

  Eigen::Vector3d noise(double deviation) {
    return deviation * Eigen::Vector3d(normal(random), normal(random), normal(random));
  }
  void turn(const Eigen::Vector3d& rate) {
    const Eigen::Matrix3d half = by(0.5 * kSlot_s * rate);
    tilt = euler_of(rotation * half).head<2>();
    rotation = (rotation * half * half).eval();
    yaw += std::remainder(euler_of(rotation).z() - yaw, 2.0 * M_PI);
    gyro = rate + bias;
  }
  static Eigen::Matrix3d by(const Eigen::Vector3d& turn) {
    return turn.norm() < 1e-12 ? Eigen::Matrix3d::Identity().eval()
                               : Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  }

  std::mt19937 random;
  std::normal_distribution<double> normal{0.0, 1.0};
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double yaw = 0.0;
  Eigen::Vector3d bias = Eigen::Vector3d::Zero(), gyro = Eigen::Vector3d::Zero();
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();  // in the middle of the slot
};

TEST(AttitudeFilter, TakesTheFirstMeasuredTiltAndDrawsToLaterOnes) {
  AttitudeFilter filter{EstimatorParameters{}};
  filter.predict(Eigen::Vector3d::Zero(), kSlot_s);
  filter.correct_tilt({0.1, -0.05}, kTiltNoise_rad);
  EXPECT_NEAR(filter.attitude().roll_rad, 0.1, 1e-12);
  EXPECT_NEAR(filter.attitude().pitch_rad, -0.05, 1e-12);
  for (int i = 0; i < 500; ++i) {
    filter.predict(Eigen::Vector3d::Zero(), kSlot_s);
    filter.correct_tilt({0.0, 0.0}, kTiltNoise_rad);
  }
  EXPECT_NEAR(filter.attitude().roll_rad, 0.0, 0.02 * kDegree);
  EXPECT_NEAR(filter.attitude().pitch_rad, 0.0, 0.02 * kDegree);
}

TEST(AttitudeFilter, IntegratesTurnsInSpaceWithoutMeasuredTilt) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> phase(0.0, 6.28);
  for (int run = 0; run < 20; ++run) {
    AttitudeFilter filter{EstimatorParameters{}};
    Trunk trunk(1);
    const Eigen::Vector3d start(phase(random), phase(random), phase(random));
    for (int i = 0; i < 200; ++i) {
      trunk.turn(((start.array() + 0.07 * i).sin() * Eigen::Array3d(0.8, 0.6, 1.0)).matrix());
      filter.predict(trunk.gyro, kSlot_s);
    }
    const Eigen::Vector3d expected = euler_of(trunk.rotation);
    EXPECT_NEAR(filter.attitude().roll_rad, expected.x(), 1e-9);
    EXPECT_NEAR(filter.attitude().pitch_rad, expected.y(), 1e-9);
    EXPECT_NEAR(filter.attitude().yaw_rad, trunk.yaw, 1e-9);
  }
}

TEST(AttitudeFilter, FollowsASwayWithinAFiftiethOfADegreeDespiteNoiseAndBias) {
  Trunk trunk(17);
  trunk.bias = {0.0035, -0.0035, 0.0};
  AttitudeFilter filter{EstimatorParameters{}};
  double squares = 0.0, normalised = 0.0;
  constexpr int kTicks = 3000, kSettle = 1000;
  for (int i = 0; i < kTicks; ++i) {
    const double t = i * kSlot_s;
    trunk.turn({0.4 * std::cos(8.0 * t), 0.15 * std::cos(5.0 * t), 0.2 * std::cos(3.0 * t)});
    filter.predict(trunk.gyro + trunk.noise(0.01 / std::sqrt(10.0)), kSlot_s);
    filter.correct_tilt(trunk.tilt + trunk.noise(kTiltNoise_rad).head<2>(), kTiltNoise_rad);
    if (i < kSettle) continue;
    const Eigen::Vector2d error = Eigen::Vector2d(filter.attitude().roll_rad, filter.attitude().pitch_rad) -
                                  euler_of(trunk.rotation).head<2>();
    squares += error.squaredNorm() / 2.0 / (kTicks - kSettle);
    normalised += error.cwiseQuotient(filter.attitude_deviation_rad().head<2>()).squaredNorm() / 2.0 /
                  (kTicks - kSettle);
  }
  EXPECT_LT(std::sqrt(squares), 0.02 * kDegree);
  EXPECT_GT(std::sqrt(normalised), 0.5);
  EXPECT_LT(std::sqrt(normalised), 2.0);
}

// A robot that stands for ten seconds, still or swaying and turning over its feet, and then walks for a
// minute.
struct Drift {
  double bias_error = 0.0, bias_deviation = 0.0, yaw_error = 0.0, yaw_deviation = 0.0;
};

Drift drift_after_standing(unsigned seed, double sway_rad_per_s) {
  Trunk trunk(seed);
  trunk.bias = trunk.noise(0.2 * kDegree);
  AttitudeFilter filter{EstimatorParameters{}};
  Drift drift;
  for (int i = 0; i < 7000; ++i) {
    const double t = i * kSlot_s;
    trunk.turn({0.0, 0.0, i < 1000 ? sway_rad_per_s * std::cos(4.0 * t) : 0.3 * std::cos(8.0 * t)});
    filter.predict(trunk.gyro + trunk.noise(0.01 / std::sqrt(10.0)), kSlot_s);
    filter.correct_tilt(trunk.tilt + trunk.noise(kTiltNoise_rad).head<2>(), kTiltNoise_rad);
    if (i < 1000) filter.hold_heading(-trunk.yaw + trunk.noise(0.0005).x(), 0.0001, kSlot_s);
    if (i == 1000) filter.release_heading();
  }
  drift.bias_error = filter.bias_rad_per_s().z() - trunk.bias.z();
  drift.bias_deviation = filter.bias_deviation_rad_per_s().z();
  drift.yaw_error = filter.attitude().yaw_rad - trunk.yaw;
  drift.yaw_deviation = filter.attitude_deviation_rad().z();
  return drift;
}

TEST(AttitudeFilter, LearnsTheGyrosBiasOverFeetThatStandWhetherTheTrunkSwaysOrNot) {
  for (const double sway : {0.0, 0.3}) {
    double squares = 0.0, of_bias = 0.0, of_yaw = 0.0;
    constexpr int kRuns = 12;
    for (unsigned seed = 1; seed <= kRuns; ++seed) {
      const Drift drift = drift_after_standing(seed, sway);
      squares += drift.yaw_error * drift.yaw_error / kRuns;
      of_bias += std::pow(drift.bias_error / drift.bias_deviation, 2) / kRuns;
      of_yaw += std::pow(drift.yaw_error / drift.yaw_deviation, 2) / kRuns;
    }
    EXPECT_LT(std::sqrt(squares), 0.5 * kDegree);  // 12 degrees with the bias
    EXPECT_LT(std::sqrt(of_bias), 1.6);            // a chi distribution's 99 %
    EXPECT_LT(std::sqrt(of_yaw), 1.6);
    EXPECT_GT(std::sqrt(of_yaw), 0.3);
  }
}

TEST(AttitudeFilter, CreepingFeetTeachLess) {
  AttitudeFilter firm{EstimatorParameters{}}, creeping{EstimatorParameters{}};
  for (int i = 0; i < 500; ++i) {
    for (AttitudeFilter* filter : {&firm, &creeping}) filter->predict({0.0, 0.0, 0.002}, kSlot_s);
    firm.hold_heading(0.0, 0.0001, kSlot_s);
    creeping.hold_heading(0.0, 0.01, kSlot_s);
  }
  EXPECT_LT(5.0 * firm.bias_deviation_rad_per_s().z(), creeping.bias_deviation_rad_per_s().z());
  EXPECT_NEAR(firm.bias_rad_per_s().z(), 0.002, 0.0003);
}

TEST(AttitudeFilter, HeadingIsLessCertainAfterSamplesThatWereNotHeard) {
  AttitudeFilter heard{EstimatorParameters{}}, deaf{EstimatorParameters{}};
  heard.predict(Eigen::Vector3d::Zero(), 0.05);
  deaf.predict(Eigen::Vector3d::Zero(), 0.05, 0.04);
  EXPECT_GT(deaf.attitude_deviation_rad().z(), 10.0 * heard.attitude_deviation_rad().z());
}

TEST(AttitudeFilter, YawGoesOnBeyondATurnAndComesBackBeforeTheTopicsLimit) {
  AttitudeFilter filter{EstimatorParameters{}};
  for (int i = 0; i < 1000; ++i) filter.predict({0.0, 0.0, 1.0}, kSlot_s);
  EXPECT_NEAR(filter.attitude().yaw_rad, 10.0, 1e-9);
  double turned = 10.0;
  for (int i = 0; i < 10000; ++i) {
    filter.predict({0.0, 0.0, 2.0}, 1.0);  // as in five hours of turning
    turned += 2.0;
    ASSERT_LT(std::abs(filter.attitude().yaw_rad), 1e4);
  }
  EXPECT_NEAR(std::remainder(filter.attitude().yaw_rad - turned, 2.0 * M_PI), 0.0, 1e-6);
}

TEST(AttitudeFilter, ThirtyDaysLaterItIsAsGoodAsAtTheStart) {
  // Thirty days of walking in steps of ten seconds: what time alone does to the uncertainty.
  const EstimatorParameters parameters;
  AttitudeFilter filter(parameters);
  for (int i = 0; i < 259'200; ++i) {
    filter.predict({0.001, -0.002, 0.0005}, 10.0);
    filter.correct_tilt({0.01, 0.02}, kTiltNoise_rad);
  }
  EXPECT_NEAR(filter.attitude().roll_rad, 0.01, 0.01);
  EXPECT_LE(filter.bias_deviation_rad_per_s().maxCoeff(), parameters.bias_deviation_rad_per_s * 1.001);
  EXPECT_LE(filter.attitude_deviation_rad().z(), M_PI * 1.001);
  // It learns a bias and holds a heading as a new one does.
  AttitudeFilter fresh(parameters);
  double heading = 0.0;
  for (int i = 0; i < 1000; ++i) {
    if (i == 500) heading = filter.attitude().yaw_rad;
    for (AttitudeFilter* each : {&filter, &fresh}) {
      each->predict({0.001, -0.002, 0.003}, kSlot_s);
      each->correct_tilt({0.0, 0.0}, kTiltNoise_rad);
      each->hold_heading(0.0, 0.0001, kSlot_s);
    }
  }
  EXPECT_NEAR(filter.bias_rad_per_s().z(), 0.003, 2e-4);
  EXPECT_NEAR(fresh.bias_rad_per_s().z(), 0.003, 2e-4);
  EXPECT_NEAR(filter.attitude().roll_rad, 0.0, 1e-4);
  EXPECT_NEAR(filter.bias_deviation_rad_per_s().z(), fresh.bias_deviation_rad_per_s().z(), 1e-6);
  EXPECT_NEAR(filter.attitude().yaw_rad, heading, 0.02);
}

// What a walking trunk feels: ahead and upwards at once, back and downwards at once. The angles of such
// forces have another mean than the forces.
TEST(AttitudeFilter, KeepsUprightWhileTheTrunkIsAcceleratedToAndFro) {
  constexpr double kRestless_rad = 0.2;
  AttitudeFilter filter{EstimatorParameters{}};
  filter.correct_tilt({0.0, 0.0}, kRestless_rad);
  Eigen::Vector2d angles = Eigen::Vector2d::Zero();
  constexpr int kSlots = 32 * 250;  // 80 s
  for (int i = 0; i < kSlots; ++i) {
    const double swing = std::cos(2.0 * M_PI * i / 32.0);
    const Eigen::Vector3d force_g(0.25 * swing, -0.15 * swing, 1.0 + 0.3 * swing);
    angles += geometry::tilt_at_rest(force_g) / kSlots;
    filter.predict(Eigen::Vector3d::Zero(), kSlot_s);
    filter.correct_by_force(force_g, kRestless_rad);
  }
  EXPECT_GT(angles.norm(), 0.03) << "else this tells nothing";
  EXPECT_NEAR(filter.attitude().roll_rad, 0.0, 0.003);
  EXPECT_NEAR(filter.attitude().pitch_rad, 0.0, 0.003);
}

// Largest tilt that the filter believes of an upright walking trunk, in the ten seconds after its gyro was
// knocked.
double largest_lean_after_a_knock_rad(double bias_walk_rad_per_s_rts) {
  EstimatorParameters parameters;
  parameters.bias_walk_rad_per_s_rts = bias_walk_rad_per_s_rts;
  AttitudeFilter filter(parameters);
  filter.correct_tilt({0.0, 0.0}, 0.02);
  double largest_rad = 0.0;
  constexpr int kKnocked = 2000, kEnd = 3000;
  for (int i = 0; i < kEnd; ++i) {
    const double swing = std::cos(2.0 * M_PI * i / 32.0);
    filter.predict(i < kKnocked ? Eigen::Vector3d::Zero() : Eigen::Vector3d(0.05, -0.05, 0.05), kSlot_s);
    filter.correct_by_force({0.25 * swing, -0.15 * swing, 1.0 + 0.3 * swing}, 0.2);
    if (i < kKnocked) continue;
    largest_rad =
        std::max({largest_rad, std::abs(filter.attitude().roll_rad), std::abs(filter.attitude().pitch_rad)});
  }
  return largest_rad;
}

TEST(AttitudeFilter, ABiasThatComesAtOnceIsLearnedBeforeTheTrunkSeemsToLeanFar) {
  EXPECT_GT(largest_lean_after_a_knock_rad(0.0), 0.2) << "else this tells nothing";
  EXPECT_LT(largest_lean_after_a_knock_rad(0.003), 0.1);
}

TEST(AttitudeFilter, TheBiasAboutTheVerticalDoesNotWalk) {
  EstimatorParameters parameters;
  parameters.bias_walk_rad_per_s_rts = 0.003;
  AttitudeFilter filter(parameters);
  for (int i = 0; i < 1000; ++i) filter.predict(Eigen::Vector3d::Zero(), kSlot_s);
  EXPECT_GT(filter.bias_deviation_rad_per_s().x(), 0.009);
  EXPECT_LE(filter.bias_deviation_rad_per_s().z(), parameters.bias_deviation_rad_per_s * 1.001);
}

TEST(TiltOfAcceleration, InvertsTheGravityThatATiltedTrunkFeels) {
  std::mt19937 random(19);
  std::uniform_real_distribution<double> angle(-0.5, 0.5);
  for (int i = 0; i < 500; ++i) {
    Attitude attitude;
    attitude.roll_rad = angle(random);
    attitude.pitch_rad = angle(random);
    const auto tilt =
        tilt_of_acceleration(attitude.tilt().transpose() * Eigen::Vector3d(0.0, 0.0, 9.81), 1.0);
    ASSERT_TRUE(tilt);
    EXPECT_NEAR(tilt->x(), attitude.roll_rad, 1e-12);
    EXPECT_NEAR(tilt->y(), attitude.pitch_rad, 1e-12);
  }
}

TEST(TiltOfAcceleration, SaysNothingWhileTheTrunkIsAccelerated) {
  EXPECT_FALSE(tilt_of_acceleration({0.0, 0.0, 12.0}, 1.0));
  EXPECT_FALSE(tilt_of_acceleration({0.0, 0.0, 0.3}, 1.0));
  EXPECT_FALSE(tilt_of_acceleration({std::nan(""), 0.0, 9.81}, 1.0));
}

}  // namespace
}  // namespace gaitway::zmp
