// The simulated IMU as such parts are: mounted askew, wrong in scale, axes and zero; its inclinometer is a
// damped pendulum, which hangs along apparent gravity and so feels every acceleration of the body.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "gaitway/facts/facts.hpp"
#include "gaitway/facts/random_stream.hpp"
#include "gaitway/simulator/plant.hpp"

namespace gaitway::simulator {

// What parts of one kind differ by, σ of each axis unless it says otherwise: of MEMS sensors in the class of
// the MPU-6050 after a calibration at the desk (its data sheet: gyro scale 3 %, cross-axis 2 %, 0.1 °/s a g;
// zero of the accelerometer 50 mg before).
struct ImuDeviations {
  double mounting_rad = 1.0 * facts::kRadPerDegree;  // the turn of the whole IMU, about a random axis; no σ
  double gyro_scale = 0.01;
  double gyro_axis_rad = 0.005;  // from each other axis
  double gyro_per_acceleration_s_per_m =
      0.1 * facts::kRadPerDegree / 9.81;                         // g-sensitivity: rad/s for 1 m/s²
  double gyro_walk_rad_per_s_rts = 0.01 * facts::kRadPerDegree;  // of the bias, in the root of a second
  double accelerometer_scale = 0.01;
  double accelerometer_axis_rad = 0.005;
  double accelerometer_zero_m_per_s2 = 0.05;
  double inclinometer_zero_rad = 0.2 * facts::kRadPerDegree;
  double inclinometer_cross_axis = 0.01;
};

// A pendulum of 8 Hz in oil: -3 dB at 8 Hz, 28 ms late. Faster ones ring, slower ones are blind to a walk.
struct InclinometerPendulum {
  double natural_frequency_rad_per_s = 50.0;
  double damping_ratio = 0.7;
};

class ImuModel {
 public:
  // deviations: scales what is drawn from the seed; 0 is a perfect part, whose inclinometer still hangs along
  // apparent gravity.
  ImuModel(std::uint64_t seed, double deviations, double step_s);

  // The IMU's own axes, in those that the description gives it.
  [[nodiscard]] const Eigen::Matrix3d& mounting() const noexcept { return truth_.mounting; }

  struct Reading {
    Eigen::Vector3d angular_velocity_rad_per_s, acceleration_m_per_s2;
    Eigen::Vector2d inclination_rad;
  };
  // One physics step later: what the sensors say, without noise, of the true turn rate and specific force in
  // the IMU's own axes (those of mounting()).
  [[nodiscard]] Reading step(const Eigen::Vector3d& turn_rad_per_s,
                             const Eigen::Vector3d& force_m_per_s2) noexcept;
  // The pendulum hangs still along this force.
  void settle(const Eigen::Vector3d& force_m_per_s2) noexcept;

  // Of what the walk of the bias has become by now.
  [[nodiscard]] const Eigen::Vector3d& walked_bias_rad_per_s() const noexcept { return walked_bias_; }
  [[nodiscard]] const ImuTruth& truth() const noexcept { return truth_; }

 private:
  facts::RandomStream walk_random_;
  double step_s_, walk_per_step_;
  InclinometerPendulum pendulum_;
  ImuTruth truth_;
  Eigen::Vector3d walked_bias_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d hangs_rad_ = Eigen::Vector2d::Zero(), swings_rad_per_s_ = Eigen::Vector2d::Zero();
};

}  // namespace gaitway::simulator
