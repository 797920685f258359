// Freezes, zeros, noise, biases and mixed-up wires.
#include "gaitway/simulator/sensor_faults.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "gaitway/facts/facts.hpp"

namespace gaitway::simulator {
namespace {

constexpr double kNoiseTimes = 30.0;           // a noisy sensor has so much more of it
constexpr double kNoisyEncoder_counts = 20.0;  // standard deviation
// Of what is biased: as a knock or a warm afternoon does it.
constexpr double kBiasedEncoder_rad = 0.02;
constexpr double kBiasedGyro_rad_per_s = 0.05;
constexpr double kBiasedInclination_rad = 0.02;
constexpr double kBiasedAcceleration_m_per_s2 = 0.3;
constexpr double kBiasedCells = 0.2;  // of what they bear

}  // namespace

SensorFaults::SensorFaults(const urdf::RobotModel& robot, std::uint64_t seed)
    : robot_(robot), random_(seed ^ 0x5E45'0000'0000'0001ULL) {}

void SensorFaults::begin(const SensorFault& fault, const PlantSensors& now, std::int64_t now_ns) {
  std::erase_if(active_, [&fault](const Active& one) { return one.fault.sensor == fault.sensor; });
  const std::int64_t until_ns = fault.duration_s > 0.0
                                    ? now_ns + static_cast<std::int64_t>(std::llround(
                                                   fault.duration_s * static_cast<double>(facts::kSecond_ns)))
                                    : std::numeric_limits<std::int64_t>::max();
  active_.push_back({fault, until_ns, now});
}

const PlantSensors& SensorFaults::told(const PlantSensors& truth, std::int64_t now_ns) {
  std::erase_if(active_, [now_ns](const Active& one) { return now_ns >= one.until_ns; });
  if (active_.empty()) return truth;
  told_ = truth;
  for (const Active& one : active_) distort(one);
  return told_;
}

void SensorFaults::distort(const Active& active) {
  const std::string& sensor = active.fault.sensor;
  if (sensor == kImuSensor) {
    distort_imu(active);
  } else if (sensor == kFootSensors[0] || sensor == kFootSensors[1]) {
    distort_foot(active, sensor == kFootSensors[0] ? 0 : 1);
  } else {
    distort_encoder(active, static_cast<std::size_t>(robot_.joint_index(sensor)));
  }
}

void SensorFaults::distort_imu(const Active& active) {
  const urdf::SensorNoise& sigma = robot_.noise;
  switch (active.fault.how) {
    case SensorFault::How::freezes:
      told_.acceleration_m_per_s2 = active.frozen.acceleration_m_per_s2;
      told_.angular_velocity_rad_per_s = active.frozen.angular_velocity_rad_per_s;
      told_.inclination_rad = active.frozen.inclination_rad;
      break;
    case SensorFault::How::reads_zero:
      told_.acceleration_m_per_s2.setZero();
      told_.angular_velocity_rad_per_s.setZero();
      told_.inclination_rad.setZero();
      break;
    case SensorFault::How::noisy:
      for (double& value : told_.acceleration_m_per_s2) value += noise(sigma.acceleration_m_per_s2);
      for (double& value : told_.angular_velocity_rad_per_s) value += noise(sigma.angular_velocity_rad_per_s);
      for (double& value : told_.inclination_rad) value += noise(sigma.inclination_rad);
      break;
    case SensorFault::How::biased:
      told_.acceleration_m_per_s2.array() += kBiasedAcceleration_m_per_s2;
      told_.angular_velocity_rad_per_s.array() += kBiasedGyro_rad_per_s;
      told_.inclination_rad.array() += kBiasedInclination_rad;
      break;
    case SensorFault::How::exchanged:
      std::swap(told_.acceleration_m_per_s2.x(), told_.acceleration_m_per_s2.y());
      std::swap(told_.angular_velocity_rad_per_s.x(), told_.angular_velocity_rad_per_s.y());
      std::swap(told_.inclination_rad.x(), told_.inclination_rad.y());
      break;
  }
}

void SensorFaults::distort_foot(const Active& active, std::size_t foot) {
  switch (active.fault.how) {
    case SensorFault::How::freezes:
      told_.force_N[foot] = active.frozen.force_N[foot];
      told_.foot_wrench[foot] = active.frozen.foot_wrench[foot];
      break;
    case SensorFault::How::reads_zero:
      told_.force_N[foot] = {};
      told_.foot_wrench[foot].setZero();
      break;
    case SensorFault::How::noisy:
      for (double& force : told_.force_N[foot]) force += noise(robot_.noise.force_N);
      for (Eigen::Index i = 0; i < 6; ++i) {
        told_.foot_wrench[foot][i] += noise(i < 3 ? robot_.noise.force_N : robot_.noise.torque_Nm);
      }
      break;
    case SensorFault::How::biased:
      for (double& force : told_.force_N[foot]) force *= 1.0 + kBiasedCells;
      told_.foot_wrench[foot] *= 1.0 + kBiasedCells;
      break;
    case SensorFault::How::exchanged:
      std::swap(told_.force_N[0], told_.force_N[1]);
      std::swap(told_.foot_wrench[0], told_.foot_wrench[1]);
      break;
  }
}

void SensorFaults::distort_encoder(const Active& active, std::size_t joint) {
  switch (active.fault.how) {
    case SensorFault::How::freezes:
      told_.encoder_count[joint] = active.frozen.encoder_count[joint];
      break;
    case SensorFault::How::reads_zero:
      told_.encoder_count[joint] = 0;
      break;
    case SensorFault::How::noisy:
      told_.encoder_count[joint] +=
          static_cast<std::int32_t>(std::lround(kNoisyEncoder_counts * normal_(random_)));
      break;
    case SensorFault::How::biased:
      told_.encoder_count[joint] +=
          static_cast<std::int32_t>(std::lround(kBiasedEncoder_rad / robot_.joints[joint].encoder_count_rad));
      break;
    case SensorFault::How::exchanged:
      std::swap(told_.encoder_count[joint], told_.encoder_count[static_cast<std::size_t>(
                                                robot_.joint_index(counterpart_of(active.fault.sensor)))]);
      break;
  }
}

double SensorFaults::noise(double sigma) {
  return kNoiseTimes * sigma * normal_(random_);
}

}  // namespace gaitway::simulator
