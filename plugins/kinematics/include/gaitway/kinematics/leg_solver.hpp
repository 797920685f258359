// The inverse kinematics of one leg: in closed form, by general iterations, and both behind one call.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <string>
#include <variant>

#include "gaitway/kinematics/leg_geometry.hpp"
#include "gaitway/kinematics/leg_solution.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {

// Inverse kinematics of one leg in closed form.
// Six joint angles from the pose of the sole. Pure: no state, no allocation.
//
// The ankle roll turns the hip into the plane in which the pitch joints move the leg; the distance from ankle
// to hip gives the knee, the direction the ankle pitch; what is left of the orientation are the hip's three
// angles (decomposed in the order of its joints). The method is Pieper's (intersecting axes at one end), as
// written down for humanoid legs in S. Kajita et al., Introduction to Humanoid Robotics, 2014, section 2.5.1,
// here with the URDF's zero posture and signs, a lateral offset of the leg, and a tilted ankle roll axis.
class ClosedFormLeg {
 public:
  explicit ClosedFormLeg(const LegGeometry& geometry) noexcept;

  // base_from_sole: pose of the sole frame in the base frame; rotation must be orthonormal.
  [[nodiscard]] LegSolution solve(const Eigen::Isometry3d& base_from_sole) const noexcept;

 private:
  // hip_above: +1 with the hip above the ankle as the foot sees it, -1 below, as in a deep squat on the toes.
  [[nodiscard]] LegSolution solve_branch(const Eigen::Isometry3d& base_from_sole,
                                         double hip_above) const noexcept;
  // distance_m: from ankle to hip in the leg's plane.
  [[nodiscard]] LegSolution out_of_reach(double distance_m) const noexcept;

  LegGeometry geometry_;
  double thigh_length_m_, shin_length_m_;
  double knee_zero_cos_, knee_zero_sin_;  // of the angle from thigh to shin in the zero posture, about y
};

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

enum class SolverChoice { automatic, closed_form, kdl };

// "auto", "closed_form" or "kdl"; anything else throws std::invalid_argument with these names.
[[nodiscard]] SolverChoice solver_choice(const std::string& name);

// Either of them, behind one call.
class LegSolver {
 public:
  // automatic: closed form where the leg has one. closed_form: throws urdf::RobotError with the reason if
  // not.
  LegSolver(const urdf::RobotModel& model, urdf::Side side, SolverChoice choice);

  [[nodiscard]] LegSolution solve(const Eigen::Isometry3d& base_from_sole) {
    if (const auto* closed_form = std::get_if<ClosedFormLeg>(&leg_))
      return closed_form->solve(base_from_sole);
    return std::get<KdlLeg>(leg_).solve(base_from_sole);
  }

  [[nodiscard]] bool closed_form() const noexcept { return std::holds_alternative<ClosedFormLeg>(leg_); }
  // Why an automatic choice fell on the general solver; else empty.
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }

 private:
  std::string reason_;
  std::variant<ClosedFormLeg, KdlLeg> leg_;
};

}  // namespace gaitway::kinematics
