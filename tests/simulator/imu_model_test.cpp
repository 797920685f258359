// The simulated IMU against its own specification.
#include "imu_model.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace gaitway::simulator {
namespace {

constexpr double kStep_s = 0.001;
constexpr double kGravity = facts::kGravity_m_per_s2;
const Eigen::Vector3d kRest(0.0, 0.0, kGravity);
const Eigen::Vector3d kNone = Eigen::Vector3d::Zero();

// σ of what so many parts have, by `drawn`.
template <class Drawn>
double deviation(const Drawn& drawn, double mean) {
  constexpr int kParts = 600;
  double squares = 0.0;
  int values = 0;
  for (std::uint64_t seed = 1; seed <= kParts; ++seed) {
    const ImuModel part(seed, 1.0, kStep_s);
    drawn(part, [&](double value) {
      squares += (value - mean) * (value - mean);
      ++values;
    });
  }
  return std::sqrt(squares / values);
}

ImuModel::Reading after(ImuModel& imu, double seconds, const Eigen::Vector3d& turn,
                        const Eigen::Vector3d& force) {
  ImuModel::Reading read{};
  for (long i = 0; i < std::lround(seconds / kStep_s); ++i) read = imu.step(turn, force);
  return read;
}

TEST(ImuModel, WithoutDeviationsTellsWhatIs) {
  ImuModel imu(3, 0.0, kStep_s);
  imu.settle(kRest);
  const Eigen::Vector3d turn(0.3, -0.2, 1.0);
  const ImuModel::Reading read = after(imu, 1.0, turn, kRest);
  EXPECT_EQ(read.angular_velocity_rad_per_s, turn);
  EXPECT_EQ(read.acceleration_m_per_s2, kRest);
  EXPECT_EQ(read.inclination_rad, Eigen::Vector2d::Zero());
  EXPECT_EQ(imu.mounting(), Eigen::Matrix3d::Identity());
}

TEST(ImuModel, IsMountedOneDegreeAskew) {
  Eigen::Vector3d axes = Eigen::Vector3d::Zero();
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Eigen::AngleAxisd turn(ImuModel(seed, 1.0, kStep_s).mounting());
    EXPECT_NEAR(turn.angle(), facts::kRadPerDegree, 1e-9);
    EXPECT_NEAR(Eigen::AngleAxisd(ImuModel(seed, 0.5, kStep_s).mounting()).angle(),
                0.5 * facts::kRadPerDegree, 1e-9);
    axes += turn.axis();
  }
  EXPECT_LT(axes.norm() / 200.0, 0.2) << "about any axis";
}

TEST(ImuModel, PartsDifferAsTheyAreSaidTo) {
  const ImuDeviations said;
  const auto diagonal = [](const Eigen::Matrix3d& m, const auto& take) {
    for (Eigen::Index i = 0; i < 3; ++i) take(m(i, i));
  };
  const auto beside = [](const Eigen::Matrix3d& m, const auto& take) {
    for (Eigen::Index i = 0; i < 9; ++i) {
      if (i % 4 != 0) take(m(i / 3, i % 3));
    }
  };
  const auto all = [](const auto& values, const auto& take) {
    for (const double value : values.reshaped()) take(value);
  };
  const auto expect = [](double measured, double wanted) { EXPECT_NEAR(measured, wanted, 0.08 * wanted); };
  using Part = const ImuModel&;
  expect(deviation([&](Part p, auto t) { diagonal(p.truth().gyro_sensitivity, t); }, 1.0), said.gyro_scale);
  expect(deviation([&](Part p, auto t) { beside(p.truth().gyro_sensitivity, t); }, 0.0), said.gyro_axis_rad);
  expect(deviation([&](Part p, auto t) { all(p.truth().gyro_per_acceleration_s_per_m, t); }, 0.0),
         said.gyro_per_acceleration_s_per_m);
  expect(deviation([&](Part p, auto t) { diagonal(p.truth().accelerometer_sensitivity, t); }, 1.0),
         said.accelerometer_scale);
  expect(deviation([&](Part p, auto t) { beside(p.truth().accelerometer_sensitivity, t); }, 0.0),
         said.accelerometer_axis_rad);
  expect(deviation([&](Part p, auto t) { all(p.truth().accelerometer_zero_m_per_s2, t); }, 0.0),
         said.accelerometer_zero_m_per_s2);
  expect(deviation([&](Part p, auto t) { all(p.truth().inclinometer_zero_rad, t); }, 0.0),
         said.inclinometer_zero_rad);
  expect(deviation([&](Part p, auto t) { all(p.truth().inclinometer_cross_axis, t); }, 0.0),
         said.inclinometer_cross_axis);
}

TEST(ImuModel, TellsByItsTruth) {
  ImuModel imu(5, 1.0, kStep_s);
  imu.settle(kRest);
  const Eigen::Vector3d turn(0.3, -0.2, 1.0), force(1.0, 2.0, 9.0);
  const ImuModel::Reading read = imu.step(turn, force);
  const ImuTruth& truth = imu.truth();
  EXPECT_TRUE(read.angular_velocity_rad_per_s.isApprox(truth.gyro_sensitivity * turn +
                                                       truth.gyro_per_acceleration_s_per_m * force +
                                                       imu.walked_bias_rad_per_s()));
  EXPECT_TRUE(read.acceleration_m_per_s2.isApprox(truth.accelerometer_sensitivity * force +
                                                  truth.accelerometer_zero_m_per_s2));
}

TEST(ImuModel, TheGyrosBiasWalksByTheRootOfTime) {
  constexpr double kTime_s = 10.0;
  constexpr int kParts = 200;
  double squares = 0.0;
  for (std::uint64_t seed = 1; seed <= kParts; ++seed) {
    ImuModel imu(seed, 1.0, kStep_s);
    imu.settle(kRest);
    after(imu, kTime_s, kNone, kRest);
    squares += imu.walked_bias_rad_per_s().squaredNorm() / (3.0 * kParts);
  }
  const double said = ImuDeviations{}.gyro_walk_rad_per_s_rts * std::sqrt(kTime_s);
  EXPECT_NEAR(std::sqrt(squares), said, 0.1 * said);
}

TEST(Inclinometer, TakesAnAccelerationForATilt) {
  ImuModel imu(1, 0.0, kStep_s);
  imu.settle(kRest);
  const ImuModel::Reading read = after(imu, 1.0, kNone, {2.0, 0.0, kGravity});
  EXPECT_NEAR(read.inclination_rad.y(), -std::atan2(2.0, kGravity), 1e-6);
  EXPECT_NEAR(read.inclination_rad.x(), 0.0, 1e-9);
}

// A second-order low-pass: its amplitude at the natural frequency is 1 / (2 ζ), a quarter of a period late.
TEST(Inclinometer, IsADampedPendulum) {
  const InclinometerPendulum said;
  ImuModel imu(1, 0.0, kStep_s);
  imu.settle(kRest);
  const double frequency = said.natural_frequency_rad_per_s, tilt_rad = 0.01;
  double sine = 0.0, cosine = 0.0;
  const double period_s = 2.0 * std::numbers::pi / frequency;
  const long settle = std::lround(10.0 * period_s / kStep_s), steps = std::lround(40.0 * period_s / kStep_s);
  for (long i = 0; i < settle + steps; ++i) {
    const double phase = frequency * kStep_s * static_cast<double>(i);
    const double roll = tilt_rad * std::sin(phase);
    const ImuModel::Reading read =
        imu.step(kNone, {0.0, kGravity * std::sin(roll), kGravity * std::cos(roll)});
    if (i < settle) continue;
    sine += 2.0 * read.inclination_rad.x() * std::sin(phase) / static_cast<double>(steps);
    cosine += 2.0 * read.inclination_rad.x() * std::cos(phase) / static_cast<double>(steps);
  }
  EXPECT_NEAR(std::hypot(sine, cosine) / tilt_rad, 1.0 / (2.0 * said.damping_ratio), 0.05);
  EXPECT_NEAR(std::atan2(-cosine, sine), std::numbers::pi / 2.0, 0.1);
}

TEST(Inclinometer, RollsOnOverHalfATurn) {
  ImuModel imu(1, 0.0, kStep_s);
  imu.settle({0.0, kGravity * std::sin(3.0), kGravity * std::cos(3.0)});
  double roll = 3.0, largest_rad = 0.0;
  for (int i = 0; i < 300; ++i) {
    roll += 0.001;  // 1 rad/s, over half a turn after 0.14 s
    const double told =
        imu.step(kNone, {0.0, kGravity * std::sin(roll), kGravity * std::cos(roll)}).inclination_rad.x();
    largest_rad = std::max(largest_rad, std::abs(std::remainder(told - roll, 2.0 * std::numbers::pi)));
  }
  EXPECT_LT(largest_rad, 0.05) << "28 ms late";
}

TEST(Inclinometer, GoesOnInFreeFall) {
  ImuModel imu(1, 0.0, kStep_s);
  imu.settle({0.0, kGravity * std::sin(0.2), kGravity * std::cos(0.2)});
  EXPECT_NEAR(after(imu, 0.5, kNone, kNone).inclination_rad.x(), 0.2, 1e-9) << "nothing pulls at it";
}

TEST(ImuModel, OneSeedIsOnePart) {
  ImuModel one(9, 1.0, kStep_s), same(9, 1.0, kStep_s), other(10, 1.0, kStep_s);
  for (ImuModel* imu : {&one, &same, &other}) imu->settle(kRest);
  const Eigen::Vector3d turn(0.1, 0.2, 0.3);
  EXPECT_EQ(after(one, 0.1, turn, kRest).angular_velocity_rad_per_s,
            after(same, 0.1, turn, kRest).angular_velocity_rad_per_s);
  EXPECT_NE(one.truth().gyro_sensitivity, other.truth().gyro_sensitivity);
}

}  // namespace
}  // namespace gaitway::simulator
