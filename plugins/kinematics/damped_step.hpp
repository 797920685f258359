// The damped Newton step of a leg of six joints, which both general solvers take.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace gaitway::kinematics {

inline constexpr int kLegIterationLimit = 60;

// jacobian: of the sole, position above rotation, as the errors that are to vanish. Any posture allows the
// step: damping in proportion to the residual (T. Sugihara, "Solvability-unconcerned inverse kinematics by
// the Levenberg-Marquardt method", IEEE Trans. Robotics 27(5), 2011).
inline Eigen::Matrix<double, 6, 1> damped_step(Eigen::Matrix<double, 6, 6> jacobian,
                                               const Eigen::Vector3d& position_m,
                                               const Eigen::Vector3d& rotation_rad) {
  constexpr double kStepLimit_rad = 0.5;
  constexpr double kSmallestDamping = 1e-12;
  constexpr double kLength_m =
      0.3;  // makes position and orientation errors comparable; any leg's order of size
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  jacobian.topRows<3>() /= kLength_m;
  Vector6 error;
  error << position_m / kLength_m, rotation_rad;
  Eigen::Matrix<double, 6, 6> normal = jacobian.transpose() * jacobian;
  normal.diagonal().array() += 0.5 * error.squaredNorm() + kSmallestDamping;
  const Vector6 step = normal.llt().solve(jacobian.transpose() * error);
  const double largest = step.cwiseAbs().maxCoeff();
  return largest > kStepLimit_rad ? Vector6(step * (kStepLimit_rad / largest)) : step;
}

}  // namespace gaitway::kinematics
