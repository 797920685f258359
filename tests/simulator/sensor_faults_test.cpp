// Sensors that tell something else than what is.
#include "gaitway/simulator/sensor_faults.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace gaitway::simulator {
namespace {

constexpr std::int64_t kMs = 1'000'000;

class SensorFaultsTest : public testing::Test {
 protected:
  [[nodiscard]] PlantSensors truth(double value) const {
    PlantSensors sensors;
    sensors.encoder_count.assign(robot_.joints.size(), static_cast<std::int32_t>(value));
    sensors.angular_velocity_rad_per_s.setConstant(value);
    sensors.acceleration_m_per_s2.setConstant(value);
    sensors.inclination_rad.setConstant(value);
    for (auto& foot : sensors.force_N) foot.fill(value);
    return sensors;
  }
  void begin(const std::string& sensor, SensorFault::How how, double duration_s, double value = 5.0) {
    faults_.begin({.sensor = sensor, .how = how, .duration_s = duration_s}, truth(value), 0);
  }

  urdf::RobotModel robot_ = urdf::load_robot(GAITWAY_ROBOT);
  SensorFaults faults_{robot_, 1};
};

TEST_F(SensorFaultsTest, WithoutAFaultTheTruthIsTold) {
  const PlantSensors now = truth(7.0);
  EXPECT_EQ(&faults_.told(now, 0), &now);
}

TEST_F(SensorFaultsTest, AFrozenOneTellsWhatItToldAndNoOtherDoes) {
  begin("imu", SensorFault::How::freezes, 0.01);
  const PlantSensors told = faults_.told(truth(7.0), 9 * kMs);
  EXPECT_EQ(told.angular_velocity_rad_per_s.x(), 5.0);
  EXPECT_EQ(told.acceleration_m_per_s2.z(), 5.0);
  EXPECT_EQ(told.inclination_rad.y(), 5.0);
  EXPECT_EQ(told.force_N[0][0], 7.0);
  EXPECT_EQ(told.encoder_count[3], 7);
  const PlantSensors later = truth(8.0);
  EXPECT_EQ(&faults_.told(later, 10 * kMs), &later) << "its time is over";
}

TEST_F(SensorFaultsTest, AFootReadsZeroForEver) {
  begin("right_foot", SensorFault::How::reads_zero, 0.0);
  const PlantSensors told = faults_.told(truth(7.0), 1'000'000 * kMs);
  EXPECT_EQ(told.force_N[1][2], 0.0);
  EXPECT_EQ(told.force_N[0][2], 7.0);
}

TEST_F(SensorFaultsTest, AnEncoderOfOneJointFails) {
  const auto knee = static_cast<std::size_t>(robot_.joint_index("left_knee"));
  begin("left_knee", SensorFault::How::freezes, 1.0);
  const PlantSensors told = faults_.told(truth(7.0), kMs);
  EXPECT_EQ(told.encoder_count[knee], 5);
  EXPECT_EQ(told.encoder_count[knee + 1], 7);
}

TEST_F(SensorFaultsTest, ANoisyOneScattersAroundTheTruth) {
  begin("imu", SensorFault::How::noisy, 10.0);
  double sum = 0.0, squares = 0.0;
  constexpr int kCount = 4000;
  for (int i = 0; i < kCount; ++i) {
    const double error = faults_.told(truth(7.0), kMs).angular_velocity_rad_per_s.x() - 7.0;
    sum += error;
    squares += error * error;
  }
  const double sigma = 30.0 * robot_.noise.angular_velocity_rad_per_s;
  EXPECT_NEAR(sum / kCount, 0.0, 0.1 * sigma);
  EXPECT_NEAR(std::sqrt(squares / kCount), sigma, 0.1 * sigma);
}

TEST_F(SensorFaultsTest, WhatIsExchangedTellsWhatTheOtherSideReads) {
  PlantSensors now = truth(7.0);
  now.force_N[0].fill(1.0);
  now.encoder_count[static_cast<std::size_t>(robot_.joint_index("left_knee"))] = 100;
  now.angular_velocity_rad_per_s = {1.0, 2.0, 3.0};
  begin("right_foot", SensorFault::How::exchanged, 0.0);
  begin("right_knee", SensorFault::How::exchanged, 0.0);
  begin("imu", SensorFault::How::exchanged, 0.0);
  const PlantSensors told = faults_.told(now, kMs);
  EXPECT_EQ(told.force_N[0][2], 7.0);
  EXPECT_EQ(told.force_N[1][2], 1.0);
  EXPECT_EQ(told.encoder_count[static_cast<std::size_t>(robot_.joint_index("left_knee"))], 7);
  EXPECT_EQ(told.encoder_count[static_cast<std::size_t>(robot_.joint_index("right_knee"))], 100);
  EXPECT_EQ(told.angular_velocity_rad_per_s, Eigen::Vector3d(2.0, 1.0, 3.0));
}

TEST_F(SensorFaultsTest, ABiasedOneIsOffByTheSameEachTime) {
  begin("left_knee", SensorFault::How::biased, 0.0);
  begin("left_foot", SensorFault::How::biased, 0.0);
  begin("imu", SensorFault::How::biased, 0.0);
  const auto knee = static_cast<std::size_t>(robot_.joint_index("left_knee"));
  const PlantSensors told = faults_.told(truth(7.0), kMs);
  EXPECT_NEAR((told.encoder_count[knee] - 7) * robot_.joints[knee].encoder_count_rad, 0.02,
              robot_.joints[knee].encoder_count_rad);
  EXPECT_NEAR(told.force_N[0][1], 8.4, 1e-9);
  EXPECT_EQ(told.force_N[1][1], 7.0);
  EXPECT_NEAR(told.angular_velocity_rad_per_s.y(), 7.05, 1e-9);
  EXPECT_EQ(faults_.told(truth(7.0), 2 * kMs).encoder_count, told.encoder_count);
}

TEST_F(SensorFaultsTest, ANewFaultTakesTheOldOnesPlace) {
  begin("imu", SensorFault::How::reads_zero, 0.0);
  begin("imu", SensorFault::How::freezes, 0.0, 3.0);
  EXPECT_EQ(faults_.told(truth(7.0), kMs).inclination_rad.x(), 3.0);
}

}  // namespace
}  // namespace gaitway::simulator
