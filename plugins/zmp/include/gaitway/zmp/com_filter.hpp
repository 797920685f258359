// Position and velocity of the centre of mass (CoM), and by how much the robot's description misplaces it.
#pragma once

#include <Eigen/Core>

#include "gaitway/zmp/estimator_parameters.hpp"

namespace gaitway::zmp {

// Kalman filter with a constant gain over the state position, velocity, unexplained acceleration. The
// prediction's acceleration is the linear inverted pendulum's, omega^2 (com - zmp), with the measured ZMP;
// what it does not explain (errors of the model's CoM, pushes) is the third state. After B. Stephens, "State
// estimation for force-controlled humanoid balance using simple models in the presence of modeling error",
// ICRA 2011; pendulum: S. Kajita et al., IROS 2001.
class ComFilter {
 public:
  // omega: of the pendulum for which the gain is computed; 0 for an axis whose acceleration does not depend
  // on its position (the vertical). dt: between two updates. The Riccati equation is iterated here until it
  // stands still.
  ComFilter(const EstimatorParameters& parameters, double omega_rad_per_s, double dt_s);

  void start(double position_m) noexcept { state_ = {position_m, 0.0, 0.0}; }
  // By one dt, with the known acceleration.
  void predict(double acceleration_m_per_s2) noexcept;
  void correct(double measured_position_m) noexcept;

  // The body has not moved, but where it is is known better.
  void shift(double by_m) noexcept { state_[0] += by_m; }

  [[nodiscard]] double position_m() const noexcept { return state_[0]; }
  [[nodiscard]] double velocity_m_per_s() const noexcept { return state_[1]; }
  [[nodiscard]] double unexplained_m_per_s2() const noexcept { return state_[2]; }
  void set_state(const Eigen::Vector3d& state) noexcept { state_ = state; }
  [[nodiscard]] const Eigen::Vector3d& state() const noexcept { return state_; }
  [[nodiscard]] const Eigen::Vector3d& gain() const noexcept { return gain_; }
  // After a correction, of the noise alone: position, and position + velocity / omega.
  [[nodiscard]] double position_variance() const noexcept { return covariance_(0, 0); }
  [[nodiscard]] double dcm_variance(double omega_rad_per_s) const noexcept {
    return covariance_(0, 0) + 2.0 * covariance_(0, 1) / omega_rad_per_s +
           covariance_(1, 1) / (omega_rad_per_s * omega_rad_per_s);
  }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.state_);
  }

 private:
  double dt_s_;
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Identity();  // at which the Riccati equation stands still
  Eigen::Vector3d gain_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d state_ = Eigen::Vector3d::Zero();
};

// By how much the description misplaces the CoM over a foot, learned from the forces.
// Joint zeros and masses that are not as described put the kinematics' CoM some millimetres off, and by much
// the same while the robot is over one foot. A pendulum whose CoM is misplaced by e accelerates by -omega^2 e
// more than it should: on average over steps, or standing still, what the pendulum does not explain is that
// offset. One scalar Kalman filter for each horizontal axis; what pushes and swinging limbs do is noise to
// it.
class ComOffset {
 public:
  // deviation_m: before anything is learned, each axis.
  ComOffset(const EstimatorParameters& parameters, const Eigen::Vector2d& deviation_m) noexcept;

  // unexplained: horizontal acceleration that the pendulum about the corrected CoM does not explain.
  // zmp_variance: of the measured ZMP, m^2, common to all samples.
  void update(const Eigen::Vector2d& unexplained_m_per_s2, double omega_rad_per_s,
              const Eigen::Vector2d& zmp_variance_m2, double dt_s) noexcept;

  // Of a shift that something learned of the kinematics (the trunk's attitude) gives its CoM: what is to be
  // believed. The rest is an error of the kinematics that the forces have told already, and becomes offset.
  [[nodiscard]] Eigen::Vector2d believed_of(const Eigen::Vector2d& shift_m) noexcept;

  // To be taken from the kinematics' CoM.
  [[nodiscard]] const Eigen::Vector2d& offset_m() const noexcept { return offset_; }
  [[nodiscard]] Eigen::Vector2d variance_m2() const noexcept { return variance_ + floor_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.offset_, self.variance_, self.floor_);
  }

 private:
  [[nodiscard]] Eigen::Vector2d bounded(const Eigen::Vector2d& offset_m) const noexcept;

  double noise_m_rts_, drift_m_per_rts_;
  Eigen::Vector2d prior_variance_;
  Eigen::Vector2d offset_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d variance_;
  Eigen::Vector2d floor_ = Eigen::Vector2d::Zero();  // what the forces themselves do not know
};

}  // namespace gaitway::zmp
