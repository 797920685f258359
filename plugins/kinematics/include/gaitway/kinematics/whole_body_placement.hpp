// Where the whole body's centre of mass is, and where the base must be so that it is above the planned point.
//
// Frames: `plan` is the ground frame of the motion plan; `heading` is that frame turned by the base's yaw.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>

#include "gaitway/kinematics/leg_solver.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {

// Whole-body centre of mass as a function of the legs' joint angles alone; everything else is at home.
// First mass moment of one leg, nested from the foot up: s_i = R_i(q_i) (k_i + s_{i+1}) with constants k_i.
class LegMass {
 public:
  LegMass(const urdf::RobotModel& model, urdf::Side side);

  // Sum of mass times position over the leg's links, about the origin of the base frame; kg·m, base frame.
  [[nodiscard]] Eigen::Vector3d moment_kg_m(const std::array<double, 6>& angle_rad) const noexcept;
  [[nodiscard]] double mass_kg() const noexcept { return mass_kg_; }

 private:
  std::array<Eigen::Vector3d, 6> axis_;         // joint axes in the base frame, zero posture
  std::array<Eigen::Vector3d, 6> moment_kg_m_;  // k_i: the link and all below it, hung on the next joint
  Eigen::Vector3d root_moment_kg_m_;            // of the whole leg's mass at the first joint
  double mass_kg_ = 0.0;
};

class BodyMass {
 public:
  // Throws urdf::RobotError if a link that is no part of a leg hangs on one, or the masses are not positive.
  explicit BodyMass(const urdf::RobotModel& model);

  // Whole-body CoM in the base frame, m.
  [[nodiscard]] Eigen::Vector3d com_m(const std::array<double, 6>& left_rad,
                                      const std::array<double, 6>& right_rad) const noexcept;
  [[nodiscard]] double total_mass_kg() const noexcept { return total_mass_kg_; }

 private:
  std::array<LegMass, 2> legs_;  // [Side]
  Eigen::Vector3d rest_moment_kg_m_ = Eigen::Vector3d::Zero();
  double total_mass_kg_ = 0.0;
};

// Where the base must be so that the whole body's centre of mass is above the planned point, and the legs'
// angles.
//
// Frames: `plan` is the ground frame of the motion plan; `heading` is that frame turned by the base's yaw.
// One point of a motion plan. Feet are flat: z of the sole frames is up.
struct PlanPoint {
  Eigen::Vector2d com_m = Eigen::Vector2d::Zero();              // plan frame
  Eigen::Vector2d com_offset_m = Eigen::Vector2d::Zero();       // added to com, heading frame
  double hip_height_m = 0.0;                                    // of the middle between the hips
  double base_yaw_rad = 0.0;                                    // plan frame
  Eigen::Vector2d base_attitude_rad = Eigen::Vector2d::Zero();  // roll, pitch; R = Rz(yaw) Ry(pitch) Rx(roll)
  std::array<Eigen::Vector3d, 2> foot_m{Eigen::Vector3d::Zero(),
                                        Eigen::Vector3d::Zero()};  // [Side], plan frame
  std::array<double, 2> foot_yaw_rad{};                            // [Side], plan frame
  std::array<double, 2> toe_up_rad{};                              // [Side], of the sole against the ground
};

// What of a point does not depend on where the base is: orientations, and positions relative to the CoM.
struct PointFrames {
  Eigen::Matrix3d heading_from_base;
  double base_height_m = 0.0;
  std::array<Eigen::Vector3d, 2> foot_m;          // from the point on the ground below the CoM, heading frame
  std::array<Eigen::Matrix3d, 2> base_from_sole;  // rotations
};

using BothLegs = std::array<LegSolution, 2>;             // [Side]
using LegAngles = std::array<std::array<double, 6>, 2>;  // [Side], rad

class WholeBodyPlacement {
 public:
  // Throws urdf::RobotError if the model cannot be solved with this choice.
  WholeBodyPlacement(const urdf::RobotModel& model, SolverChoice choice);

  [[nodiscard]] PointFrames frames(const PlanPoint& point) const noexcept;

  // Legs for a base whose origin is `offset_m` (heading frame) beside the planned CoM. start_rad: a posture
  // near by, for legs that want one.
  [[nodiscard]] BothLegs place(const PointFrames& frames, const Eigen::Vector2d& offset_m,
                               const std::optional<LegAngles>& start_rad = std::nullopt);

  // Whole-body CoM minus planned CoM, heading frame, for what `place` returned; both legs must be reached.
  [[nodiscard]] Eigen::Vector2d com_error_m(const PointFrames& frames, const BothLegs& legs,
                                            const Eigen::Vector2d& offset_m) const noexcept;

  struct Result {
    BothLegs legs;
    Eigen::Vector2d offset_m;   // of the base with which the legs were solved
    Eigen::Vector2d refined_m;  // a better offset still: start of the next point
    bool converged = false;     // false if a leg is not reached, too
  };
  // Moves the base, from the guess on, until the CoM is within the tolerance of the planned point: Newton's
  // iteration with the sensitivity of the standing posture. One solution of the legs if the guess is good.
  [[nodiscard]] Result place_com(const PointFrames& frames, const Eigen::Vector2d& guess_m,
                                 double tolerance_m, std::optional<LegAngles> start_rad = std::nullopt);

  // Whether a posture near by saves time.
  [[nodiscard]] bool wants_start() const noexcept { return legs_[0].wants_start() || legs_[1].wants_start(); }

  // Offset of the base in the standing posture: a guess where there is no better one.
  [[nodiscard]] const Eigen::Vector2d& standing_offset_m() const noexcept { return standing_offset_m_; }

 private:
  void measure_sensitivity(const urdf::RobotModel& model);

  std::array<LegSolver, 2> legs_;
  BodyMass mass_;
  Eigen::Vector3d hip_middle_m_;                                // base frame
  Eigen::Matrix2d base_per_com_ = Eigen::Matrix2d::Identity();  // shift of the base per shift of the CoM
  Eigen::Vector2d standing_offset_m_ = Eigen::Vector2d::Zero();
};

}  // namespace gaitway::kinematics
