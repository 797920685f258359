// Position and velocity of the centre of mass (CoM) along one axis, from the kinematics' CoM and a known
// acceleration.
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

}  // namespace gaitway::zmp
