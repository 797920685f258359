// The support polygon of flat feet on the ground, and how far inside it a point lies.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::tools {

// The four corners of a sole whose frame lies at (x, y, yaw) in the ground plane, counter-clockwise.
std::vector<Eigen::Vector2d> sole_corners(const urdf::Foot& foot, const Eigen::Vector3d& pose);

// Convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

// Distance of a point to the nearest edge of a convex, counter-clockwise polygon; negative outside.
double margin_m(std::span<const Eigen::Vector2d> polygon, const Eigen::Vector2d& point);

}  // namespace gaitway::tools
