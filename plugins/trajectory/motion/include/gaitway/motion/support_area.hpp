// The area between and under the soles that stand, within which the ZMP must stay.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "gaitway/geometry/convex_hull.hpp"
#include "gaitway/motion/motion.hpp"

namespace gaitway::motion {

// On the ground; empty where nothing stands.
using SupportArea = geometry::ConvexHull<>;
[[nodiscard]] SupportArea support_area(const urdf::RobotModel& robot, Contact contact,
                                       const std::array<Eigen::Isometry3d, 2>& sole);

// Middle of the sole rectangle on the ground.
[[nodiscard]] Eigen::Vector2d sole_centre(const urdf::Foot& foot, const Eigen::Isometry3d& sole);

}  // namespace gaitway::motion
