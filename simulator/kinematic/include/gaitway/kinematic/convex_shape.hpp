// Convex bodies as their collision shapes have them, and how deep two of them are in one another.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematic {

// In its own frame, whose origin is the middle of its extent. A mesh is the hull of those of its points that
// lie furthest out in some hundred directions: within 1 % of its size.
class ConvexShape {
 public:
  // Reads the file of a mesh. Throws urdf::RobotError, which names it, when it cannot be read.
  explicit ConvexShape(const urdf::Shape& shape);

  // The point that lies furthest in that direction.
  [[nodiscard]] Eigen::Vector3d furthest_m(const Eigen::Vector3d& direction) const noexcept;
  [[nodiscard]] double radius_m() const noexcept { return radius_m_; }  // of a ball around the origin

 private:
  urdf::Shape::Kind kind_;
  Eigen::Vector3d half_m_;
  std::vector<Eigen::Vector3d> points_m_;  // of a mesh
  double radius_m_ = 0.0;
};

// Pose of a shape's own frame.
struct PlacedShape {
  const ConvexShape* shape;
  Eigen::Isometry3d pose;

  [[nodiscard]] Eigen::Vector3d furthest_m(const Eigen::Vector3d& direction) const noexcept {
    return pose * shape->furthest_m(pose.linear().transpose() * direction);
  }
};

// The least way by which one must be moved so that they only touch; 0: they are apart, or touch. E. G.
// Gilbert, D. W. Johnson, S. S. Keerthi, 1988 (apart or not); G. van den Bergen, "Proximity queries and
// penetration depth computation on 3D game objects", 2001 (how deep). Within 0.01 mm of flat bodies; round
// ones are approached by flat faces, and may be up to 5 % deeper in one another.
[[nodiscard]] double penetration_m(const PlacedShape& one, const PlacedShape& other);

}  // namespace gaitway::kinematic
