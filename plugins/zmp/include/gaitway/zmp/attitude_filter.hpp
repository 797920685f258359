// Attitude of the trunk and the gyro's bias, each with its uncertainty: roll and pitch against gravity, yaw
// since the start.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "gaitway/zmp/estimator_parameters.hpp"

namespace gaitway::zmp {

struct Attitude {  // R = Rz(yaw) Ry(pitch) Rx(roll), trunk to world
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;  // continuous: not wrapped

  // Trunk to the level frame that shares its heading.
  [[nodiscard]] Eigen::Matrix3d tilt() const noexcept;
};

// Multiplicative extended Kalman filter (F. L. Markley, "Attitude error representations for Kalman
// filtering", J. Guidance, Control and Dynamics 26(2), 2003) on the turn of the attitude's error, in world
// axes, the gyro's bias, and, while the feet are planted, the heading in which they stand. That heading is
// what makes the bias about the vertical known: the legs' joints say how the trunk turns over feet that do
// not turn, whether it stands still or sways. The bias is a first-order Gauss-Markov process, so its
// uncertainty is bounded however long the robot runs.
class AttitudeFilter {
 public:
  explicit AttitudeFilter(const EstimatorParameters& parameters) noexcept;

  // gyro: mean over the last dt_s, in trunk axes. unheard_s: part of dt_s for which no sample came.
  void predict(const Eigen::Vector3d& gyro_rad_per_s, double dt_s, double unheard_s = 0.0) noexcept;
  // Measured roll and pitch, mean over the slot that the last predict() ended with. The first one is taken as
  // it is.
  void correct_tilt(const Eigen::Vector2d& roll_pitch_rad, double deviation_rad) noexcept;
  // The same from the mean specific force, in g and trunk axes: while the body is accelerated to and fro, its
  // mean points upwards and is 1 long, and so is what the filter makes of it. What each sample says alone
  // (its angles, or only those that are about 1 long) has another mean: a walk tilts it by 0.02 rad.
  void correct_by_force(const Eigen::Vector3d& force_g, double deviation_rad) noexcept;
  // The feet stand; the kinematics says how they are turned against the trunk's heading. From the second call
  // on it corrects. creep: random walk of the feet's heading, per square root of a second.
  void hold_heading(double feet_against_trunk_rad, double creep_rad_rts, double dt_s) noexcept;
  // The feet no longer stand as they did.
  void release_heading() noexcept;
  // After a gap: roll and pitch start anew at the next measured tilt, yaw stays.
  void lose_tilt() noexcept { has_tilt_ = false; }
  [[nodiscard]] bool has_tilt() const noexcept { return has_tilt_; }

  [[nodiscard]] const Attitude& attitude() const noexcept { return attitude_; }
  [[nodiscard]] const Eigen::Vector3d& bias_rad_per_s() const noexcept { return bias_; }
  // Of the last prediction, without bias, in trunk axes.
  [[nodiscard]] Eigen::Vector3d rate_rad_per_s() const noexcept { return gyro_ - bias_; }

  // Standard deviations: of roll, pitch and yaw, and of the bias in trunk axes.
  [[nodiscard]] Eigen::Vector3d attitude_deviation_rad() const noexcept;
  [[nodiscard]] Eigen::Vector3d bias_deviation_rad_per_s() const noexcept;

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.has_tilt_, self.attitude_, self.world_from_trunk_, self.bias_, self.gyro_,
            self.feet_heading_rad_, self.covariance_);
  }

 private:
  static constexpr int kTurn = 0, kBias = 3, kFeet = 6, kStates = 7;
  using Vector = Eigen::Matrix<double, kStates, 1>;
  using Matrix = Eigen::Matrix<double, kStates, kStates>;

  // A scalar measurement: residual = sensitivity . error + noise.
  void correct(const Vector& sensitivity, double residual, double variance) noexcept;
  void start_tilt(const Eigen::Vector2d& roll_pitch_rad, double deviation_rad) noexcept;
  void bound_yaw() noexcept;
  void read_angles() noexcept;

  double gyro_noise_, unheard_rate_rad_per_s_, bias_deviation_, bias_lifetime_s_, bias_walk_, heading_noise_;
  bool has_tilt_ = false;
  Attitude attitude_;
  Eigen::Matrix3d world_from_trunk_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d bias_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d gyro_ = Eigen::Vector3d::Zero();
  std::optional<double> feet_heading_rad_;  // in the world; none: the feet are not planted
  Matrix covariance_ = Matrix::Zero();
};

// Roll and pitch that a specific force means, if the trunk is not accelerated; nothing if its length is
// further than `band` from gravity's.
[[nodiscard]] std::optional<Eigen::Vector2d> tilt_of_acceleration(
    const Eigen::Vector3d& specific_force_m_per_s2, double band_m_per_s2) noexcept;

}  // namespace gaitway::zmp
