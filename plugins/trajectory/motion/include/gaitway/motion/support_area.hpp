// The area between and under the soles that stand, within which the ZMP must stay.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "gaitway/motion/motion.hpp"

namespace gaitway::motion {

// A convex polygon on the ground; empty where nothing stands.
class SupportArea {
 public:
  SupportArea() = default;
  SupportArea(const urdf::RobotModel& robot, Contact contact, const std::array<Eigen::Isometry3d, 2>& sole);

  // Distance to the nearest edge; negative outside.
  [[nodiscard]] double margin_m(const Eigen::Vector2d& point) const noexcept;
  [[nodiscard]] const std::vector<Eigen::Vector2d>& corners() const noexcept { return corners_; }

 private:
  std::vector<Eigen::Vector2d> corners_;  // counter-clockwise
};

// Middle of the sole rectangle on the ground.
[[nodiscard]] Eigen::Vector2d sole_centre(const urdf::Foot& foot, const Eigen::Isometry3d& sole);

}  // namespace gaitway::motion
