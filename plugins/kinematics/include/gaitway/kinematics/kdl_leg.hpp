// The inverse kinematics of any leg of six joints on KDL: what the project's own solvers are compared with.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>

#include "gaitway/kinematics/leg_solution.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {

// Inverse kinematics of any leg of six joints: damped Newton iterations on KDL's forward kinematics and
// Jacobian.
// Starts from the previous solution, so that the samples of a motion take two or three iterations each and
// stay on one branch; the first sample, and one that does not converge or violates a limit, starts from home.
// Damping follows T. Sugihara, "Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt
// method", IEEE Trans. Robotics 27(5), 2011: proportional to the residual, hence quadratic convergence near
// the solution.
class KdlLeg {
 public:
  // A posture counts as reached when position and orientation are this close.
  static constexpr double kAccuracy_m = 1e-9;
  static constexpr double kAccuracy_rad = 1e-9;

  // Throws urdf::RobotError if the chain from the base to the foot has not exactly the leg's six joints.
  KdlLeg(const urdf::RobotModel& model, urdf::Side side);
  ~KdlLeg();
  KdlLeg(KdlLeg&&) noexcept;
  KdlLeg& operator=(KdlLeg&&) noexcept;

  // base_from_sole: pose of the sole frame in the base frame. No allocation.
  [[nodiscard]] LegSolution solve(const Eigen::Isometry3d& base_from_sole);

  // Where the next solve starts.
  void start_from(const std::array<double, 6>& angle_rad) noexcept;

 private:
  struct State;  // KDL's solvers refer to their chain, so they stay where they are
  std::unique_ptr<State> state_;
};

}  // namespace gaitway::kinematics
