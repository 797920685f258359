// The inverse kinematics of any leg of six joints: Newton's iteration with a forward kinematics and Jacobian
// of its own.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "gaitway/kinematics/closed_form_leg.hpp"
#include "gaitway/kinematics/leg_solution.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {

// Inverse kinematics of any leg of six joints by Newton's iteration. Pure: no state, no allocation.
//
// Near the pose the full step is taken: the hip's three axes give three of the unknowns, so two systems of
// three equations are solved instead of one of six. A step so short that its error of second order is below
// the accuracy ends the iteration. Far from the pose, and where the leg is nearly straight or two hip axes
// are nearly parallel, the step is damped in proportion to the residual (T. Sugihara,
// "Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method", IEEE Trans. Robotics 27(5),
// 2011).
class GeneralLeg {
 public:
  // A posture counts as reached when position and orientation are this close.
  static constexpr double kAccuracy_m = 1e-11;
  static constexpr double kAccuracy_rad = 1e-11;

  // Throws urdf::RobotError if the leg's six joints are not the chain from the base to the foot.
  GeneralLeg(const urdf::RobotModel& model, urdf::Side side);

  // base_from_sole: pose of the sole frame in the base frame; rotation must be orthonormal. start_rad: a
  // posture near by, such as that of the sample before: the solution stays on its branch. If nothing is
  // reached from there, the iteration starts as without it.
  [[nodiscard]] LegSolution solve(const Eigen::Isometry3d& base_from_sole,
                                  const std::array<double, 6>& start_rad) const noexcept;

  // Starts from the posture of the leg of this size that has a closed form, then from home.
  [[nodiscard]] LegSolution solve(const Eigen::Isometry3d& base_from_sole) const noexcept;

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;

  // From a joint to the next one. A joint's own frame has z along its axis, and once it has turned, x at
  // right angles to the next axis, too.
  struct Link {
    double zero_rad = 0.0;  // turn about z at which the joint reads zero
    Eigen::Vector3d m =
        Eigen::Vector3d::Zero();              // to the next joint (the last one: to the sole), turned frame
    double twist_cos = 1.0, twist_sin = 0.0;  // from z to the next axis about x
  };
  struct Posture;  // where joints and sole are
  struct Error;    // of a posture against the goal
  struct NewtonStep;
  struct Attempt;

  [[nodiscard]] Posture forward(const Vector6& angle_rad) const noexcept;
  [[nodiscard]] Attempt iterate(const Eigen::Isometry3d& goal, Vector6 angle_rad) const noexcept;
  [[nodiscard]] LegSolution solution_from(const std::array<double, 6>& start_rad,
                                          const Eigen::Isometry3d& goal) const noexcept;

  std::array<Link, 6> links_;
  Eigen::Matrix3d first_frame_;  // of the first joint, before it turns; base frame
  Eigen::Vector3d first_joint_m_;
  Eigen::Matrix3d last_from_sole_;  // rotation
  double reach_m_ = 0.0;            // from the first joint to the sole, stretched
  std::array<double, 6> home_rad_{};
  LegLimits limits_;
  std::optional<ClosedFormLeg> nearest_;
};

}  // namespace gaitway::kinematics
