// The inverse kinematics of a leg that has a closed form.
#pragma once

#include <Eigen/Geometry>

#include "gaitway/kinematics/leg_geometry.hpp"
#include "gaitway/kinematics/leg_solution.hpp"

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
  struct Knee {
    bool in_reach = false;
    double rad = 0.0;
    double ankle_to_hip_x = 0.0, ankle_to_hip_z = 0.0;  // as the shin sees it
  };
  struct Seen {
    Eigen::Matrix3d rotation;  // of the foot since the zero posture: R = Rz(yaw) Rx(roll) Ry(pitch sum) R6
    Eigen::Vector3d to_hip_m;  // from the ankle, as the foot sees it
  };
  [[nodiscard]] Seen seen_from(const Eigen::Isometry3d& base_from_sole) const noexcept;
  // Where the ankle pitches before it rolls, and where it rolls first.
  // hip_above: +1 with the hip above the ankle as the foot sees it, -1 below, as in a deep squat on the toes.
  [[nodiscard]] LegSolution solve_pitch_first(const Eigen::Isometry3d& base_from_sole,
                                              double hip_above) const noexcept;
  [[nodiscard]] LegSolution solve_roll_first(const Eigen::Isometry3d& base_from_sole,
                                             double hip_above) const noexcept;
  [[nodiscard]] Knee knee_at(double distance_squared) const noexcept;
  void set_hip(const Eigen::Matrix3d& hip, LegSolution& solution) const noexcept;
  // distance_m: from ankle to hip in the leg's plane.
  [[nodiscard]] LegSolution out_of_reach(double distance_m) const noexcept;

  LegGeometry geometry_;
  double thigh_length_m_, shin_length_m_;
  double knee_zero_cos_, knee_zero_sin_;  // of the angle from thigh to shin in the zero posture, about y
};

}  // namespace gaitway::kinematics
