// What the motors of one leg must give for a planned motion: weight, inertia and the force of the ground.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {

// Where the joints and the masses of a leg are, in an inertial frame.
struct LegPlaces {
  std::array<Eigen::Vector3d, 6> joint_m;  // a point of each axis
  std::array<Eigen::Vector3d, 6> axis;     // unit
  std::array<Eigen::Vector3d, 6> com_m;    // of the link behind each joint
};

// The force of the ground on a foot, as one force at a point of the sole (no turning moment).
struct GroundForce {
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d point_m = Eigen::Vector3d::Zero();
};

// d'Alembert's principle for each joint: the moment about its axis of all that hangs behind it. Links count
// as points: their own inertia is far below that of their distance and of the rotors.
class LegLoad {
 public:
  LegLoad(const urdf::RobotModel& model, urdf::Side side);

  [[nodiscard]] LegPlaces places(const Eigen::Isometry3d& base,
                                 const std::array<double, 6>& angle_rad) const noexcept;

  // Motor torque of each joint, N*m. acceleration: of each link's CoM; joint speeds and accelerations as
  // planned.
  [[nodiscard]] std::array<double, 6> torque_Nm(const LegPlaces& places,
                                                const std::array<Eigen::Vector3d, 6>& acceleration_m_per_s2,
                                                const std::array<double, 6>& speed_rad_per_s,
                                                const std::array<double, 6>& acceleration_rad_per_s2,
                                                const GroundForce& ground) const noexcept;

 private:
  std::array<Eigen::Vector3d, 6> axis_;  // base frame, zero posture
  std::array<Eigen::Vector3d, 6>
      offset_m_;  // from the joint before to this joint; from the base's origin for the first
  std::array<Eigen::Vector3d, 6> com_m_;  // from the joint to its link's CoM
  std::array<double, 6> mass_kg_{};
  std::array<urdf::Motor, 6> motor_;
};

}  // namespace gaitway::kinematics
