// Whole-body centre of mass as a function of the legs' joint angles alone; everything else is at home.
#pragma once

#include <Eigen/Core>
#include <array>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {

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

}  // namespace gaitway::kinematics
